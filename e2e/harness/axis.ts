import { Scene } from 'three';
import { type AxisJudgement, judge, modelMaxima } from '../support/axisModel.js';
import { axisPoses, axisScenes } from '../support/axisScenes.js';
import { type Backend, createRendering } from '../support/rendering.js';

export interface AxisReport {
  scene: string;
  poses: number;
  /** Faces that saw something, over all poses. */
  seen: number;
  /** Faces that fail the plain comparison with the float64 model. */
  plainFailures: number;
  /** Faces that fail although the model allows for the rasteriser's grid. */
  failures: number;
  /** Largest difference of a face's maximum, in steps of the 8-bit red. */
  worstSteps: number;
  subpixelBits: number;
  bytesRead: number;
}

/** The paper's maxima from the GPU against the float64 model, in three scenes. */
export default async function axis({
  poses,
  seed,
  resolution = 32,
  backend,
}: {
  /** In each scene. */
  poses: number;
  seed: number;
  resolution?: number;
  backend?: Backend;
}): Promise<AxisReport[]> {
  const rMin = 0.175;
  const rMax = 0.35;
  const rendering = await createRendering(backend);
  const { renderer } = rendering;
  const collider = rendering.collider({ output: 'axis', rMin, rMax, resolution });
  const gl = rendering.backend === 'WebGL2' ? renderer.getContext() : null;
  // Dawn asks SwiftShader for 4 as well.
  const subpixelBits = gl === null ? 4 : (gl.getParameter(gl.SUBPIXEL_BITS) as number);
  let bytesRead = 0;
  if (gl !== null) {
    const { readPixels } = gl;
    gl.readPixels = ((...args: unknown[]) => {
      bytesRead = (args[6] as Uint8Array).byteLength;
      return (readPixels as (...all: unknown[]) => void).apply(gl, args);
    }) as typeof gl.readPixels;
  }

  const reports: AxisReport[] = [];
  for (const { name, root, triangles } of axisScenes()) {
    const scene = new Scene();
    scene.add(root);
    const report = { scene: name, poses, seen: 0, plainFailures: 0, failures: 0, worstSteps: 0 };
    for (const center of axisPoses(triangles, rMax, poses, seed)) {
      collider.position.copy(center);
      await rendering.see(collider, scene);
      const reading = collider.maxima!;
      let result: AxisJudgement = judge(
        reading,
        modelMaxima(triangles, center, rMin, rMax, resolution),
      );
      report.seen += result.seen;
      report.plainFailures += result.plainFailures;
      report.worstSteps = Math.max(report.worstSteps, 255 * result.worst);
      if (result.plainFailures === 0) continue;
      // A vertex is off by half a step of the grid at most, an edge cut by the near plane by another half.
      const snap = 0.5 ** subpixelBits;
      result = judge(reading, modelMaxima(triangles, center, rMin, rMax, resolution, snap));
      report.failures += result.failures;
    }
    reports.push({ ...report, subpixelBits, bytesRead });
  }
  collider.dispose();
  renderer.dispose();
  return reports;
}
