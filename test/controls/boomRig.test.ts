import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it, vi } from 'vitest';
import type { Boom } from '../../src/controls/Boom.js';
import { nearRadius } from '../../src/controls/nearRadius.js';
import { controlledPage } from '../support/controlledPage.js';

/** A page with a boom that has so much room. */
function withBoom(options = {}) {
  const room = { free: Infinity };
  const reach = vi.fn<Boom['reach']>((_pivot, _direction, distance) =>
    Math.min(distance, room.free),
  );
  const boom = Object.assign(room, { reach, ignore: vi.fn() });
  return { boom, ...controlledPage({ view: 'third', boom, ...options }) };
}

describe('CharacterControls: boom', () => {
  it('should ask from the eyes, along the boom, for a ball around the near plane', () => {
    const { boom, camera, character, controls } = withBoom();
    let asked: unknown[] = [];
    boom.reach.mockImplementation((pivot, direction, distance, radius) => {
      asked = [...pivot.toArray(), direction.length(), distance];
      expect(radius).toBeGreaterThan(nearRadius(camera));
      expect(radius).toBeLessThan(nearRadius(camera) + 0.1);
      return 2;
    });
    character.position.set(1, 2, 3);
    controls.follow(1 / 60);
    expect(asked).toEqual([1, 3.6, 3, 1, 4].map((x) => expect.closeTo(x, 9)));
    expect(camera.position.distanceTo(new Vector3(1, 3.6, 3))).toBeCloseTo(2, 9);
  });

  it('should be told of the avatar once, and of another one', () => {
    const { boom, character, controls } = withBoom();
    controls.follow(1 / 60);
    controls.follow(1 / 60);
    expect(boom.ignore.mock.calls).toEqual([[character.avatar]]);
  });

  it('should fade the avatar as the camera comes near, and hide it in the end', () => {
    const { boom, character, controls } = withBoom();
    for (const [free, opacity, visible] of [
      [4, 1, true],
      [1.3, 1, true],
      [1, 0.5, true],
      [0.65, 0, false],
    ] as const) {
      boom.free = free;
      controls.follow(1 / 60);
      expect(controls.avatarOpacity).toBeCloseTo(opacity, 6);
      expect(character.avatar.visible).toBe(visible);
    }
  });

  it('should not be asked in first person, and glide there and back', () => {
    const { boom, camera, controls } = withBoom();
    controls.follow(1 / 60);
    controls.view = 'first';
    controls.follow(1 / 60);
    expect(camera.position.z).toBeGreaterThan(2);
    for (let i = 0; i < 90; i++) controls.follow(1 / 60);
    expect(camera.position.z).toBe(0);
    boom.reach.mockClear();
    controls.follow(1 / 60);
    expect(boom.reach).not.toHaveBeenCalled();
    controls.view = 'third';
    controls.follow(1 / 60);
    expect(camera.position.z).toBeLessThan(1);
  });

  it('should take all of it at once where motion is to be reduced', () => {
    const { boom, camera, controls } = withBoom({ smoothing: Infinity });
    const length = () => camera.position.distanceTo(new Vector3(0, 1.6, 0));
    boom.free = 1;
    controls.follow(1 / 60);
    expect(length()).toBeCloseTo(1, 9);
    boom.free = Infinity;
    controls.follow(1 / 60);
    expect(length()).toBeCloseTo(4, 9);
    controls.view = 'first';
    controls.follow(1 / 60);
    expect(length()).toBe(0);
  });

  it('should not lift the head into a ceiling, on the way down a step or into a crouch', () => {
    const { boom, character, controls } = withBoom();
    const body = { height: 1.8 };
    Object.assign(character, { body });
    const heads: number[] = [];
    // 0.1 m of room over where the eyes will be.
    boom.reach.mockImplementation((pivot, direction, distance) => {
      if (direction.y === 1) return Math.min(distance, 0.1);
      heads.push(pivot.y);
      return distance;
    });
    character.position.y = 0.3;
    controls.follow(1 / 60);
    character.position.y = 0;
    controls.follow(1 / 60);
    for (let i = 0; i < 60; i++) controls.follow(1 / 60);
    body.height = 1.1;
    controls.follow(1 / 60);
    expect([heads[0], heads[1], heads.at(-2), heads.at(-1)]).toEqual(
      [1.9, 1.7, 1.6, 1].map((y) => expect.closeTo(y, 3)),
    );
  });
});

describe('nearRadius', () => {
  it.each([
    [70, 16 / 9, 0.05],
    [100, 0.5, 0.3],
  ])('should hold the corners of the near plane: %s°, %s, %s m', (fov, aspect, near) => {
    const camera = new PerspectiveCamera(fov, aspect, near, 100);
    const corner = new Vector3(1, 1, -1).applyMatrix4(camera.projectionMatrixInverse);
    expect(nearRadius(camera)).toBeCloseTo(corner.length(), 9);
  });

  it('should hold them in a part of a larger picture, too', () => {
    const camera = new PerspectiveCamera(70, 2, 0.1, 100);
    camera.setViewOffset(1000, 500, 600, 0, 400, 500);
    const radii = [-1, 1].flatMap((x) =>
      [-1, 1].map((y) =>
        new Vector3(x, y, -1).applyMatrix4(camera.projectionMatrixInverse).length(),
      ),
    );
    expect(nearRadius(camera)).toBeCloseTo(Math.max(...radii), 9);
  });
});
