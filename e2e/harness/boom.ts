import { DoubleSide, Mesh, MeshBasicMaterial, PerspectiveCamera, Raycaster, Vector3 } from 'three';
import { type Boom, CameraBoom, CharacterController, CharacterControls } from 'three-cube-collider';
import { acceleratedRaycast, MeshBVH } from 'three-mesh-bvh';
import { loadWalkLevel } from '../../bench/walk/level.js';
import { type Backend, createRendering } from '../support/rendering.js';

export interface BoomCase {
  backend?: Backend;
  /** Frames a second that the character is told. */
  hz?: number;
  /** Most frames, all places together. */
  frames?: number;
}

export interface BoomReport {
  frames: number;
  /** Frames in which something stood between the head and the camera. */
  hidden: string[];
  /** Frames in which something stood between the head and a corner of the near plane. */
  cut: string[];
  /** Metres from the head to the camera, frame by frame. */
  lengths: number[];
  /** Cubemaps drawn for the boom, and milliseconds that its reads blocked. */
  draws: number;
  blocked: number;
  /** Mean main-thread time a frame, milliseconds: the question, and the update with the draws in it. */
  reach: number;
  update: number;
  walked: number;
  /** Of what a ray along the boom had free, how much was given, 0 to 1: mean of all frames. */
  given: number;
}

/** Ways through the level, x and z each: through door, corridor, columns; below the bridge and the arch; along walls. */
const WAYS: { from: [number, number, number]; to: [number, number][] }[] = [
  {
    from: [-4.5, 0.05, 4],
    to: [
      [-16.5, 4],
      [-16.5, 1],
      [-22, 0.8],
      [-23.6, 4],
      [-28, 4.4],
    ],
  },
  {
    from: [0, 0.5, -12.6],
    to: [
      [2.5, -13.3],
      [-2.5, -13.3],
      [-3, -10],
    ],
  },
  {
    from: [-10, 0.05, 12],
    to: [
      [-10, 17.5],
      [-12, 15.2],
    ],
  },
  {
    from: [-13.2, 3.02, -11],
    to: [
      [-11, -11.6],
      [-13.2, -11],
    ],
  },
];

/** A character walks through the level, the camera behind it turning all the while; three's Raycaster is the judge. */
export default async function boom({
  backend = 'WebGL2',
  hz = 30,
  frames = 240,
}: BoomCase): Promise<BoomReport> {
  const level = await loadWalkLevel('/level.glb');
  const { renderer, collider, see } = await createRendering(backend);
  renderer.setSize(64, 64);
  const body = collider();
  const character = new CharacterController<typeof renderer, typeof level.scene>(body);
  const camera = new PerspectiveCamera(70, 16 / 9, 0.05, 100);
  const eye = collider({ resolution: 16 });
  const made = new CameraBoom<typeof renderer, typeof level.scene>(eye);
  /** What the boom was asked and said last. */
  const asked = { pivot: new Vector3(), direction: new Vector3(), distance: 0, free: 0 };
  const overheard: Boom = {
    reach(pivot, direction, distance, radius) {
      const free = made.reach(pivot, direction, distance, radius);
      asked.pivot.copy(pivot);
      asked.direction.copy(direction);
      return Object.assign(asked, { distance, free }).free;
    },
  };
  const controls = new CharacterControls(character, camera, null, {
    view: 'third',
    boom: overheard,
  });
  level.geometry.boundsTree = new MeshBVH(level.geometry);
  const solid = new Mesh(level.geometry, new MeshBasicMaterial({ side: DoubleSide }));
  solid.raycast = acceleratedRaycast;
  const raycaster = Object.assign(new Raycaster(), { firstHitOnly: true });
  const head = new Vector3();
  const way = new Vector3();
  const report: BoomReport = {
    frames: 0,
    hidden: [],
    cut: [],
    lengths: [],
    draws: 0,
    blocked: 0,
    reach: 0,
    update: 0,
    walked: 0,
    given: 0,
  };

  const isHidden = (to: Vector3) => {
    const length = way.subVectors(to, head).length();
    if (length < 1e-6) return false;
    raycaster.set(head, way.divideScalar(length));
    raycaster.far = length;
    return raycaster.intersectObject(solid).length > 0;
  };
  const judge = () => {
    raycaster.set(asked.pivot, asked.direction);
    raycaster.far = asked.distance;
    const free = raycaster.intersectObject(solid)[0]?.distance ?? asked.distance;
    report.given += asked.free / free;
    head.copy(character.position);
    head.y += character.body.height - 0.2;
    camera.updateMatrixWorld();
    const at = `${report.frames}: ${[head, camera.position].map((place) => place.toArray().map((x) => x.toFixed(2))).join(' to ')}`;
    report.lengths.push(head.distanceTo(camera.position));
    if (isHidden(camera.position)) report.hidden.push(at);
    const { near, aspect } = camera;
    const h = near * Math.tan((camera.fov * Math.PI) / 360);
    for (const [x, y] of [
      [-1, -1],
      [1, -1],
      [-1, 1],
      [1, 1],
    ]) {
      const corner = new Vector3(x! * h * aspect, y! * h, -near).applyMatrix4(camera.matrixWorld);
      if (isHidden(corner)) report.cut.push(at);
    }
  };

  const dt = 1 / hz;
  const walk = new Vector3();
  for (const { from, to } of WAYS) {
    character.teleport(new Vector3(...from));
    let next = 0;
    const most = Math.round(frames / WAYS.length);
    for (let i = 0; i < most && next < to.length; i++) {
      const { position } = character;
      const [x, z] = to[next]!;
      walk.set(x - position.x, 0, z - position.z);
      if (walk.length() < 0.3) next++;
      character.walk(walk.setLength(6));
      // Looks all around, up and down.
      controls.yaw += 2.4 * dt;
      controls.pitch = 0.6 * Math.sin(1.7 * report.frames * dt);
      if (backend !== 'WebGL2') await see(body, level.scene);
      const before = position.clone();
      character.update(renderer, level.scene, dt);
      report.walked += position.distanceTo(before);
      const start = performance.now();
      controls.follow(dt);
      const middle = performance.now();
      made.update(renderer, level.scene, dt);
      report.reach += middle - start;
      report.update += performance.now() - middle;
      report.frames++;
      judge();
      await new Promise(requestAnimationFrame);
    }
  }
  report.given /= report.frames;
  report.reach /= report.frames;
  report.update /= report.frames;
  report.draws = eye.stats.draws;
  report.blocked = eye.stats.blocked;
  renderer.dispose();
  return report;
}
