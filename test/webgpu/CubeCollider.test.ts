import { Scene, Vector3, WebGLRenderer } from 'three';
import { CharacterController, CubeCollider as WebGLCubeCollider } from 'three-cube-collider';
import { CubeCollider } from 'three-cube-collider/webgpu';
import { WebGPURenderer } from 'three/webgpu';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { box } from '../support/meshes.js';

/** A renderer without a GPU: what it says of itself alone. */
const renderer = (of: { prototype: object }, properties: object) =>
  Object.assign(Object.create(of.prototype) as never, properties);

describe('the collider for WebGPURenderer', () => {
  afterEach(() => vi.restoreAllMocks());
  const scene = new Scene().add(box());
  const warned = () => vi.spyOn(console, 'warn').mockImplementation(() => {});

  it('should say at once that it cannot wait for a read, and what to do instead', () => {
    const make = () => new CubeCollider({ readback: 'sync' });
    expect(make).toThrow(TypeError);
    expect(make).toThrow(/^CubeCollider: .*await collider\.updateAsync\(renderer, scene\)/);
    expect(new CubeCollider({ readback: 'async' }).readback).toBe('async');
    expect(() => new CubeCollider({ far: -1 })).toThrow(RangeError);
  });

  it('should tell which import goes with which renderer, once', () => {
    const warn = warned();
    const gpu = new CubeCollider();
    const webgl = new WebGLCubeCollider();
    const old = renderer(WebGLRenderer, { isWebGLRenderer: true });
    const young = Object.create(WebGPURenderer.prototype, { isRenderer: { value: true } }) as never;
    for (let i = 0; i < 3; i++) {
      expect(gpu.update(old, scene)).toBe(false);
      expect(webgl.update(young, scene)).toBe(false);
    }
    const messages = warn.mock.calls.map(([message]) => message as string);
    expect(messages).toEqual([
      expect.stringMatching(/^CubeCollider: .*import CubeCollider from 'three-cube-collider'\./),
      expect.stringMatching(
        /^CubeCollider: .*import CubeCollider from 'three-cube-collider\/webgpu'\./,
      ),
    ]);
    for (let i = 0; i < 3; i++) {
      expect(gpu.update(undefined as never, scene)).toBe(false);
      expect(gpu.update({} as never, scene)).toBe(false);
    }
    expect(warn).toHaveBeenCalledTimes(3);
  });

  it('should hold its character, and say nothing, until the renderer is initialised', async () => {
    const warn = warned();
    const collider = new CubeCollider();
    const character = new CharacterController(collider);
    character.teleport(new Vector3(1, 2, 3));
    const early = { isRenderer: true, initialized: false } as never;
    character.walk(new Vector3(1, 0, 0));
    for (let i = 0; i < 30; i++) character.update(early, scene, 1 / 60);
    expect(character.position.toArray()).toEqual([1, 2, 3]);
    expect(character.ready).toBe(false);
    expect(await collider.updateAsync(early, scene)).toBeNull();
    await collider.compile(early, scene);
    expect(warn).not.toHaveBeenCalled();
    expect(collider.renderTarget).toBeNull();
  });

  it('should warn once of a device that is lost, however it is told', async () => {
    const warn = warned();
    const told = { isRenderer: true, initialized: true, _isDeviceLost: true } as never;
    const lost = Promise.resolve({ reason: 'destroyed' });
    const device = { lost };
    const destroyed = { isRenderer: true, initialized: true, backend: { device } } as never;
    const collider = new CubeCollider();
    for (let i = 0; i < 3; i++) expect(collider.update(told, scene)).toBe(false);
    expect(warn).toHaveBeenCalledTimes(1);
    expect(warn.mock.calls[0]![0]).toMatch(/^CubeCollider: the renderer has lost its device/);
    expect(await new CubeCollider().updateAsync(told, scene)).toBeNull();
    warn.mockClear();
    const other = new CubeCollider();
    // Asked before: it is known a moment later.
    (other as unknown as { faultOf(given: unknown): string | null }).faultOf(destroyed);
    await lost;
    for (let i = 0; i < 3; i++) expect(other.update(destroyed, scene)).toBe(false);
    expect(warn).toHaveBeenCalledTimes(1);
  });
});
