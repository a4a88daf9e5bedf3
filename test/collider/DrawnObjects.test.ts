import { Layers, type Object3D, Scene, ShaderMaterial, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { DrawnObjects } from '../../src/collider/DrawnObjects.js';
import { Selection } from '../../src/collider/Selection.js';
import { SurfaceField } from '../../src/field/SurfaceField.js';
import { box, skinned } from '../support/meshes.js';

const origin = new Vector3();
const FAR = 2;

describe('the objects of a draw', () => {
  const proxiesOf = (...objects: Object3D[]) => {
    const selection = new Selection();
    const rules = { layers: new Layers(), filter: null, excluded: new Set<Object3D>() };
    selection.select(new Scene().add(...objects), origin, FAR, rules, (source) => source);
    return selection.proxies;
  };

  it('should be numbered as they are drawn, with their matrices of that moment', () => {
    const crate = box();
    const skin = skinned();
    crate.position.x = 1;
    const proxies = proxiesOf(crate, skin);
    expect(proxies.map(({ drawNumber }) => drawNumber)).toEqual([1, 2]);
    const table = new DrawnObjects();
    expect(table.take(proxies)).toBe(1);
    crate.position.x = 2;
    crate.updateMatrixWorld();
    const field = new SurfaceField(4, FAR);
    table.handTo(field);
    expect(field.objects).toEqual([crate, skin]);
    expect(field.rigid).toEqual([true, false]);
    expect(field.matrices[0]!.elements[12]).toBe(1);
  });

  it('should be those of the field’s own draw alone, when more, fewer or none come', () => {
    const table = new DrawnObjects();
    const field = new SurfaceField(4, FAR);
    const [a, b, c] = [box(), box(), box()];
    for (const objects of [[a, b], [b, a], [c], [a, b, c], [a, b, c]]) {
      table.take(proxiesOf(...objects));
      table.handTo(field);
      expect(field.objects).toEqual(objects);
      expect(field.rigid).toEqual(objects.map(() => true));
    }
    table.handTo(field);
    expect(field.objects).toEqual([]);
  });

  it('should tell the shared material whose turn it is, and leave others alone', () => {
    const [, second] = proxiesOf(box(), box());
    const shared = new ShaderMaterial({ uniforms: { object: { value: 7 } } });
    const other = new ShaderMaterial();
    for (const material of [shared, other]) {
      second!.onBeforeRender(
        ...([null, null, null, null, material, null] as unknown as Parameters<
          Object3D['onBeforeRender']
        >),
      );
    }
    expect(shared.uniforms.object!.value).toBe(2);
    expect([shared.uniformsNeedUpdate, other.uniformsNeedUpdate]).toEqual([true, false]);
  });
});
