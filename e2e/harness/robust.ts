import {
  BackSide,
  BoxGeometry,
  DoubleSide,
  FrontSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  type Side,
  Vector3,
  WebGLRenderer,
} from 'three';
import {
  AxisResponse,
  CharacterController,
  CubeCollider,
  type CubeColliderOptions,
} from 'three-cube-collider';

/** Distance and facing of what the middle of a face sees. */
function middle(collider: CubeCollider, face: number) {
  const field = collider.field!;
  const n = field.resolution;
  const texel = (face * n + n / 2) * n + n / 2;
  return { distance: field.distance[texel]!, front: field.front[texel] };
}

function room(side: Side = BackSide, size = 4): Scene {
  const scene = new Scene();
  scene.add(new Mesh(new BoxGeometry(size, size, size), new MeshBasicMaterial({ side })));
  return scene;
}

/** Runs `act` with the console's warnings caught. */
async function warningsOf(act: () => void | Promise<void>): Promise<string[]> {
  const warnings: string[] = [];
  const { warn } = console;
  console.warn = (...words: unknown[]) => warnings.push(words.join(' '));
  try {
    await act();
  } finally {
    console.warn = warn;
  }
  return warnings.filter((warning) => !warning.includes('KHR_parallel_shader_compile'));
}

const cases = {
  /** Contexts that live on once collider and renderer are disposed of, the garbage collected by the caller. */
  async makeContexts({ count, options }: { count: number; options: CubeColliderOptions }) {
    const canvases: WeakRef<HTMLCanvasElement>[] = [];
    for (let i = 0; i < count; i++) {
      const renderer = new WebGLRenderer();
      const collider = new CubeCollider(options);
      await collider.updateAsync(renderer, room());
      collider.update(renderer, room());
      canvases.push(new WeakRef(renderer.domElement));
      collider.dispose();
      renderer.dispose();
    }
    Object.assign(window, { canvases });
  },

  /** A user's own pending error must neither cost the texel format nor be swallowed. */
  async pendingError() {
    const renderer = new WebGLRenderer();
    const gl = renderer.getContext();
    gl.enable(0);
    const collider = new CubeCollider({ far: 3 });
    await collider.updateAsync(renderer, room());
    return { format: collider.format, error: gl.getError(), invalid: gl.INVALID_ENUM };
  },

  /** A page whose GPU never drains: asynchronous reads that never come by themselves. */
  async neverDrained({
    stride,
    updates,
    patient = false,
  }: {
    stride: number;
    updates: number;
    patient?: boolean;
  }) {
    const renderer = new WebGLRenderer();
    const gl = renderer.getContext() as WebGL2RenderingContext;
    gl.clientWaitSync = () => gl.TIMEOUT_EXPIRED;
    // A clock of its own, 16 ms an update: nothing here depends on the machine's speed.
    const { now } = performance;
    let clock = 0;
    performance.now = () => clock;
    const scene = room(BackSide, 40);
    const collider = new CubeCollider({ far: 2, slack: 0.45, maxAge: 0.2 });
    let farthest = 0;
    let oldest = 0;
    for (let i = 0; i < updates; i++) {
      clock += 16;
      collider.position.x = stride * i;
      collider.update(renderer, scene, patient);
      if (collider.field !== null) {
        farthest = Math.max(farthest, collider.field.center.distanceTo(collider.position));
        oldest = Math.max(oldest, performance.now() - collider.field.time);
      }
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
    performance.now = now;
    const { forced, reads } = collider.stats;
    collider.dispose();
    return { farthest, oldest, forced, reads };
  },

  /** The same page, and a character that runs up gentle steps in it, ten frames a second. */
  async stairsNeverDrained() {
    const renderer = new WebGLRenderer();
    const gl = renderer.getContext() as WebGL2RenderingContext;
    gl.clientWaitSync = () => gl.TIMEOUT_EXPIRED;
    const { now } = performance;
    let clock = 0;
    performance.now = () => clock;
    const scene = new Scene();
    for (let i = 0; i <= 8; i++) {
      const step = new Mesh(new BoxGeometry(i === 0 ? 4 : 40 - 0.4 * i, 1, 4));
      step.position.set(i === 0 ? -1.5 : 20 + 0.2 * i, 0.06 * i - 0.5, 0);
      scene.add(step);
    }
    const character = new CharacterController<WebGLRenderer, Scene>(new CubeCollider());
    character.teleport(new Vector3(-2, 0.05, 0));
    character.walk(new Vector3(6, 0, 0));
    const ways: number[] = [];
    for (let i = 0; i < 120; i++) {
      clock += 100;
      character.update(renderer, scene, 0.1);
      ways.push(character.body.position.x);
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
    performance.now = now;
    character.dispose();
    renderer.dispose();
    const longest = ways.reduce(
      ([most, still], x, i) => {
        const stands = i > 40 && x - ways[i - 1]! < 1e-3 ? still + 1 : 0;
        return [Math.max(most!, stands), stands];
      },
      [0, 0],
    )[0]!;
    return { x: ways.at(-1)!, y: character.body.position.y, longest };
  },

  /** Whether a texel's surface is told to be a front, by the material's side, from inside and outside a box. */
  async sides() {
    const renderer = new WebGLRenderer();
    const told: Record<string, string> = {};
    for (const sides of ['both', 'drawn'] as const) {
      const collider = new CubeCollider({ sides, far: 9, readback: 'sync' });
      for (const [name, side] of Object.entries({ FrontSide, BackSide, DoubleSide })) {
        for (const [place, x] of [
          ['inside', 0],
          ['outside', 4],
        ] as const) {
          collider.position.x = x;
          collider.update(renderer, room(side, 2));
          const { distance, front } = middle(collider, 1);
          told[`${sides} ${name} ${place}`] =
            distance === Infinity
              ? 'nothing'
              : `${front ? 'front' : 'back'} at ${distance.toFixed(1)}`;
        }
      }
      collider.dispose();
    }
    return told;
  },

  /** A box of six materials of which one is glass, one hidden and one missing. */
  async groups() {
    const renderer = new WebGLRenderer();
    const solid = () => new MeshBasicMaterial({ side: BackSide });
    const glass = Object.assign(solid(), { transparent: true, opacity: 0.3 });
    const hidden = Object.assign(solid(), { visible: false });
    const box = new Mesh(new BoxGeometry(2, 2, 2), [
      solid(),
      glass,
      hidden,
      solid(),
      solid(),
      solid(),
    ]);
    delete (box.material as unknown[])[4];
    const scene = new Scene().add(box);
    const collider = new CubeCollider({ far: 3, readback: 'sync' });
    await collider.compile(renderer, scene);
    collider.update(renderer, scene);
    return Array.from({ length: 6 }, (_, face) => middle(collider, face).distance !== Infinity);
  },

  /** A component unmounted while it prepares, as React's StrictMode does. */
  async disposeDuringCompile() {
    const renderer = new WebGLRenderer();
    const scene = room();
    const collider = new CubeCollider({ output: 'axis' });
    const compiling = collider.compile(renderer, scene);
    collider.dispose();
    await compiling;
    renderer.render(scene, new PerspectiveCamera());
    return true;
  },

  /** What must warn once and never throw. */
  async misuse() {
    const renderer = new WebGLRenderer();
    const scene = room();
    const notWebGL = { isWebGPURenderer: true, getContext: () => null };
    const collider = new CubeCollider({ far: 3, readback: 'sync', filter: () => JSON.parse('{') });
    const warnings = await warningsOf(() => {
      for (let i = 0; i < 3; i++) {
        collider.update(notWebGL as never, scene);
        collider.update(renderer, scene);
      }
    });
    return { warnings, seen: middle(collider, 0).distance };
  },

  /** The paper's maxima at some places, read at once and read late. */
  async axisLate() {
    const renderer = new WebGLRenderer();
    const scene = room(BackSide, 2);
    const read = async (readback: 'sync' | 'async') => {
      const collider = new CubeCollider({ output: 'axis', rMax: 0.9, rMin: 0.1, readback });
      const all: unknown[] = [];
      for (let i = 0; i < 5; i++) {
        collider.position.set(0.1 * i, -0.15 * i, 0.05 * i);
        await collider.updateAsync(renderer, scene);
        const { center, red, texel } = collider.maxima!;
        all.push([center.toArray(), [...red], [...texel]]);
      }
      collider.dispose();
      return all;
    };
    return { sync: await read('sync'), async: await read('async') };
  },

  /** A format forced on a context that cannot draw it. */
  async forcedFormat() {
    const renderer = new WebGLRenderer();
    const gl = renderer.getContext();
    const { getExtension } = gl;
    gl.getExtension = ((name: string) =>
      name.includes('color_buffer') ? null : getExtension.call(gl, name as never)) as never;
    const collider = new CubeCollider({ far: 3, format: 'RGBA32F', readback: 'sync' });
    const warnings = await warningsOf(() => {
      for (let i = 0; i < 3; i++) collider.update(renderer, room());
    });
    return { warnings, format: collider.format, seen: middle(collider, 0).distance };
  },

  /** Reads asked for far apart: none may be waited for. */
  async askedFarApart() {
    const renderer = new WebGLRenderer();
    const scene = room(BackSide, 40);
    const collider = new CubeCollider({ far: 2, slack: 0.1 });
    const errors: number[] = [];
    for (let i = 0; i < 4; i++) {
      collider.position.x = 3 * i;
      const field = await collider.updateAsync(renderer, scene);
      errors.push(field!.center.distanceTo(collider.position));
    }
    return { errors, forced: collider.stats.forced };
  },

  /** A bad call must not lose a good read on its way. */
  async badCallBetween() {
    const renderer = new WebGLRenderer();
    const scene = room();
    const collider = new CubeCollider({ far: 3 });
    const good = collider.updateAsync(renderer, scene);
    const bad = await collider.updateAsync(undefined as never, scene);
    return { bad, good: (await good) !== null, field: collider.field !== null };
  },

  /** A character whose collider can never vouch for it says why. */
  async neverReady() {
    const renderer = new WebGLRenderer();
    const scene = room(BackSide, 40);
    const parent = new Group();
    parent.position.set(0, 9, 0);
    const moved = new CubeCollider({ readback: 'sync' });
    parent.add(moved);
    const counts: number[] = [];
    const axis = { response: new AxisResponse() };
    for (const [collider, options] of [
      // The paper's spheres want finer texels than surfels do.
      [new CubeCollider({ resolution: 5, readback: 'sync' }), axis],
      [new CubeCollider({ far: 0.3, readback: 'sync' }), {}],
      [moved, {}],
    ] as const) {
      const character = new CharacterController(collider, options);
      character.teleport(new Vector3(0, 1, 0));
      const warnings = await warningsOf(() => {
        for (let i = 0; i < 150; i++) character.update(renderer, scene, 1 / 60);
      });
      counts.push(warnings.length);
    }
    return counts;
  },
};

export type RobustCases = typeof cases;

export default function robust({
  name,
  args,
}: {
  name: keyof RobustCases;
  args?: unknown;
}): unknown {
  return (cases[name] as (args: unknown) => unknown)(args);
}
