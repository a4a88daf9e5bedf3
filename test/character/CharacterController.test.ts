import { Object3D, Vector3 } from 'three';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { CharacterController } from '../../src/character/CharacterController.js';
import type { CharacterOptions } from '../../src/character/characterOptions.js';
import { AxisResponse } from '../../src/response/AxisResponse.js';
import { AnalyticCollider } from '../support/AnalyticCollider.js';
import { floor } from '../support/analytic.js';

const warn = vi.spyOn(console, 'warn').mockImplementation(() => undefined);
beforeEach(() => warn.mockClear());
afterEach(() => vi.clearAllMocks());

function standing(options: CharacterOptions = {}) {
  const collider = new AnalyticCollider(floor());
  const character = new CharacterController(collider, { response: new AxisResponse(), ...options });
  for (let i = 0; i < 30; i++) character.update({}, {}, 1 / 60);
  return { collider, character };
}

describe('CharacterController, built', () => {
  it.each([
    [{ radius: 0 }, RangeError, '"radius"'],
    [{ radius: -1 }, RangeError, '"radius"'],
    [{ radius: NaN }, RangeError, '"radius"'],
    [{ radius: Infinity, height: Infinity }, RangeError, '"radius"'],
    [{ radius: 0.5, height: 0.9 }, RangeError, '"height"'],
    [{ height: NaN }, RangeError, '"height"'],
    [{ gravity: -9.8 }, RangeError, '"gravity"'],
    [{ gravity: '20' }, RangeError, '"gravity"'],
    [{ terminalSpeed: 0 }, RangeError, '"terminalSpeed"'],
    [{ jumpHeight: -1 }, RangeError, '"jumpHeight"'],
    [{ response: {} }, TypeError, '"response"'],
    [{ response: null }, TypeError, '"response"'],
    [{ avatar: {} }, TypeError, '"avatar"'],
  ])('should refuse %j', (options, error, name) => {
    const build = () =>
      new CharacterController(new AnalyticCollider(floor()), options as CharacterOptions);
    expect(build).toThrow(error);
    expect(build).toThrow(`CharacterController: ${name}`);
  });

  it.each([undefined, null, {}, 'collider'])('should refuse %s for a collider', (collider) => {
    const build = () => new CharacterController(collider as unknown as AnalyticCollider);
    expect(build).toThrow(TypeError);
    expect(build).toThrow('CharacterController: "collider"');
  });

  it('should leave the avatar out of the cubemap until disposed, and its collider alone', () => {
    const avatar = new Object3D();
    const collider = new AnalyticCollider(floor());
    const character = new CharacterController(collider, { avatar, response: new AxisResponse() });
    expect(collider.excluded).toEqual([avatar]);
    character.dispose();
    character.dispose();
    expect(collider.excluded).toEqual([]);
    character.update({}, {}, 1 / 60);
    character.step(1 / 60);
    expect(collider.draws).toBe(0);
    expect(warn).toHaveBeenCalledTimes(1);
  });
});

describe('CharacterController, moved', () => {
  it.each(['teleport', 'walk', 'move'] as const)(
    '%s should pass over what is no finite vector, warned once, and never throw into the loop',
    (method) => {
      const { character } = standing();
      const before = character.position.clone();
      character.walk(new Vector3(1, 0, 0));
      for (const bad of [
        new Vector3(NaN, 0, 0),
        new Vector3(0, Infinity, 0),
        new Vector3(0, 0, -Infinity),
        ...([undefined, null, {}, 3, [1, 2, 3]] as unknown as Vector3[]),
      ]) {
        character[method](bad);
      }
      expect(warn).toHaveBeenCalledTimes(1);
      expect(warn.mock.calls[0]![0]).toContain(`CharacterController: ${method}() needs a Vector3`);
      expect(character.position.equals(before)).toBe(true);
      // Nothing is lost: it is where it was, ready, and walks as it was told before.
      expect(character.ready).toBe(true);
      character.update({}, {}, 1 / 60);
      expect(character.velocity.x).toBeCloseTo(1, 6);
    },
  );

  it('should take walk until changed, ignore its y, and take move once', () => {
    const { character } = standing();
    character.walk(new Vector3(1, 99, 0));
    for (let i = 0; i < 60; i++) character.update({}, {}, 1 / 60);
    expect(character.position.x).toBeCloseTo(1, 6);
    expect(character.position.y).toBeCloseTo(0, 2);
    expect(character.velocity.x).toBeCloseTo(1, 6);
    character.walk(new Vector3());
    character.move(new Vector3(0, 0, 0.1));
    character.move(new Vector3(0, 0, 0.05));
    for (let i = 0; i < 10; i++) character.update({}, {}, 1 / 60);
    expect(character.position.z).toBeCloseTo(0.15, 6);
  });

  it('should tell its wish, level, whether or not it gets anywhere', () => {
    const collider = new AnalyticCollider(floor(), { output: 'surface', latency: 1000 });
    const character = new CharacterController(collider, { response: new AxisResponse() });
    expect(character.wish.toArray()).toEqual([0, 0, 0]);
    character.walk(new Vector3(3, 5, -1));
    for (let i = 0; i < 10; i++) character.update({}, {}, 1 / 60);
    expect(character.velocity.length()).toBe(0);
    expect(character.wish.toArray()).toEqual([3, 0, -1]);
  });

  it('should fly by move without gravity', () => {
    const { character } = standing({ gravity: 0 });
    for (let i = 0; i < 60; i++) {
      character.move(new Vector3(0, 1 / 60, 0));
      character.update({}, {}, 1 / 60);
    }
    expect(character.position.y).toBeCloseTo(1, 2);
    expect(character.jump()).toBe(false);
  });

  it('should keep body.position and position together, the foot a radius below the sphere', () => {
    const { character, collider } = standing();
    character.walk(new Vector3(2, 0, 1));
    character.update({}, {}, 1 / 60);
    expect(character.position.equals(character.body.position)).toBe(true);
    expect(collider.position.x).toBeCloseTo(character.position.x, 12);
    expect(Math.abs(collider.position.y - 0.35 - character.position.y)).toBeLessThan(0.005);
  });
});

describe('CharacterController, without data', () => {
  it('should hold still until the first cubemap has come, then fall', () => {
    const collider = new AnalyticCollider(floor(), { output: 'surface', latency: 5 });
    const character = new CharacterController(collider, { response: new AxisResponse() });
    character.teleport(new Vector3(0, 3, 0));
    character.walk(new Vector3(3, 0, 0));
    for (let i = 0; i < 5; i++) {
      expect(character.ready).toBe(false);
      expect(character.jump()).toBe(false);
      character.update({}, {}, 1 / 60);
      expect(character.position.toArray()).toEqual([0, 3, 0]);
      expect(character.velocity.lengthSq()).toBe(0);
    }
    character.update({}, {}, 1 / 60);
    expect(character.ready).toBe(true);
    character.update({}, {}, 1 / 60);
    expect(character.position.y).toBeLessThan(3);
    expect(warn).not.toHaveBeenCalled();
  });

  it('should forget everything when it teleports', () => {
    const { character } = standing();
    character.walk(new Vector3(5, 0, 0));
    character.update({}, {}, 1 / 60);
    character.teleport(new Vector3(1000, 20, -1000));
    expect(character.ready).toBe(false);
    expect(character.grounded).toBe(false);
    expect(character.velocity.lengthSq()).toBe(0);
    character.step(1 / 60);
    expect(character.position.toArray()).toEqual([1000, 20, -1000]);
    character.update({}, {}, 1 / 60);
    expect(character.ready).toBe(true);
  });

  it('should hold still, warned once, while the collider cannot draw, and go on after', () => {
    const { character, collider } = standing();
    character.teleport(new Vector3(0, 10, 0));
    for (let i = 0; i < 5; i++) character.update({}, {}, 1 / 60);
    const { y } = character.position;
    collider.lost = true;
    for (let i = 0; i < 60; i++) character.update({}, {}, 1 / 60);
    expect(character.position.y).toBe(y);
    expect(warn).toHaveBeenCalledTimes(1);
    collider.lost = false;
    for (let i = 0; i < 10; i++) character.update({}, {}, 1 / 60);
    expect(character.position.y).toBeLessThan(y);
  });

  it('should step against kept data only as far as they reach', () => {
    for (const output of ['axis', 'surface'] as const) {
      const collider = new AnalyticCollider(floor(-100), {
        output,
        readback: 'sync',
        resolution: 32,
      });
      const character = new CharacterController(collider, { response: new AxisResponse() });
      character.teleport(new Vector3());
      character.update({}, {}, 0);
      for (let i = 0; i < 600; i++) character.step(1 / 60);
      const reach = output === 'axis' ? 0.9 * 0.175 : 1.8 - 0.35;
      expect(character.position.y).toBeLessThan(-0.8 * reach);
      expect(character.position.y).toBeGreaterThanOrEqual(-reach - 1e-9);
      expect(collider.draws).toBe(1);
    }
  });
});

describe('CharacterController, in bad frames', () => {
  it.each([NaN, Infinity, -Infinity, -0.01, undefined, '0.016'])(
    'should hold for a delta of %s',
    (delta) => {
      const { character, collider } = standing();
      character.walk(new Vector3(1, 0, 0));
      const before = character.position.clone();
      const { draws } = collider;
      for (let i = 0; i < 3; i++) {
        character.update({}, {}, delta as number);
        character.step(delta as number);
        // However it varies.
        if (Number(delta) < 0) character.step(Number(delta) * (i + 2));
      }
      expect(character.position.equals(before)).toBe(true);
      expect(collider.draws).toBe(draws);
      expect(warn).toHaveBeenCalledTimes(1);
      expect(warn.mock.calls[0]![0]).toMatch(/^CharacterController: "delta"/);
      character.update({}, {}, 1 / 60);
      expect(character.position.x).toBeGreaterThan(before.x);
    },
  );

  it('should not mind a first frame that began before the clock was made', () => {
    const character = new CharacterController(new AnalyticCollider(floor()), {
      response: new AxisResponse(),
    });
    character.update({}, {}, -0.4);
    character.update({}, {}, 1 / 60);
    expect(warn).not.toHaveBeenCalled();
    character.update({}, {}, -0.007);
    expect(warn).toHaveBeenCalledTimes(1);
  });

  it.each([
    [undefined, {}],
    [{}, undefined],
    [null, null],
  ])('should hold without renderer or scene (%s, %s)', (renderer, scene) => {
    const { character } = standing();
    const before = character.position.clone();
    character.walk(new Vector3(1, 0, 0));
    character.jump();
    character.update({}, {}, 1 / 60);
    const { x } = character.velocity;
    before.copy(character.position);
    character.move(new Vector3(0, 0, 0.03));
    const rising = character.velocity.y;
    for (let i = 0; i < 3; i++) character.update(renderer!, scene!, 1 / 60);
    expect(character.position.equals(before)).toBe(true);
    expect(warn).toHaveBeenCalledTimes(1);
    expect(warn.mock.calls[0]![0]).toMatch(/^CharacterController: update\(renderer/);
    // Nothing is lost: neither speed nor the pending move.
    expect(character.velocity).toMatchObject({ x, y: rising });
    expect(rising).toBeGreaterThan(5);
    character.update({}, {}, 1 / 60);
    expect(character.position.z - before.z).toBeCloseTo(0.03, 6);
  });

  it("should say once that the collider's rMax is another radius, and stand on that", () => {
    const character = new CharacterController(new AnalyticCollider(floor(), { rMax: 0.5 }), {
      response: new AxisResponse(),
    });
    for (let i = 0; i < 60; i++) character.update({}, {}, 1 / 60);
    expect(warn).toHaveBeenCalledTimes(1);
    expect(Math.abs(character.position.y)).toBeLessThan(0.005);
  });

  it('should draw at most four times a frame, and once where it stands', () => {
    const { character, collider } = standing();
    const draws = collider.draws;
    character.update({}, {}, 1 / 60);
    expect(collider.draws - draws).toBe(1);
    character.move(new Vector3(50, 0, 0));
    character.update({}, {}, 1 / 60);
    expect(collider.draws - draws).toBe(5);
  });
});
