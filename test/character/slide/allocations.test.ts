import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { CharacterController } from '../../../src/character/CharacterController.js';
import { block, ground, kerb, pole, wall } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldCollider } from '../../support/world/WorldCollider.js';

/** What V8 wraps a double in that is handed from function to function; a Vector3 is six of these. */
const NUMBER = 16;

/**
 * Bytes of heap that each call leaves behind, once the compiler has settled: the least of several trials, or the first
 * below `enough`. On a busy machine collections fall into many of them.
 */
function bytesEach(calls: number, enough: number, run: () => void): number {
  for (let i = 0; i < 3 * calls; i++) run();
  let least = Infinity;
  for (let trial = 0; trial < 30 && least >= enough; trial++) {
    const before = process.memoryUsage().heapUsed;
    for (let i = 0; i < calls; i++) run();
    const grown = process.memoryUsage().heapUsed - before;
    // A collection in between would show as less than nothing.
    if (grown >= 0) least = Math.min(least, grown / calls);
  }
  return least;
}

describe('a fixed step', () => {
  it.each([
    ['standing', [ground()], 0],
    ['walking into a corner', [ground(), wall(0.5), wall(0, 0.5, Math.PI / 2)], 3],
    ['pressing at a step too high', [ground(), kerb(0.6, 0.5), pole(0, 0.6)], 3],
    ['under a ceiling', [ground(), block([-3, 1.9, -3], [3, 2, 3]), wall(0.5)], 3],
  ] as const)('should make no object, %s', (_, solids, speed) => {
    const collider = new WorldCollider(new World(...solids));
    const character = new CharacterController(collider);
    character.teleport(new Vector3(0, 0.02, 0));
    const wish = new Vector3(speed, 0, speed / 2);
    character.walk(wish);
    for (let i = 0; i < 60; i++) {
      collider.tick();
      character.update({}, {}, 1 / 60);
    }
    expect(character.ready).toBe(true);
    const { steps } = character.stats;
    const bytes = bytesEach(1000, 64 * NUMBER, () => {
      // A step that would only repeat the last is not made: each wants a hair more or less.
      wish.x = wish.x > speed ? speed : speed + 1e-9;
      character.walk(wish);
      character.step(1 / 60);
    });
    expect(bytes).toBeLessThan(64 * NUMBER);
    expect(character.stats.steps - steps).toBeGreaterThan(2500);
  });
});
