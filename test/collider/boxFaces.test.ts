import { BufferAttribute, BufferGeometry, Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { seeded } from '../../e2e/support/axisScenes.js';
import { boxOf, facesOfBox } from '../../src/collider/boxFaces.js';
import { FACE } from '../../src/cube/faces.js';

const FAR = 2;

/** The face in whose pyramid a point is, or -1 if that is cut off before it. */
function faceOf(place: Vector3): number {
  const values = place.toArray();
  const most = Math.max(...values.map(Math.abs));
  const axis = values.findIndex((value) => Math.abs(value) === most);
  return most > FAR ? -1 : 2 * axis + (values[axis]! < 0 ? 1 : 0);
}

describe('the faces that a box reaches into', () => {
  it('should be all that any of its points is in, however it is turned and scaled (seed 5)', () => {
    const random = seeded(5);
    const between = (a: number, b: number) => a + (b - a) * random();
    const center = new Vector3();
    const point = new Vector3();
    let checked = 0;
    for (let i = 0; i < 3000; i++) {
      center.set(between(-50, 50), between(-5, 5), between(-50, 50));
      const least = [between(-2, 0), between(-2, 0), between(-2, 0)];
      const box = [...least, ...least.map((value) => value + 3 * random() ** 3)];
      const matrix = new Matrix4().compose(
        center.clone().add(point.randomDirection().multiplyScalar(3 * random())),
        i % 3 === 0 ? new Quaternion() : new Quaternion().random(),
        new Vector3(between(-2, 2), between(0.1, 2), between(0.1, 2)),
      );
      const mask = facesOfBox(box, matrix, center, FAR);
      for (let k = 0; k < 40; k++) {
        point.fromArray([0, 1, 2].map((axis) => between(box[axis]!, box[axis + 3]!)));
        const face = faceOf(point.applyMatrix4(matrix).sub(center));
        if (face >= 0) expect(mask & (1 << face), `box ${i}`).not.toBe(0);
        if (face >= 0) checked++;
      }
    }
    expect(checked).toBeGreaterThan(20_000);
  });

  it('should not be those behind a floor, nor any of what is out of reach', () => {
    const floor = [-20, -0.1, -20, 20, 0, 20];
    const above = (y: number) => facesOfBox(floor, new Matrix4(), new Vector3(0, y, 0), FAR);
    expect(above(1)).toBe(0b111111 & ~(1 << FACE.PY));
    expect(above(-1)).toBe(0b111111 & ~(1 << FACE.NY));
    expect(above(2.1)).toBe(0);
    const post = [-0.1, -1, -0.1, 0.1, 1, 0.1];
    const aside = new Vector3(-1.5, 0, 0);
    expect(facesOfBox(post, new Matrix4(), aside, FAR)).toBe(1 << FACE.PX);
  });

  it('should be found of vertices as they are now', () => {
    const array = Float32Array.from([0, 1, 2, -3, 4, 5, 6, -7, 8]);
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(array, 3));
    expect([...boxOf(geometry)!]).toEqual([-3, -7, 2, 6, 4, 8]);
    expect(boxOf(geometry)).toBe(boxOf(geometry));
    geometry.translate(1, 0, 0);
    expect([...boxOf(geometry)!]).toEqual([-2, -7, 2, 7, 4, 8]);
    array[0] = NaN;
    geometry.attributes.position!.needsUpdate = true;
    expect(boxOf(geometry)).toBeNull();
  });
});
