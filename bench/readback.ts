import {
  BoxGeometry,
  Camera,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  WebGLRenderer,
  BackSide,
} from 'three';
import { CubeCollider } from 'three-cube-collider';
import { DrawStamp } from '../src/collider/DrawStamp.js';
import { ReadbackRing } from '../src/collider/ReadbackRing.js';

/**
 * How a cubemap gets to the processor. 'fenced' is what the product does better than; 'ask' reads nothing, but asks
 * WebGL for its clear colour, which the product therefore never does; 'none' is the page alone.
 */
export type ReadbackMode = 'sync' | 'fenced' | 'async' | 'ask' | 'none';

export interface ReadbackCase {
  mode: ReadbackMode;
  /** GPU milliseconds of the page's own frame. */
  load: number;
  frames: number;
}

export interface ReadbackResult extends ReadbackCase {
  /** Main-thread milliseconds of each read. */
  blocked: number[];
  /** Milliseconds from draw to arrival of each read. */
  latency: number[];
  /** Frames from each draw to the one that can use it: 0 in the same, which has waited for it. */
  latencyFrames: number[];
  /** Milliseconds from frame to frame. */
  frame: number[];
  forced: number;
  bytes: number;
}

/** Loads of one calibration, kept between cases. */
let millisecondsPerLoop = 0;

/** Runs one case: a page that draws a frame of a given cost and a collider that reads 32² faces of floats. */
export default async function readback({
  mode,
  load,
  frames,
}: ReadbackCase): Promise<ReadbackResult> {
  const renderer = new WebGLRenderer({ antialias: false });
  // Small: what a software GPU takes to show a large picture would be most of the page.
  renderer.setSize(320, 180);
  document.body.replaceChildren(renderer.domElement);
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const page = heavyPage();
  const draw = () => renderer.render(page.mesh, page.camera);
  if (millisecondsPerLoop === 0) millisecondsPerLoop = calibrate(page.loops, draw, gl);
  page.loops.value = Math.round(load / millisecondsPerLoop);

  const scene = new Scene();
  scene.add(new Mesh(new BoxGeometry(3, 3, 3), new MeshBasicMaterial({ side: BackSide })));
  // The reach never runs out in 'async': what is measured is the free read, not the forced one.
  const collider = new CubeCollider({
    readback: mode === 'async' ? 'async' : 'sync',
    far: 3,
    format: 'RGBA32F',
    slack: 100,
    maxAge: 1000,
  });
  collider.update(renderer, scene);
  await collider.compile(renderer, scene);

  const result: ReadbackResult = {
    mode,
    load,
    frames,
    blocked: [],
    latency: [],
    latencyFrames: [],
    frame: [],
    forced: 0,
    bytes: 0,
  };
  const target = collider.renderTarget!;
  const ring = new ReadbackRing(gl, target.width, target.height, true);
  const drawn = new DrawStamp();
  result.bytes = ring.data.byteLength;
  let last = performance.now();
  let { reads, forced } = collider.stats;

  await new Promise<void>((done) => {
    const tick = () => {
      const now = performance.now();
      result.frame.push(now - last);
      last = now;
      if (mode === 'fenced') {
        if (ring.fenced) {
          const start = performance.now();
          const stamp = ring.finish()!;
          result.blocked.push(performance.now() - start);
          result.latency.push(performance.now() - stamp.time);
          result.latencyFrames.push(result.frame.length - stamp.update);
        }
        if (ring.free) {
          renderer.setRenderTarget(target);
          renderer.clear();
          drawn.time = performance.now();
          drawn.serial = drawn.update = result.frame.length;
          ring.start(drawn);
          renderer.setRenderTarget(null);
        }
      } else if (mode === 'ask') {
        const start = performance.now();
        gl.getParameter(gl.COLOR_CLEAR_VALUE);
        result.blocked.push(performance.now() - start);
      } else if (mode !== 'none') {
        // Read before the update: an asynchronous one arrived between two frames.
        if (mode === 'sync') collider.update(renderer, scene);
        if (collider.stats.reads > reads) {
          reads = collider.stats.reads;
          result.blocked.push(collider.stats.lastBlocked);
          result.latency.push(collider.stats.latency);
          // What came between two frames serves the next.
          const waited = mode === 'sync' || collider.stats.forced > forced;
          result.latencyFrames.push(collider.stats.latencyUpdates + (waited ? 0 : 1));
          forced = collider.stats.forced;
        }
        if (mode === 'async') collider.update(renderer, scene);
      }
      draw();
      if (result.frame.length < frames) requestAnimationFrame(tick);
      else done();
    };
    requestAnimationFrame(tick);
  });
  result.forced = collider.stats.forced;
  result.frame.shift();
  ring.dispose();
  collider.dispose();
  renderer.dispose();
  renderer.forceContextLoss();
  return result;
}

/** A full-screen triangle whose fragments count to `loops`. */
function heavyPage() {
  const loops = { value: 1 };
  const material = new ShaderMaterial({
    uniforms: { loops },
    vertexShader: 'void main() { gl_Position = vec4( position.xy * 2.0, 0.0, 1.0 ); }',
    fragmentShader: `uniform int loops;
      void main() {
        float s = 0.0;
        for ( int i = 0; i < loops; i ++ ) s = sin( s + gl_FragCoord.x * 0.01 );
        gl_FragColor = vec4( s );
      }`,
  });
  const mesh = new Mesh(new PlaneGeometry(), material);
  mesh.frustumCulled = false;
  return { mesh, camera: new Camera(), loops };
}

/** GPU milliseconds of one loop over the canvas, from the difference of two long frames. */
function calibrate(loops: { value: number }, draw: () => void, gl: WebGL2RenderingContext): number {
  const texel = new Uint8Array(4);
  const time = (count: number) => {
    loops.value = count;
    const times = Array.from({ length: 5 }, () => {
      const start = performance.now();
      draw();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, texel);
      return performance.now() - start;
    });
    return Math.min(...times);
  };
  time(10);
  return Math.max((time(60) - time(10)) / 50, 0.01);
}
