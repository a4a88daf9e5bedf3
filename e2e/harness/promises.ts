import {
  BackSide,
  BatchedMesh,
  Bone,
  BoxGeometry,
  BufferAttribute,
  Float32BufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  WebGLCubeRenderTarget,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';

const inside = new MeshBasicMaterial({ side: BackSide });
const outside = new MeshBasicMaterial();

/** What the middle of the face toward +X sees, metres, to the centimetre; null if nothing. */
function ahead(collider: CubeCollider): number | null {
  const { resolution: n, distance } = collider.field!;
  const seen = distance[(n / 2) * n + n / 2]!;
  return seen === Infinity ? null : Math.round(100 * seen) / 100;
}

function room(size = 4): Scene {
  return new Scene().add(new Mesh(new BoxGeometry(size, size, size), inside));
}

/** A box whose near side is a metre toward +X. */
function obstacle(): Mesh {
  const mesh = new Mesh(new BoxGeometry(), outside);
  mesh.position.x = 1.5;
  return mesh;
}

/** Resolves as `promise` does, or with 'never' if that takes five seconds. */
function soon<T>(promise: Promise<T>): Promise<T | 'never'> {
  return Promise.race([
    promise,
    new Promise<'never'>((resolve) => setTimeout(() => resolve('never'), 5000)),
  ]);
}

/** A box that a rule of three's own, not its matrix, puts a metre toward +X. */
const displaced = {
  instanced(): Object3D {
    const mesh = new InstancedMesh(new BoxGeometry(), outside, 1);
    mesh.setMatrixAt(0, new Matrix4().makeTranslation(1.5, 0, 0));
    return mesh;
  },
  batched(): Object3D {
    const geometry = new BoxGeometry();
    const mesh = new BatchedMesh(1, 24, 36, outside);
    mesh.setMatrixAt(
      mesh.addInstance(mesh.addGeometry(geometry)),
      new Matrix4().makeTranslation(1.5, 0, 0),
    );
    return mesh;
  },
  skinned(): Object3D {
    const geometry = new BoxGeometry();
    const { count } = geometry.attributes.position!;
    const weights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0));
    geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(4 * count), 4));
    geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
    const bone = new Bone();
    const mesh = new SkinnedMesh(geometry, outside);
    mesh.add(bone);
    mesh.bind(new Skeleton([bone]));
    bone.position.x = 1.5;
    return mesh;
  },
  morphed(): Object3D {
    const geometry = new BoxGeometry();
    const { count } = geometry.attributes.position!;
    const shift = Float32Array.from({ length: 3 * count }, (_, i) => (i % 3 === 0 ? 1.5 : 0));
    geometry.morphAttributes.position = [new BufferAttribute(shift, 3)];
    geometry.morphTargetsRelative = true;
    const mesh = new Mesh(geometry, outside);
    mesh.morphTargetInfluences![0] = 1;
    return mesh;
  },
};

const cases = {
  /** What is ahead, by every way of making an obstacle no obstacle. */
  rules() {
    const renderer = new WebGLRenderer();
    const ghost = obstacle();
    const scene = room().add(ghost);
    const collider = new CubeCollider({ far: 3, readback: 'sync' });
    const seen: Record<string, number | null> = {};
    const look = (name: string) => {
      collider.update(renderer, scene);
      seen[name] = ahead(collider);
    };
    look('plain');
    collider.filter = (object) => object !== ghost;
    look('filtered');
    collider.filter = null;
    collider.exclude(ghost);
    look('excluded');
    collider.include(ghost);
    look('included');
    ghost.layers.set(3);
    look('on another layer');
    collider.layers.enable(3);
    look('on a layer of the collider’s');
    collider.dispose();
    renderer.dispose();
    return seen;
  },

  /** What is ahead, of meshes that three's vertex shader moves. */
  displacements() {
    const renderer = new WebGLRenderer();
    const seen: Record<string, number | null> = {};
    for (const [name, make] of Object.entries(displaced)) {
      const collider = new CubeCollider({ far: 3, readback: 'sync' });
      const scene = new Scene().add(make());
      collider.update(renderer, scene);
      seen[name] = ahead(collider);
      collider.dispose();
    }
    renderer.dispose();
    return seen;
  },

  /** The longest distance seen in a room whose corners are out of reach, and texels that see nothing. */
  reach() {
    const renderer = new WebGLRenderer();
    const collider = new CubeCollider({ far: 2.5, readback: 'sync' });
    collider.update(renderer, room(4));
    const { distance, direction } = collider.field!;
    let farthest = 0;
    let wrong = 0;
    distance.forEach((seen, texel) => {
      const [x, y, z] = direction.subarray(3 * texel, 3 * texel + 3);
      const wall = 2 / Math.max(Math.abs(x!), Math.abs(y!), Math.abs(z!));
      if (Math.abs(wall - 2.5) > 0.001 && seen < Infinity !== wall < 2.5) wrong++;
      if (seen < Infinity) farthest = Math.max(farthest, seen);
    });
    collider.dispose();
    renderer.dispose();
    return { farthest, wrong };
  },

  /** State that a first update leaves otherwise than it was, of a renderer in the middle of something. */
  firstUpdate() {
    const renderer = new WebGLRenderer();
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const scene = room();
    renderer.render(scene, new PerspectiveCamera());
    renderer.xr.enabled = true;
    const cube = new WebGLCubeRenderTarget(16);
    const flat = new WebGLRenderTarget(16, 16);
    const state = () => ({
      xr: renderer.xr.enabled,
      target: renderer.getRenderTarget() as unknown,
      face: renderer.getActiveCubeFace(),
      mip: renderer.getActiveMipmapLevel(),
      scissor: gl.isEnabled(gl.SCISSOR_TEST),
      viewport: String(gl.getParameter(gl.VIEWPORT)),
      mask: String(gl.getParameter(gl.COLOR_WRITEMASK)),
      drawn: gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) as unknown,
      read: gl.getParameter(gl.READ_FRAMEBUFFER_BINDING) as unknown,
    });
    const changed: string[] = [];
    for (const bind of [
      () => renderer.setRenderTarget(cube, 3, 1),
      () => {
        renderer.setRenderTarget(flat);
        // Not yet the current one: three takes it at the next binding.
        flat.viewport.set(1, 2, 3, 4);
      },
      () => renderer.setRenderTarget(null),
    ]) {
      bind();
      renderer.state.setScissorTest(true);
      renderer.setScissorTest(true);
      const collider = new CubeCollider();
      const before: Record<string, unknown> = state();
      collider.update(renderer, scene);
      const after: Record<string, unknown> = state();
      for (const name in before) if (before[name] !== after[name]) changed.push(name);
      collider.dispose();
    }
    renderer.dispose();
    return changed;
  },

  /** What is ahead once the user has left the renderer's masks closed. */
  masks() {
    const renderer = new WebGLRenderer();
    const box = obstacle();
    const collider = new CubeCollider({ far: 3, readback: 'sync' });
    const { color, depth } = renderer.state.buffers;
    const seen: (number | null)[] = [];
    for (const scene of [room(), new Scene()]) {
      box.visible = true;
      collider.update(renderer, scene.add(box));
      box.visible = false;
      color.setMask(false);
      depth.setMask(false);
      collider.update(renderer, scene);
      seen.push(ahead(collider));
    }
    collider.dispose();
    renderer.dispose();
    return seen;
  },

  /** Whether the newest field stays whole while the next is written. */
  held() {
    const renderer = new WebGLRenderer();
    const scene = room();
    const collider = new CubeCollider({ far: 3, readback: 'sync' });
    collider.update(renderer, scene);
    const first = collider.field!;
    const { serial } = first;
    const before = first.distance.slice();
    collider.position.x = 0.5;
    collider.update(renderer, scene);
    const whole = before.every((distance, texel) => distance === first.distance[texel]);
    const report = {
      whole: whole && first.serial === serial && first.center.x === 0,
      next: ahead(collider),
    };
    collider.dispose();
    renderer.dispose();
    return report;
  },

  /** Reads that come in the order asked for, or not at all. */
  async inFlight() {
    const renderer = new WebGLRenderer();
    const scene = room();
    const collider = new CubeCollider({ far: 3, slack: 3, maxAge: 60 });
    await collider.compile(renderer, scene);
    const at = (x: number) => {
      collider.position.x = x;
      collider.update(renderer, scene);
    };
    at(0);
    at(0.1);
    at(0.2);
    const { skipped } = collider.stats;
    while (collider.stats.reads === 0) await new Promise((resolve) => setTimeout(resolve, 5));
    const newest = collider.field!.center.x;

    at(0.3);
    at(0.4);
    collider.position.x = 0.5;
    const { skipped: skippedAfter } = collider.stats;
    const asked = (await collider.updateAsync(renderer, scene))?.center.x;

    const lost = [];
    for (const interrupt of [() => collider.invalidate(), () => collider.dispose()]) {
      const pending = collider.updateAsync(renderer, scene);
      interrupt();
      lost.push(await soon(pending));
    }
    renderer.dispose();
    return { skipped: [skipped, skippedAfter], newest, asked, lost };
  },

  /** A read that is asked for, where the GPU passes its fence but never drains. */
  async urgent() {
    const renderer = new WebGLRenderer();
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const scene = room();
    const collider = new CubeCollider({ far: 3 });
    await collider.compile(renderer, scene);
    let updating = false;
    const own = new Set<WebGLSync | null>();
    const { fenceSync } = gl;
    gl.fenceSync = (condition, flags) => {
      const fence = fenceSync.call(gl, condition, flags);
      if (updating) own.add(fence);
      return fence!;
    };
    gl.clientWaitSync = (fence) =>
      own.has(fence) ? gl.ALREADY_SIGNALED : (gl.TIMEOUT_EXPIRED as number);
    updating = true;
    const pending = collider.updateAsync(renderer, scene);
    updating = false;
    const field = await soon(pending);
    collider.dispose();
    renderer.dispose();
    return field !== null && field !== 'never';
  },

  /** Programs that the first updates still had to make, what lay out of reach included; and whether it waits. */
  async compile(options: CubeColliderOptions) {
    const renderer = new WebGLRenderer();
    const scene = room();
    const far = displaced.instanced();
    far.position.x = 100;
    scene.add(far);
    const collider = new CubeCollider({ ...options, readback: 'sync' });
    const { compileAsync } = renderer;
    let go = () => {};
    let compiled = false;
    renderer.compileAsync = async (...args) => {
      const result = await compileAsync.apply(renderer, args);
      await new Promise<void>((resolve) => (go = resolve));
      return result;
    };
    const compiling = collider.compile(renderer, scene).then(() => (compiled = true));
    await new Promise((resolve) => setTimeout(resolve, 200));
    const waits = !compiled;
    go();
    await compiling;
    const before = renderer.info.programs!.length;
    far.position.x = 0;
    collider.update(renderer, scene);
    const made = renderer.info.programs!.length - before;
    collider.dispose();
    renderer.dispose();
    return { waits, before, made };
  },

  /** How far from their faces' middles the winners of six walls met head-on are, texels. */
  headOn() {
    const renderer = new WebGLRenderer();
    const collider = new CubeCollider({ output: 'axis', rMin: 0.1, rMax: 3 });
    // So far that 16 texels of each face have the same red in 8 bits.
    collider.update(renderer, room(2.01));
    const { texel } = collider.maxima!;
    const off = Math.max(...[...texel].map((at) => Math.abs(at + 0.5 - collider.resolution / 2)));
    collider.dispose();
    renderer.dispose();
    return off;
  },

  /** One collider on two renderers in turn. */
  renderers() {
    const renderers = [new WebGLRenderer(), new WebGLRenderer()] as const;
    const collider = new CubeCollider({ far: 3, readback: 'sync' });
    const seen: (number | null)[] = [];
    const scenes = [room(2), room(4)] as const;
    for (let i = 0; i < 4; i++) {
      collider.update(renderers[i % 2]!, scenes[i % 2]!);
      seen.push(ahead(collider));
    }
    collider.dispose();
    for (const renderer of renderers) renderer.dispose();
    return seen;
  },

  /** Listeners, buffers and fences that are left of a collider disposed of, and scenery that it still holds. */
  async leftovers(options: CubeColliderOptions) {
    const renderer = new WebGLRenderer();
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const canvas = renderer.domElement;
    const scene = room();
    const held = new WeakRef(scene.children[0]!);
    renderer.render(scene, new PerspectiveCamera());
    const live = { listeners: 0, buffers: 0, fences: 0 };
    const count = (object: object, name: string, kind: keyof typeof live, step: number) => {
      const original = Reflect.get(object, name) as (...args: unknown[]) => unknown;
      Reflect.set(object, name, (...args: unknown[]) => {
        if (args[0] !== null) live[kind] += step;
        return original.apply(object, args);
      });
    };
    count(canvas, 'addEventListener', 'listeners', 1);
    count(canvas, 'removeEventListener', 'listeners', -1);
    count(gl, 'createBuffer', 'buffers', 1);
    count(gl, 'deleteBuffer', 'buffers', -1);
    count(gl, 'fenceSync', 'fences', 1);
    count(gl, 'deleteSync', 'fences', -1);
    const collider = new CubeCollider(options);
    await collider.updateAsync(renderer, scene);
    for (let i = 0; i < 2; i++) collider.update(renderer, scene);
    const during = { ...live };
    collider.dispose();
    const after = { ...live };
    renderer.dispose();
    Object.assign(window, { held, collider });
    return { during, after };
  },
};

export type PromiseCases = typeof cases;

export default function promises({
  name,
  args,
}: {
  name: keyof PromiseCases;
  args?: unknown;
}): unknown {
  return (cases[name] as (args: unknown) => unknown)(args);
}
