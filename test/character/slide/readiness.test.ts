import { BoxGeometry, Mesh, Vector3 } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { listen } from '../../support/world/events.js';
import { block, Box, ground, wall } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

vi.spyOn(console, 'warn').mockImplementation(() => undefined);

describe('without a field', () => {
  it.each([1, 2, 3])(
    'should hold still in the air until the first has come, %i late',
    (latency) => {
      const walker = new WorldWalker(new World(ground()), { latency, foot: [0, 3, 0] });
      walker.walk(3);
      for (let i = 0; i < latency; i++) {
        expect(walker.character.ready).toBe(false);
        expect(walker.character.grounded).toBe(false);
        walker.frame();
        expect(walker.foot.toArray()).toEqual([0, 3, 0]);
        expect(walker.drawn.toArray()).toEqual([0, 3, 0]);
      }
      walker.run(1);
      expect(walker.character.ready).toBe(true);
      expect(walker.foot.y).toBeLessThan(0.03);
      expect(walker.foot.x).toBeGreaterThan(1);
    },
  );

  it('should never fall while nothing is drawn, and go on after', () => {
    const walker = new WorldWalker(new World(ground()), { foot: [0, 6, 0] });
    walker.collider.lost = true;
    walker.walk(5).run(5);
    expect(walker.foot.toArray()).toEqual([0, 6, 0]);
    expect(walker.character.ready).toBe(false);
    walker.collider.lost = false;
    walker.run(2);
    expect(walker.foot.y).toBeLessThan(0.03);
    expect(walker.character.ready).toBe(true);
  });

  it.each(['in the air', 'at a run'])(
    'should stop at the edge of what it knows, lost %s',
    (how) => {
      const inAir = how === 'in the air';
      const walker = new WorldWalker(new World(ground(), wall(40)), {
        foot: [0, inAir ? 8 : 0.02, 0],
      });
      walker.walk(inAir ? 0 : 5).run(0.4);
      walker.collider.lost = true;
      const from = walker.foot.clone();
      const held = walker.character.stats.held + walker.character.stats.slowed;
      walker.run(20);
      expect(walker.foot.distanceTo(from)).toBeLessThan(walker.collider.far);
      if (inAir) expect(walker.foot.y).toBeGreaterThan(0.5);
      expect(walker.character.stats.held + walker.character.stats.slowed - held).toBeGreaterThan(
        500,
      );
      walker.collider.lost = false;
      walker.run(3);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
      expect(walker.foot.y).toBeLessThan(0.03);
    },
  );

  it('should hold after invalidate and teleport until there is one', () => {
    for (const latency of [1, 3]) {
      const walker = new WorldWalker(new World(ground()), { latency }).settle(0.5).walk(3);
      walker.run(0.5).collider.invalidate();
      expect(walker.character.ready).toBe(false);
      const from = walker.foot.clone();
      walker.frame(latency);
      expect(walker.foot.distanceTo(from), walker.story).toBe(0);
      walker.run(0.5);
      expect(walker.foot.x - from.x, walker.story).toBeGreaterThan(1);
      walker.teleport(100, 5, -30);
      expect(walker.character.ready).toBe(false);
      walker.frame(latency);
      expect(walker.foot.distanceTo(new Vector3(100, 5, -30))).toBeLessThan(1e-9);
      expect(walker.velocity.length()).toBe(0);
      walker.run(1.5);
      expect(walker.foot.y).toBeLessThan(0.03);
    }
  });

  it('should not jump ahead after a long frame', () => {
    const walker = new WorldWalker(new World(ground())).settle(0.5).walk(3);
    walker.run(0.5);
    const { x } = walker.foot;
    walker.collider.tick();
    walker.character.update({}, {}, 100);
    expect(walker.foot.x - x).toBeLessThan(0.36);
  });
});

describe('what comes and goes', () => {
  it('should fall when its floor is taken away, and stand on one put under it', () => {
    for (const latency of [0, 2]) {
      const slab = block([-2, 2, -2], [2, 2.2, 2], 'slab');
      const world = new World(ground(), slab);
      const walker = new WorldWalker(world, { latency, foot: [0, 2.22, 0] }).settle(0.5);
      expect(walker.foot.y).toBeCloseTo(2.22, 2);
      world.remove(slab);
      walker.run(1.5);
      expect(walker.foot.y).toBeCloseTo(0.02, 2);
    }
  });

  it('should be let through a door that was opened, and only then', () => {
    const door = new Box(0.05, 1.5, 2, 'door').at(1, 1.5, 0);
    const walker = new WorldWalker(new World(ground(), door)).settle(0.3).walk(3).run(1);
    expect(walker.foot.x).toBeLessThan(0.62);
    door.object.visible = false;
    walker.run(1);
    expect(walker.foot.x).toBeGreaterThan(2);
  });

  it('should report sensors and walk through them', () => {
    const sensor = new Mesh(new BoxGeometry(1, 2, 6));
    sensor.position.set(2, 1, 0);
    const world = new World(ground()).addSensor(sensor);
    const walker = new WorldWalker(world).settle(0.3);
    const heard = listen(walker.character);
    const told = () =>
      [heard.contact, heard.separate].map((of) => of.filter((e) => e.sensor).length);
    walker.walk(3).run(0.2);
    expect(told()).toEqual([0, 0]);
    walker.run(0.4);
    expect(told()).toEqual([1, 0]);
    expect(heard.contact.find((e) => e.sensor)!.object).toBe(sensor);
    walker.run(1);
    expect(told()).toEqual([1, 1]);
    expect(walker.foot.x).toBeGreaterThan(4);
    sensor.position.x = walker.foot.x + 0.5;
    walker.walk(0).run(0.2);
    expect(told()).toEqual([2, 1]);
  });

  it('should draw seldom where nothing moves', () => {
    const walker = new WorldWalker(new World(ground(), wall(30)), { latency: 2 }).settle(1);
    const { draws } = walker.collider;
    walker.walk(3).run(5);
    expect(walker.collider.draws - draws).toBeLessThanOrEqual(75);
    const { steps, held, slowed } = walker.character.stats;
    expect((held + slowed) / steps).toBeLessThan(0.05);
  });

  it.each([0, 1, 3])(
    'should look again from where something stops it, and then no more, %i late',
    (latency) => {
      for (let away = 0.8; away < 1.6; away += 0.1) {
        const walker = new WorldWalker(new World(ground(), wall(away)), { latency }).settle(1);
        walker.walk(3).run((away - 0.37) / 3 + 0.15);
        const middle = walker.foot.clone();
        middle.y += 0.36 * 1.8;
        expect(walker.collider.position.distanceTo(middle), `wall ${away}`).toBeLessThan(0.03);
        walker.run(0.2);
        const { draws } = walker.collider;
        walker.run(2);
        expect(walker.collider.draws).toBe(draws);
      }
    },
  );
});
