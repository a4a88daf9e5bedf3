import {
  BackSide,
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import {
  CubeCollider,
  type CubeColliderOptions,
  type CubeColliderStats,
} from 'three-cube-collider';

export interface ReadbackReport {
  stats: CubeColliderStats;
  /** Most reads that were on their way at once, counted at the GL calls. */
  mostInFlight: number;
  /** Largest distance between a field's own centre and where the collider was at its draw. */
  stampError: number;
  /** Largest error of the distances straight down against the analytic room, metres. */
  worst: number;
  fields: number;
  /** Reads waited for in eight updates of one task without any field, and in three that each move by two metres. */
  forcedAtStart: number;
  forcedByMoving: number;
  /** Pixel-pack buffers made in all. */
  buffers: number;
}

/** Moves a collider through a room for some frames and judges each field that arrives by its own stamp. */
export default async function readbacks({
  frames,
  stride,
  options,
}: {
  frames: number;
  /** Metres a frame. */
  stride: number;
  options: CubeColliderOptions;
}): Promise<ReadbackReport> {
  const renderer = new WebGLRenderer();
  document.body.replaceChildren(renderer.domElement);
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const scene = new Scene();
  const room = new Mesh(new BoxGeometry(40, 2, 40), new MeshBasicMaterial({ side: BackSide }));
  scene.add(room);
  const camera = new PerspectiveCamera();
  const collider = new CubeCollider({ far: 3, ...options });

  const report = { mostInFlight: 0, stampError: 0, worst: 0, fields: 0, buffers: 0 };
  let started = 0;
  let startedBefore = 0;
  const { bindBuffer, readPixels } = gl;
  const packBuffers = new Set<WebGLBuffer | null>();
  gl.bindBuffer = (target, buffer) => {
    if (target === gl.PIXEL_PACK_BUFFER && buffer !== null) packBuffers.add(buffer);
    bindBuffer.call(gl, target, buffer);
  };
  gl.readPixels = ((...args: unknown[]) => {
    if (typeof args[6] === 'number') started++;
    return (readPixels as (...all: unknown[]) => void).apply(gl, args);
  }) as typeof gl.readPixels;

  const places = new Map<number, Vector3>();
  await collider.compile(renderer, scene);
  let last = -1;
  // Updates of one task: nothing can arrive between them, so the reach runs out and one read is waited for.
  for (let i = 0; i < 40; i++) collider.update(renderer, scene);
  const forcedAtStart = collider.stats.forced;
  for (let i = 0; i < 3; i++) {
    collider.position.x -= 2;
    collider.update(renderer, scene);
  }
  const forcedByMoving = collider.stats.forced - forcedAtStart;
  collider.invalidate();
  const drawnBefore = collider.stats.draws;
  startedBefore = started - drawnBefore;
  await new Promise<void>((done) => {
    let frame = 0;
    const tick = () => {
      judge();
      collider.position.set(stride * frame, 0.1 * Math.sin(frame), 0);
      const { draws } = collider.stats;
      const dropped = collider.stats.reads;
      collider.update(renderer, scene);
      if (collider.stats.draws > draws) places.set(collider.stats.draws, collider.position.clone());
      if (collider.stats.reads === dropped && collider.readback === 'async') {
        report.mostInFlight = Math.max(report.mostInFlight, inFlight());
      }
      renderer.render(scene, camera);
      if (++frame < frames) requestAnimationFrame(tick);
      else done();
    };
    requestAnimationFrame(tick);
  });
  judge();

  /** Draws since the newest field's own. */
  function inFlight() {
    return started - startedBefore - (collider.field?.serial ?? drawnBefore);
  }

  function judge() {
    const { field } = collider;
    if (field === null || field.serial === last) return;
    last = field.serial;
    report.fields++;
    report.stampError = Math.max(
      report.stampError,
      field.center.distanceTo(places.get(field.serial)!),
    );
    const n = field.resolution;
    for (let texel = 3 * n * n; texel < 4 * n * n; texel++) {
      const expected = (1 + field.center.y) / -field.direction[3 * texel + 1]!;
      if (expected > 2.9) continue;
      report.worst = Math.max(report.worst, Math.abs(field.distance[texel]! - expected));
    }
  }

  const { stats } = collider;
  collider.dispose();
  renderer.dispose();
  report.buffers = packBuffers.size;
  return { ...report, forcedAtStart, forcedByMoving, stats };
}
