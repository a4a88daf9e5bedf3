import { expect, runInPage, test } from './support/test.js';

// The hall's plan (demo/hall/createHall.ts), in its own frame: the gate in the north, z = 0; x to the east.
const RADIUS = 0.35;
const SKIN = 0.02;
const FENCE = 10.5;
const WALL = 24;

const mm = (metres: number) => (1000 * metres).toFixed(1);

test('walks through a hall of what is only drawn, and finds all of it solid', async ({ page }) => {
  await runInPage(page, '/e2e/harness/hall.ts');
  // The exact triangles that the GPU draws at that moment are the judge of every gap.

  await test.step('a stair: up over the wall and through the gate', async () => {
    const climb = await page.evaluate(() => {
      const { hallWorld: world } = window;
      // On its lowest step.
      world.put(0, -3.9, -7.8);
      return world.walk(3.6, () => ({ x: 0, z: 9 }));
    });
    expect.soft(climb.end[1]).toBeCloseTo(SKIN, 2);
    expect.soft(climb.end[2]).toBeGreaterThan(1);
  });

  await test.step('a grove of instances: through between the trees, and through none of them', async () => {
    const walk = await page.evaluate(() => {
      const { hallWorld: world } = window;
      world.put(-7.2, 0.1, 0.8);
      return world.walk(3.5, () => ({ x: -7.2, z: 30 }), 'grove');
    });
    console.log(`    grove: ${mm(walk.deepest)} mm deep, ${walk.instances.length} trees touched`);
    expect.soft(walk.deepest).toBeLessThan(0.01);
    expect.soft(walk.touched).toContain('grove');
    expect.soft(walk.instances.length).toBeGreaterThan(0);
  });

  await test.step('morph targets: stands on them while they rise', async () => {
    const { ride, low, high } = await page.evaluate(() => {
      const { hallWorld: world } = window;
      world.put(7.4, 0.7, 5, 0.5);
      const low = world.character.position.y;
      const ride = world.walk(3, () => null, 'morphFloor');
      return { ride, low, high: world.character.position.y };
    });
    console.log(
      `    morph floor: up ${mm(high - low)} mm, gap ${mm(-ride.deepest)} to ${mm(ride.highest)} mm`,
    );
    expect.soft(ride.grounds).toEqual(['morph floor']);
    expect.soft(high - low).toBeGreaterThan(0.3);
    expect.soft(ride.deepest + SKIN).toBeLessThan(0.02);
    expect.soft(ride.highest - SKIN).toBeLessThan(0.02);
  });

  await test.step('an alpha test: through the hole in the fence, and not beside it', async () => {
    const { through, beside } = await page.evaluate((fence) => {
      const { hallWorld: world } = window;
      const walkFrom = (x: number) => {
        world.put(x, 0.1, fence - 1);
        return world.walk(0.8, () => ({ x, z: fence + 9 }));
      };
      return { through: walkFrom(0), beside: walkFrom(2) };
    }, FENCE);
    console.log(
      `    fence: ${mm(through.end[2]! - FENCE)} mm past its hole, ` +
        `${mm(FENCE - RADIUS - beside.end[2]!)} mm from its planks`,
    );
    expect.soft(through.end[2]).toBeGreaterThan(FENCE + 1);
    expect.soft(beside.end[2]! - (FENCE - RADIUS)).toBeLessThan(0);
    expect.soft(beside.end[2]! - (FENCE - RADIUS)).toBeGreaterThan(-0.03);
  });

  await test.step('a skin: climbs the creature by its tail, and is carried', async () => {
    const { climb, ride, slip } = await page.evaluate(() => {
      const { hallWorld: world } = window;
      // Behind its tail, then along its spine.
      world.put(-7.3, 0.1, 16.6, 20);
      const tail = world.joint(0);
      const next = world.joint(0.4);
      world.put(2 * tail.x - next.x, 0.1, 2 * tail.z - next.z, 20);
      let along = 0.8;
      const climb = world.walk(
        2.4,
        () => {
          const foot = world.character.position;
          const local = world.hall.root.worldToLocal(foot.clone());
          while (along < 4 && world.joint(along).setY(local.y).distanceTo(local) < 0.45)
            along += 0.4;
          return along < 4 ? world.joint(along) : null;
        },
        'creature',
      );
      world.walk(0.2, () => null);
      let slip = 0;
      const ride = world.walk(
        2,
        () => {
          slip = Math.max(slip, world.slip());
          return null;
        },
        'creature',
      );
      return { climb, ride, slip };
    });
    console.log(
      `    creature: on its back ${mm(climb.end[1]!)} mm up, slipped ${mm(slip)} mm in 2 s, ` +
        `gap ${mm(-ride.deepest)} to ${mm(ride.highest)} mm`,
    );
    expect.soft(climb.end[1]).toBeGreaterThan(0.85);
    expect.soft(climb.deepest).toBeLessThan(0.03);
    expect.soft(ride.grounds).toEqual(['creature']);
    expect.soft(slip).toBeLessThan(0.05);
    expect.soft(ride.deepest).toBeLessThan(0.01);
    expect.soft(ride.highest).toBeLessThan(0.05);
  });

  await test.step('a hooked vertex shader: walks across its waves', async () => {
    const walk = await page.evaluate(() => {
      const { hallWorld: world } = window;
      world.put(3.3, 0.1, 13.4);
      return world.walk(2.9, () => ({ x: 12, z: 13.4 }), 'waves');
    });
    console.log(
      `    waves: to x = ${walk.end[0]!.toFixed(2)}, ${mm(walk.deepest)} mm deep, ` +
        `gap at most ${mm(walk.highest)} mm`,
    );
    expect.soft(walk.end[0]).toBeGreaterThan(11);
    expect.soft(walk.grounds).toContain('waves');
    expect.soft(walk.deepest).toBeLessThan(0.03);
    expect.soft(walk.highest - SKIN).toBeLessThan(0.03);
  });

  await test.step('a batch: climbs the rubble', async () => {
    const walk = await page.evaluate(() => {
      const { hallWorld: world } = window;
      world.put(3.4, 0.1, 21.8);
      return world.walk(2.4, () => ({ x: 9.8, z: 21.8 }), 'rubble');
    });
    console.log(`    rubble: ${mm(walk.end[1]!)} mm up, ${mm(walk.deepest)} mm deep`);
    expect.soft(walk.end[1]).toBeGreaterThan(1.3);
    expect.soft(walk.grounds).toContain('rubble');
    expect.soft(walk.deepest).toBeLessThan(0.015);
  });

  await test.step('a shader of one’s own: the wall stops it, and pushes it back', async () => {
    const walk = await page.evaluate((wall) => {
      const { hallWorld: world } = window;
      world.put(0.3, 0.1, wall - 1.4);
      return world.walk(3, () => ({ x: 0.3, z: wall + 9 }), 'wall');
    }, WALL);
    console.log(`    wall: stopped at z = ${walk.end[2]!.toFixed(2)}, ${mm(walk.deepest)} mm deep`);
    expect.soft(walk.touched).toContain('bulging wall');
    expect.soft(walk.end[2]).toBeLessThan(WALL + 0.45);
    expect.soft(walk.deepest).toBeLessThan(0.03);
  });
});

test('begins there if the address says so', async ({ page }) => {
  await page.setViewportSize({ width: 240, height: 136 });
  await page.goto('/demo/index.html?ui=0&dpr=1&quality=low&place=hall');
  const begun = await page.evaluate(async () => {
    await window.demo.ready;
    const { demo } = window;
    await demo.step(10);
    const { x, y, z } = demo.character.position.clone().sub(demo.hall!.root.position);
    return { place: [x, y, z], ground: demo.character.ground?.object?.parent?.name };
  });
  expect(begun.ground).toBe('terrace');
  expect(begun.place[1]).toBeCloseTo(SKIN, 2);
  expect(Math.hypot(begun.place[0]!, begun.place[2]!)).toBeLessThan(1);
});
