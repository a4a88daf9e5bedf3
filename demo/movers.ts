import {
  type BufferGeometry,
  CircleGeometry,
  CylinderGeometry,
  Group,
  LatheGeometry,
  type Mesh,
  type Object3D,
  Vector2,
} from 'three';
import {
  assemble,
  type Materials,
  materialsOf,
  merge,
  slab,
  stretch,
  TEXTURE_SIZE,
} from './pieces.js';

/** The lift: its plate's middle beside the gap in the balcony's railing, and how high that is, metres. */
const LIFT = { x: -24.75, z: -7.18, width: 1.5, top: 3, thickness: 0.1 };
/** Seconds it stands at either end, and takes from one to the other. */
const WAIT = 3;
const TRAVEL = 3.5;
/** Seconds it goes back up for after it met someone below. */
const SHY = 1.5;

const TURNTABLE = { x: -16.5, z: -0.6, radius: 2.4, height: 0.11 };
/** Radians a second. */
const TURN = 0.45;
/** Metres of the rosette's picture, and of the part of it that is the star. */
const ROSETTE = { size: 8, radius: 3.9 };

/** The demo's moving things. */
export interface Movers {
  readonly root: Group;
  /** Seconds that they have moved for; may be set. */
  time: number;
  /** Moves them on. @param squeezed whether the lift must not come down */
  update(delta: number, squeezed: boolean): void;
}

/**
 * A lift up to the balcony and a turntable on the plaza, in the level's own materials.
 *
 * Nothing tells the collider that they move: it sees it.
 */
export function createMovers(level: Object3D): Movers {
  const root = new Group();
  root.name = 'movers';
  const material = materialsOf(level);
  const lift = createLift(material);
  const table = createTurntable(material);
  root.add(lift, table);
  let shy = 0;
  const movers: Movers = {
    root,
    time: 0,
    update(delta, squeezed) {
      const phase = movers.time % (2 * (WAIT + TRAVEL));
      const falling = phase > 2 * WAIT + TRAVEL;
      if (squeezed && falling) shy = SHY;
      // Back the way it came, not on through who stands below.
      shy = falling ? Math.max(0, shy - delta) : 0;
      movers.time += shy > 0 ? -delta : delta;
      lift.position.y = LIFT.thickness + liftPart(movers.time) * (LIFT.top - LIFT.thickness);
      table.rotation.y = TURN * movers.time;
    },
  };
  movers.update(0, false);
  return movers;
}

/** How far up the lift is, 0 to 1. */
function liftPart(time: number): number {
  const phase = time % (2 * (WAIT + TRAVEL));
  const up = Math.min(1, Math.max(0, (phase - WAIT) / TRAVEL));
  const down = Math.min(1, Math.max(0, (phase - 2 * WAIT - TRAVEL) / TRAVEL));
  return ease(up) - ease(down);
}

function ease(x: number): number {
  return x * x * x * (x * (6 * x - 15) + 10);
}

/** A plate on a piston that sinks into the ground. Its origin is in the middle of its top. */
function createLift(material: Materials): Mesh {
  const { width, thickness, top } = LIFT;
  const rim = 0.07;
  const piston = new CylinderGeometry(0.16, 0.16, top, 24);
  piston.translate(0, -thickness - top / 2, 0);
  const collar = new CylinderGeometry(0.24, 0.3, 0.08, 24);
  collar.translate(0, -thickness - 0.03, 0);
  const lift = assemble('lift', [
    [slab(width - 2 * rim, thickness, width - 2 * rim, 0), material('wood')],
    [frame(width, thickness, rim), material('ochre')],
    [merge(piston, collar), material('metal')],
  ]);
  lift.position.set(LIFT.x, thickness, LIFT.z);
  return lift;
}

/** A wheel with the plaza's star on it and a bollard in its middle, that one may be carried round. */
function createTurntable(material: Materials): Mesh {
  const { radius, height } = TURNTABLE;
  const top = new CircleGeometry(radius, 64).rotateX(-Math.PI / 2).translate(0, height, 0);
  const { uv } = top.attributes;
  const scale = (2 * ROSETTE.radius) / ROSETTE.size;
  for (let i = 0; i < uv!.count; i++) {
    uv!.setXY(i, 0.5 + scale * (uv!.getX(i) - 0.5), 0.5 - scale * (uv!.getY(i) - 0.5));
  }
  const side = new CylinderGeometry(radius, radius, height + 0.02, 64, 1, true);
  side.translate(0, height / 2 - 0.01, 0);
  stretch(side, (2 * Math.PI * radius) / TEXTURE_SIZE, height / TEXTURE_SIZE);
  const profile = [
    [0.26, height - 0.01],
    [0.26, height + 0.08],
    [0.17, height + 0.12],
    [0.15, height + 0.72],
    [0.2, height + 0.78],
    [0.2, height + 0.84],
    [0, height + 0.86],
  ].map(([x, y]) => new Vector2(x, y));
  const ball = [
    [0, height + 1.14],
    [0.1, height + 1.11],
    [0.16, height + 1.0],
    [0.13, height + 0.88],
    [0.08, height + 0.85],
  ]
    .reverse()
    .map(([x, y]) => new Vector2(x, y));
  const table = assemble('turntable', [
    [top, material('rosette')],
    [side, material('terracotta')],
    [new LatheGeometry(profile, 24), material('nosing')],
    [new LatheGeometry(ball, 24), material('terracotta')],
  ]);
  table.position.set(TURNTABLE.x, 0, TURNTABLE.z);
  return table;
}

/** Four bars around a square, flush with its top. */
function frame(width: number, height: number, rim: number): BufferGeometry {
  const out = (width - rim) / 2;
  return merge(
    slab(rim, height, width, out),
    slab(rim, height, width, -out),
    slab(width - 2 * rim, height, rim, 0, out),
    slab(width - 2 * rim, height, rim, 0, -out),
  );
}
