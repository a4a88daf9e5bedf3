import { describe, expect, it } from 'vitest';
import { listen } from '../../support/world/events.js';
import { block, Box, ground, room } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

const heard = (inside: boolean): unknown => expect.objectContaining({ inside });

describe('a body inside a solid', () => {
  it.each([0, 2])('should be told so where it begins in one, fields %i late', (latency) => {
    const world = new World(ground(), block([-1.2, -0.5, -1.2], [1.2, 2.2, 1.2], 'rock'));
    const walker = new WorldWalker(world, { latency });
    const events = listen(walker.character).inside;
    expect(walker.character.inside).toBe(false);
    walker.run(1);
    expect(walker.character.inside).toBe(true);
    expect(events).toEqual([heard(true)]);
    walker.teleport(5, 0.02, 0).run(1);
    expect(walker.character.inside).toBe(false);
    expect(events).toHaveLength(2);
  });

  it.each([0, 2])('should go back to where it was free, fields %i late', (latency) => {
    // A rock appears around one who walks: as streamed scenery does.
    const rock = new Box(1, 1.2, 1.2, 'rock').at(2.4, 1, 0);
    const world = new World(ground(), rock);
    const walker = new WorldWalker(world, { latency });
    rock.object.visible = false;
    walker.settle(0.5).walk(2).run(1.2);
    const { x } = walker.foot;
    expect(x).toBeGreaterThan(1.8);
    rock.object.visible = true;
    const events = listen(walker.character).inside;
    walker.walk(0).run(1);
    expect(events.map(({ inside }) => inside)).toEqual([true, false]);
    // In front of the rock, and with room.
    expect(walker.foot.x).toBeLessThan(1.4);
    expect(walker.gap).toBeGreaterThan(0);
  });

  it('should not be said of one who walked behind a wall that shows its back', () => {
    const wall = new Box(0.01, 5, 20, 'wall').at(0.5, 0, 0);
    const walker = new WorldWalker(new World(ground(), wall));
    const { cast } = wall;
    wall.cast = (...ray) => {
      const distance = cast.apply(wall, ray);
      wall.nx = 1; // Its fronts look away, whatever the side.
      wall.ny = wall.nz = 0;
      return distance;
    };
    const events = listen(walker.character).inside;
    walker.settle(0.5).walk(3, 1).run(2);
    expect(walker.collider.field!.front.includes(0)).toBe(true);
    expect(events).toEqual([]);
  });

  it('should not be said of one in a room, or squeezed in a corner', () => {
    const walker = new WorldWalker(new World(...room(1, 1.5, 1)), { foot: [0, -1.48, 0] });
    const events = listen(walker.character).inside;
    walker.settle(0.5).walk(3, 2).run(2);
    expect(walker.character.inside).toBe(false);
    expect(events).toEqual([]);
  });
});
