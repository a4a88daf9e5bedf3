import { Object3D, Vector3 } from 'three';
import { expect, it } from 'vitest';
import type { Contact } from 'three-cube-collider';
import { GroundSpeed } from '../../demo/avatar/GroundSpeed.js';

const DELTA = 0.1;

/** A walker at rest on `object`. */
function standing(object: Object3D) {
  return {
    velocity: new Vector3(),
    position: new Vector3(1, 2, 3),
    ground: { object } as Contact,
  };
}

it('walking is what is made beside what carries', () => {
  const lift = new Object3D();
  const walker = standing(lift);
  const speed = new GroundSpeed();
  speed.update(walker, DELTA);
  lift.position.set(0.3, 0.5, 0);
  lift.updateMatrixWorld();
  walker.position.set(1.3, 2.5, 3.2);
  expect(speed.update(walker, DELTA)).toBeCloseTo(2);
});

it('a foot that is drawn landing a little late does not walk', () => {
  const walker = standing(new Object3D());
  const speed = new GroundSpeed();
  speed.update(walker, DELTA);
  walker.position.y -= 0.2;
  expect(speed.update(walker, DELTA)).toBe(0);
});
