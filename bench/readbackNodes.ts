import { BackSide, BoxGeometry, Mesh, MeshBasicMaterial, Scene } from 'three';
import { CubeCollider } from 'three-cube-collider/webgpu';
import { float, Fn, Loop, screenCoordinate, uniform, vec4 } from 'three/tsl';
import { NodeMaterial, QuadMesh, WebGPURenderer } from 'three/webgpu';
import type { ReadbackResult } from './readback.js';

export interface NodeReadbackCase {
  mode: 'WebGPU' | 'fallback';
  /** GPU milliseconds of the page's own frame. */
  load: number;
  frames: number;
  /** The page alone. */
  bare?: boolean;
}

/** Of each backend, from one calibration. */
const millisecondsPerLoop: Record<string, number> = {};

/** `readback.ts`, on `WebGPURenderer`: a page whose frame costs as much, and a collider as shipped. */
export default async function readbackNodes({
  mode,
  load,
  frames,
  bare = false,
}: NodeReadbackCase): Promise<Omit<ReadbackResult, 'mode'> & NodeReadbackCase> {
  const renderer = new WebGPURenderer({ antialias: false, forceWebGL: mode === 'fallback' });
  // Small: what a software GPU takes to show a large picture would be most of the page.
  renderer.setSize(320, 180);
  document.body.replaceChildren(renderer.domElement);
  await renderer.init();
  const { isWebGPUBackend = false } = renderer.backend as { isWebGPUBackend?: boolean };
  if (isWebGPUBackend !== (mode === 'WebGPU')) throw new Error(`This is not ${mode}.`);
  const page = heavyPage();
  const draw = () => page.quad.render(renderer);
  millisecondsPerLoop[mode] ??= await calibrate(page.loops, draw, renderer);
  page.loops.value = Math.round(load / millisecondsPerLoop[mode]);

  const scene = new Scene();
  scene.add(new Mesh(new BoxGeometry(3, 3, 3), new MeshBasicMaterial({ side: BackSide })));
  // The reach never runs out: what is measured is the free read, not the forced one.
  const collider = new CubeCollider({ far: 3, slack: 100, maxAge: 1000 });
  await collider.compile(renderer, scene);
  await collider.updateAsync(renderer, scene);

  const blocked: number[] = [];
  const latency: number[] = [];
  const latencyFrames: number[] = [];
  const frame: number[] = [];
  let last = performance.now();
  let { reads } = collider.stats;
  await new Promise<void>((done) => {
    const tick = () => {
      const now = performance.now();
      frame.push(now - last);
      last = now;
      // Read before the update: it arrived between two frames.
      if (collider.stats.reads > reads) {
        reads = collider.stats.reads;
        blocked.push(collider.stats.lastBlocked);
        latency.push(collider.stats.latency);
        // It came between two frames, and serves the next.
        latencyFrames.push(collider.stats.latencyUpdates + 1);
      }
      if (!bare) collider.update(renderer, scene);
      draw();
      if (frame.length < frames) requestAnimationFrame(tick);
      else done();
    };
    requestAnimationFrame(tick);
  });
  frame.shift();
  const { forced } = collider.stats;
  const { width, height } = collider.renderTarget!;
  collider.dispose();
  renderer.dispose();
  const bytes = 16 * width * height;
  return { mode, load, frames, blocked, latency, latencyFrames, frame, forced, bytes };
}

/** A full-screen triangle whose fragments count to `loops`. */
function heavyPage() {
  const loops = uniform(1, 'int');
  const material = new NodeMaterial();
  material.fragmentNode = Fn(() => {
    const sum = float(0).toVar();
    Loop(loops, () => {
      sum.assign(sum.add(screenCoordinate.x.mul(0.01)).sin());
    });
    return vec4(sum);
  })();
  return { quad: new QuadMesh(material), loops };
}

/** GPU milliseconds of one loop over the canvas, from the difference of two long frames. */
async function calibrate(
  loops: { value: number },
  draw: () => void,
  renderer: WebGPURenderer,
): Promise<number> {
  const { device, gl } = renderer.backend as unknown as {
    device?: GPUDevice;
    gl?: WebGL2RenderingContext;
  };
  const time = async (count: number) => {
    loops.value = count;
    const times: number[] = [];
    for (let i = 0; i < 5; i++) {
      const start = performance.now();
      draw();
      if (device) await device.queue.onSubmittedWorkDone();
      else gl!.readPixels(0, 0, 1, 1, gl!.RGBA, gl!.UNSIGNED_BYTE, new Uint8Array(4));
      times.push(performance.now() - start);
    }
    return Math.min(...times);
  };
  await time(10);
  return Math.max(((await time(60)) - (await time(10))) / 50, 0.01);
}
