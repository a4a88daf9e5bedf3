import { readFile } from 'node:fs/promises';
import { type AnimationClip, type Group, SkinnedMesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** The demo's avatar, loaded as the demo does. */
export interface Figure {
  root: Group;
  clips: AnimationClip[];
  clip(name: string): AnimationClip;
  triangles: number;
}

export async function loadFigure(): Promise<Figure> {
  const bytes = await readFile('public/avatar.glb');
  const { scene, animations } = await new GLTFLoader().parseAsync(new Uint8Array(bytes).buffer, '');
  const meshes = meshesOf(scene);
  return {
    root: scene,
    clips: animations,
    clip: (name) => animations.find((clip) => clip.name === name)!,
    triangles: meshes.reduce((sum, { geometry }) => sum + geometry.index!.count / 3, 0),
  };
}

export function meshesOf(root: Group): SkinnedMesh[] {
  const found: SkinnedMesh[] = [];
  root.traverse((object) => {
    if (object instanceof SkinnedMesh) found.push(object);
  });
  return found;
}

/**
 * Where vertices are now, skinned: x, y, z of one after another, metres.
 *
 * @param below only those that are lower than this while the figure stands at rest
 */
export function verticesOf(root: Group, below = Infinity): number[] {
  root.updateMatrixWorld(true);
  const point = new Vector3();
  const found: number[] = [];
  for (const mesh of meshesOf(root)) {
    const { position } = mesh.geometry.attributes;
    for (let i = 0; i < position!.count; i++) {
      if (position!.getY(i) >= below) continue;
      mesh.getVertexPosition(i, point).applyMatrix4(mesh.matrixWorld);
      found.push(point.x, point.y, point.z);
    }
  }
  return found;
}

/** Lower than this a vertex touches the ground, metres. */
const TOUCHES = 0.002;

/**
 * How fast what touches the ground, in one frame and in those before and after it, slides over it, as a part of the
 * ground's speed.
 *
 * @param pose puts the figure where it is at a time, seconds
 * @param speed at which the ground goes back, m/s
 * @param duration to look for, seconds
 * @returns the worst vertex, and in which part of the frames there is one
 */
export function slide(
  root: Group,
  pose: (time: number) => void,
  speed: number,
  duration: number,
): { worst: number; touching: number } {
  const delta = 1 / 120;
  const frames = Math.floor(duration / delta);
  const seen = Array.from({ length: frames + 1 }, (_, i) => {
    pose(i * delta);
    return verticesOf(root, 0.06);
  });
  let worst = 0;
  let touching = 0;
  for (let frame = 1; frame < frames; frame++) {
    const three = seen.slice(frame - 1, frame + 2);
    const [before, , after] = three;
    let down = false;
    for (let i = 0; i < before!.length; i += 3) {
      if (three.some((vertices) => vertices[i + 1]! > TOUCHES)) continue;
      down = true;
      const aside = (after![i]! - before![i]!) / (2 * delta);
      const along = (after![i + 2]! - before![i + 2]!) / (2 * delta) + speed;
      worst = Math.max(worst, Math.hypot(aside, along) / speed);
    }
    if (down) touching++;
  }
  return { worst, touching: touching / (frames - 1) };
}
