import { Scene } from 'three';
import { CubeCollider, CubeColliderGroup } from 'three-cube-collider';
import { describe, expect, it, vi } from 'vitest';

describe('a group of colliders', () => {
  it('should know its colliders', () => {
    const group = new CubeColliderGroup();
    const [a, b] = [new CubeCollider(), new CubeCollider({ far: 3 })];
    group.add(a).add(b).add(a);
    expect([...group.colliders]).toEqual([a, b]);
    group.remove(a);
    expect([...group.colliders]).toEqual([b]);
    group.dispose();
    expect([...group.colliders]).toEqual([]);
  });

  it('should say which colliders it cannot draw together', () => {
    const group = new CubeColliderGroup();
    expect(() => group.add(undefined as never)).toThrow(/add\(collider\) needs a CubeCollider/);
    for (const options of [{ readback: 'sync' }, { output: 'axis' }] as const) {
      expect(() => group.add(new CubeCollider(options))).toThrow(/readback: 'async'/);
    }
    group.add(new CubeCollider());
    for (const [option, value] of Object.entries({
      resolution: 16,
      supersample: 1,
      sides: 'drawn',
    })) {
      expect(() => group.add(new CubeCollider({ [option]: value }))).toThrow(
        new RegExp(`"${option}" must be the same for all`),
      );
    }
    for (const size of [0, 1.5, 61, NaN]) {
      expect(() => new CubeColliderGroup({ size })).toThrow(/integer from 1 to 60/);
    }
  });

  it('should warn once of a bad frame, and throw nothing', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const group = new CubeColliderGroup<object>();
    expect(group.update({}, undefined as never)).toBe(false);
    expect(group.update(undefined as never, new Scene())).toBe(false);
    group.dispose();
    expect(group.update({}, new Scene())).toBe(false);
    expect(warn.mock.calls.map(([message]) => String(message))).toEqual([
      'CubeColliderGroup: update(renderer, scene) needs a renderer and a scene.',
      'CubeColliderGroup: it was disposed; make a new one.',
    ]);
    warn.mockRestore();
  });
});
