// The level's plan, metres: +X east, -Z north, the plaza's floor at y = 0.

import { Shape } from './Shape.mjs';
import { bridge, railings, spiralStair } from './parts/bridge.mjs';
import { flights, kerbs, ledge, pole, ramps, stage } from './parts/course.mjs';
import { PIT_RIM, ground } from './parts/ground.mjs';
import { footbridge, signposts } from './parts/guide.mjs';
import { arch, columns, corridor, doorway, lowCeiling } from './parts/passages.mjs';
import { benches, outerWalls, surroundings, tower, trees } from './parts/scenery.mjs';
import { sign } from './parts/sign.mjs';

/** The start, looking north at the stage: nine metres of clear floor ahead. */
export const SPAWN = [0, 0, 4];

export function level() {
  const signs = new Shape('signs');
  const shapes = [
    ...ground(),
    ...stage(signs),
    ...flights(signs),
    ...ramps(signs),
    ...kerbs(signs),
    ledge(signs),
    pole(signs),
    doorway(signs),
    corridor(signs),
    lowCeiling(signs),
    columns(signs),
    arch(signs),
    spiralStair(signs),
    ...bridge(),
    footbridge(PIT_RIM),
    railings(),
    outerWalls(),
    tower(),
    trees(),
    benches(),
    surroundings(),
  ];
  signposts(signs);
  sign(signs, 'pit', 3.2, 13.4, 2);
  sign(signs, 'terrain', 7, 16.5, 2);
  return [...shapes, signs];
}
