import { Group, type Object3D, Vector3 } from 'three';
import { materialsOf } from '../pieces.js';
import { createBulgingWall } from './bulgingWall.js';
import { createCreature } from './creature.js';
import type { Exhibit } from './Exhibit.js';
import { createFence } from './fence.js';
import { createGrove } from './grove.js';
import { createMorphFloor } from './morphFloor.js';
import { createRubble } from './rubble.js';
import { createSigns, type Sign } from './signs.js';
import { createTerrace, TERRACE_HEIGHT } from './terrace.js';
import { createWaves } from './waves.js';

/** Outside the plaza's south wall. */
const PLACE = new Vector3(0, TERRACE_HEIGHT, 31);
/** From here on nobody sees whether it moves, metres from its middle. */
const AWAY = 60;
const MIDDLE = new Vector3(0, 0, 13.5).add(PLACE);

const SIGNS: Sign[] = [
  { caption: 'SKIN', text: 'CREATURE', family: 'teal', x: -2.2, z: 12.4 },
  { caption: 'MORPH TARGETS', text: 'FLOOR', family: 'plum', x: 2.6, z: 2.6 },
  { caption: 'INSTANCES', text: 'GROVE', family: 'sage', x: -2.1, z: 2.6 },
  { caption: 'VERTEX SHADER', text: 'WAVES', family: 'blue', x: 3.1, z: 12 },
  { caption: 'ALPHA TEST', text: 'FENCE', family: 'ochre', x: -1.4, z: 9.6 },
  { caption: 'BATCH', text: 'RUBBLE', family: 'terracotta', x: 3.2, z: 19.6 },
  { caption: 'OWN SHADER', text: 'WALL', family: 'plum', x: -2, z: 22.4 },
  {
    caption: 'WHAT IS DRAWN IS SOLID',
    text: 'HALL',
    family: 'teal',
    x: 0,
    z: -0.3,
    above: 2.62,
    size: 3,
  },
];

/** Everything that other colliders find hard. */
export type Hall = ReturnType<typeof createHall>;

/**
 * A hall of what other colliders cannot follow: nothing in it is told to the collider, all of it is only drawn.
 *
 * @param level lends its materials
 */
export function createHall(level: Object3D) {
  const material = materialsOf(level);
  const exhibits = {
    grove: placed(createGrove(material), -7.4, 5.2),
    morphFloor: placed(createMorphFloor(material), 7.4, 5),
    fence: placed(createFence(material), 0, 10.5),
    creature: placed(createCreature(), -7.3, 16.6),
    waves: placed(createWaves(), 8, 13.4),
    rubble: placed(createRubble(material), 8, 21.8),
    wall: placed(createBulgingWall(material), 0, 24),
  };
  const all: Exhibit[] = Object.values(exhibits);
  const root = new Group();
  root.name = 'hall';
  root.position.copy(PLACE);
  root.add(
    createTerrace(material),
    createSigns(SIGNS, material),
    ...all.map(({ object }) => object),
  );
  const hall = {
    root,
    ...exhibits,
    /** Where one comes in, looking south: the foot, world. */
    entry: new Vector3(0, 0.05, -0.4).add(PLACE),
    /** Seconds that it has moved for; may be set. */
    time: 0,
    /** Moves it on, if it can be seen from `viewer`. */
    update(delta: number, viewer: Vector3): void {
      hall.time += delta;
      if (viewer.distanceTo(MIDDLE) > AWAY) return;
      for (const { update } of all) update?.(hall.time);
    },
  };
  hall.update(0, MIDDLE);
  return hall;
}

function placed<E extends Exhibit>(exhibit: E, x: number, z: number): E {
  exhibit.object.position.set(x, exhibit.object.position.y, z);
  return exhibit;
}
