import { BoxGeometry, Color, Group, Mesh, MeshStandardMaterial, Texture } from 'three';
import { expect, test } from 'vitest';
import { tintPlain } from '../../demo/level/tintPlain.js';

test('gives what is plainly white a colour, and leaves what somebody coloured', () => {
  const materials = [
    new MeshStandardMaterial(),
    new MeshStandardMaterial({ color: new Color(0.8, 0.8, 0.78) }),
    new MeshStandardMaterial({ map: new Texture() }),
    new MeshStandardMaterial({ vertexColors: true }),
    new MeshStandardMaterial({ color: new Color(0.9, 0.8, 0.6) }),
    new MeshStandardMaterial({ color: new Color(0.2, 0.2, 0.2) }),
  ];
  const before = materials.map(({ color }) => color.getHex());
  tintPlain(new Group().add(...materials.map((material) => new Mesh(new BoxGeometry(), material))));
  const changed = materials.map(({ color }, i) => color.getHex() !== before[i]);
  expect(changed).toEqual([true, true, false, false, false, false]);
  expect(materials[0]!.color.r).toBeLessThan(0.5);
});
