import { type Material, MeshBasicMaterial } from 'three';
import { describe, expect, it } from 'vitest';
import { createObjectProxy, type ObjectProxy } from '../../src/collider/objectProxy.js';
import { DrawnProxies } from '../../src/webgpu/DrawnProxies.js';
import { box } from '../support/meshes.js';

/** A proxy as it was dressed, and how often it said that it is gone. */
function dressed(source = box(), worn: Material | Material[] = new MeshBasicMaterial()) {
  const proxy = createObjectProxy(source);
  proxy.material = worn;
  const seen = { proxy, gone: 0, users: 0 };
  const listen = (object: ObjectProxy | typeof source, tell: () => void) =>
    object.addEventListener('dispose' as never, tell as never);
  listen(source, () => seen.users++);
  listen(proxy, () => seen.gone++);
  return seen;
}

describe('what three keeps for the objects of a cubemap', () => {
  it('should be given back of those out of reach for long, and of no others', () => {
    const drawn = new DrawnProxies();
    const [near, left] = [dressed(), dressed()];
    drawn.note([near.proxy, left.proxy]);
    for (let i = 0; i < 500; i++) drawn.note([near.proxy]);
    expect([near.gone, left.gone]).toEqual([0, 0]);
    for (let i = 0; i < 200; i++) drawn.note([near.proxy]);
    expect([near.gone, left.gone]).toEqual([0, 1]);
    drawn.note([left.proxy]);
    drawn.clear();
    drawn.clear();
    expect([near.gone, left.gone]).toEqual([1, 2]);
    // The user's own objects are told nothing.
    expect([near.users, left.users]).toEqual([0, 0]);
  });

  it('should be kept where it is a program of its own', () => {
    const drawn = new DrawnProxies();
    const derived = Object.assign(new MeshBasicMaterial(), { beforeTurn: () => {} });
    const own = dressed(box(), derived);
    const one = dressed(box(), [new MeshBasicMaterial(), derived]);
    drawn.note([own.proxy, one.proxy]);
    for (let i = 0; i < 2000; i++) drawn.note([]);
    expect([own.gone, one.gone]).toEqual([0, 0]);
  });

  it('should be given back of those whose material is disposed of', () => {
    const drawn = new DrawnProxies();
    const source = new MeshBasicMaterial();
    const all = [dressed(box(source)), dressed(box(new MeshBasicMaterial(), source)), dressed()];
    drawn.note(all.map(({ proxy }) => proxy));
    drawn.free(source);
    drawn.free(source);
    expect(all.map(({ gone }) => gone)).toEqual([1, 1, 0]);
  });
});
