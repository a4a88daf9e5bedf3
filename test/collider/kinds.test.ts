import {
  BoxGeometry,
  InstancedMesh,
  Layers,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  Scene,
  ShaderMaterial,
  Vector3,
} from 'three';
import { describe, expect, it, vi } from 'vitest';
import type { SelectionRules } from '../../src/collider/SceneWalk.js';
import { Selection } from '../../src/collider/Selection.js';

const geometry = new BoxGeometry();
const worn = new MeshBasicMaterial();

type HookArguments = Parameters<Object3D['onBeforeRender']>;

function select(object: Object3D, filter: SelectionRules['filter'] = null) {
  const selection = new Selection();
  const rules = { layers: new Layers(), filter, excluded: new Set<Object3D>() };
  selection.select(new Scene().add(object), new Vector3(), 2, rules, () => worn);
  return selection.proxies;
}

describe('what is selected', () => {
  it('should be an instanced mesh by where its instances are', () => {
    const forest = new InstancedMesh(geometry, worn, 2);
    forest.position.set(10, 0, 0);
    forest.setMatrixAt(0, new Matrix4().makeTranslation(5, 0, 0));
    forest.setMatrixAt(1, new Matrix4().makeTranslation(9, 0, 0));
    expect(select(forest)).toHaveLength(0);
    forest.setMatrixAt(1, new Matrix4().makeTranslation(-9, 0, 0));
    forest.computeBoundingSphere();
    expect(select(forest)).toHaveLength(1);
  });

  it('should be a mesh of which any group is solid', () => {
    const glass = new MeshBasicMaterial({ transparent: true });
    const hidden = new MeshBasicMaterial({ visible: false });
    const count = (...materials: Material[]) => select(new Mesh(geometry, materials)).length;
    expect(count(glass, hidden, worn)).toBe(1);
    expect(count(glass, hidden)).toBe(0);
  });

  it('should be what hangs below an object that the filter refuses', () => {
    const door = new Mesh(geometry, worn);
    const handle = new Mesh(geometry, worn);
    door.add(handle);
    expect(select(door, (object) => object !== door).map((proxy) => proxy.parent)).toEqual([null]);
  });

  it('should be drawn without the user’s own hooks', () => {
    const mesh = new Mesh(geometry, worn);
    mesh.onBeforeRender = vi.fn();
    mesh.onAfterRender = vi.fn();
    const proxy = select(mesh)[0]!;
    const material = new ShaderMaterial();
    for (const hook of ['onBeforeRender', 'onAfterRender'] as const) {
      proxy[hook](...([null, null, null, geometry, material, null] as unknown as HookArguments));
    }
    expect(mesh.onBeforeRender).not.toHaveBeenCalled();
    expect(mesh.onAfterRender).not.toHaveBeenCalled();
  });
});
