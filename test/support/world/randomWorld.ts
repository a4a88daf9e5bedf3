import {
  Ball,
  block,
  Box,
  Cylinder,
  ground,
  pole,
  rampFrom0,
  spiral,
  stairs,
  table,
} from './scenes.js';
import type { Solid } from './Solid.js';
import { World } from './World.js';

/** Half the width of a random world, metres. */
export const HALF = 9;

/**
 * A walled yard strewn with boxes upright and tilted, poles, stairs, ramps, tables, a spiral, balls, low beams: what a
 * level is made of, in the way of one another. The middle (1 m around the origin) is free.
 */
export function randomWorld(random: () => number): World {
  const world = new World(ground(), yard());
  const between = (low: number, high: number) => low + (high - low) * random();
  const place = (): [number, number] => {
    for (;;) {
      const x = between(-HALF, HALF);
      const z = between(-HALF, HALF);
      if (x * x + z * z > 16) return [x, z];
    }
  };
  const yaw = () => between(-Math.PI, Math.PI);
  for (let i = 0; i < 14; i++) {
    const h = between(0.02, 1.5);
    const box = new Box(between(0.1, 1.2), h, between(0.1, 1.2), `box ${i}`);
    const [x, z] = place();
    world.add(box.at(x, between(-0.5, 1) * h, z).turn({ yaw: yaw() }));
  }
  for (let i = 0; i < 6; i++) {
    const box = new Box(between(0.2, 1), between(0.05, 0.5), between(0.2, 1), `tilted box ${i}`);
    const [x, z] = place();
    const tilt = () => between(-0.7, 0.7);
    world.add(box.at(x, between(0, 0.8), z).turn({ yaw: yaw(), pitch: tilt(), roll: tilt() }));
  }
  for (let i = 0; i < 6; i++) world.add(pole(...place(), between(0.04, 0.2)));
  for (let i = 0; i < 3; i++) {
    const [x, z] = place();
    world.add(new Ball(between(0.2, 0.9), `ball ${i}`).at(x, between(-0.3, 0.5), z));
  }
  for (let i = 0; i < 3; i++) {
    const beam = new Cylinder(between(0.04, 0.15), between(1, 3), `beam ${i}`);
    const [x, z] = place();
    world.add(beam.at(x, between(0.5, 2), z).turn({ yaw: yaw(), pitch: Math.PI / 2 }));
  }
  world.add(...table(...place()));
  turned(world, stairs(4, between(0.1, 0.35), between(0.25, 0.4), 1.6, 0.8), ...place(), yaw());
  turned(world, [rampFrom0(between(0.2, 0.8), 3, 2)], ...place(), yaw());
  turned(world, spiral(9, between(0.12, 0.25)), ...place(), yaw());
  return world;
}

function yard(): Solid[] {
  const far = HALF + 1;
  return [
    block([HALF, -1, -far], [far, 8, far], 'yard +x'),
    block([-far, -1, -far], [-HALF, 8, far], 'yard -x'),
    block([-far, -1, HALF], [far, 8, far], 'yard +z'),
    block([-far, -1, -far], [far, 8, -HALF], 'yard -z'),
  ];
}

/** Adds what was built around the origin elsewhere, turned about +Y. Long parts may reach out of the yard. */
function turned(world: World, solids: Solid[], x: number, z: number, yaw: number): void {
  for (const { object } of solids) {
    const { position, rotation } = object;
    const { x: px, z: pz } = position;
    position.x = x + px * Math.cos(yaw) + pz * Math.sin(yaw);
    position.z = z - px * Math.sin(yaw) + pz * Math.cos(yaw);
    rotation.order = 'YXZ';
    rotation.y += yaw;
  }
  world.add(...solids);
}
