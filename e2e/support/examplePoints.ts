import type { RigidBody } from '@dimforge/rapier3d-compat';
import type { Page } from '@playwright/test';
import type { Mesh, Object3D, Vector3 } from 'three';

declare global {
  interface Window {
    bodies: Map<Mesh, RigidBody>;
    creatures: { object: Object3D }[];
    /** Of this test. */
    ride?: { tries: number; from: Vector3 | null };
    lift: Mesh;
  }
}

const LONG = { timeout: 60_000 };

/** What an example is there to show, where walking alone does not tell. */
export const points: Record<string, (page: Page) => Promise<void>> = {
  /** The lift takes the character along. */
  'from-octree': async (page) => {
    await page.evaluate(() => {
      const place = window.lift.position.clone();
      place.y += 0.3;
      window.character.teleport(place);
    });
    await page.waitForFunction(() => window.character.ground?.object === window.lift, null, LONG);
    const from = await page.evaluate(() => window.character.position.y);
    await page.waitForFunction(
      (from) =>
        Math.abs(window.character.position.y - from) > 0.5 &&
        window.character.ground?.object === window.lift,
      from,
      LONG,
    );
  },

  /** A walker pushes the character out of its way, a swimmer carries it on its back. */
  'skinned-creatures': async (page) => {
    const from = await page.evaluate(() => {
      // Ahead on its round about (0, 0, 2).
      const place = window.creatures[0]!.object.position.clone();
      place.z -= 2;
      place.applyAxisAngle(window.character.up, -0.8);
      place.z += 2;
      window.character.teleport(place.setY(0.1));
      return window.character.position.toArray();
    });
    await page.waitForFunction(
      ([x, , z]) =>
        Math.hypot(window.character.position.x - x!, window.character.position.z - z!) > 0.2,
      from,
      LONG,
    );
    // Who lands beside its back tries again: a slow page's swimmer is elsewhere by then.
    await page.waitForFunction(
      () => {
        const { character, creatures } = window;
        const rides = (character.ground?.object as Mesh | null)?.type === 'SkinnedMesh';
        const ride = (window.ride ??= { tries: 0, from: null });
        if (!rides) {
          ride.from = null;
          if (ride.tries++ % 60 > 0) return false;
          const { object } = creatures.at(-1)!;
          const place = object.localToWorld(character.position.clone().set(0, 1.35, -0.3));
          character.teleport(place.setY(1));
          return false;
        }
        ride.from ??= character.position.clone();
        return ride.from.distanceTo(character.position) > 0.2;
      },
      null,
      LONG,
    );
  },

  /** Through a curtain, over a bridge that nobody sees, into the grass. */
  ghosts: async (page) => {
    await page.keyboard.down('ShiftLeft');
    await page.keyboard.down('KeyW');
    await page.waitForFunction(
      () => window.character.position.z < -5.5 && window.character.grounded,
      null,
      LONG,
    );
    await page.keyboard.up('KeyW');
    await page.keyboard.up('ShiftLeft');
  },

  /** A ball stops the character, which pushes it along. */
  'beside-rapier': async (page) => {
    const from = await page.evaluate(() => {
      const body = [...window.bodies.values()][1]!;
      const { x, y, z } = window.character.position;
      body.setTranslation({ x, y: y + 0.5, z: z - 1 }, true);
      body.setLinvel({ x: 0, y: 0, z: 0 }, true);
      return z - 1;
    });
    await page.keyboard.down('KeyW');
    // Pushed along, and out of the character again.
    await page.waitForFunction(
      (from) => {
        const [mesh, body] = [...window.bodies][1]!;
        const pushed = body.translation().z < from - 0.5;
        return pushed && mesh.position.distanceTo(window.character.position) > 0.7;
      },
      from,
      LONG,
    );
    await page.keyboard.up('KeyW');
  },
};
