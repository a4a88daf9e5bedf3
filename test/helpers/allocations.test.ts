import { InstancedMesh, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { SurfaceField } from 'three-cube-collider';
import {
  CharacterHelper,
  ContactsHelper,
  FreeSpaceHelper,
  SurfelsHelper,
} from 'three-cube-collider/helpers';

/** What V8 wraps a double in that is handed from function to function. */
const NUMBER = 16;

const character = {
  body: { position: new Vector3(1, 0, 0), radius: 0.35, height: 1.8 },
  position: new Vector3(1, 0, 0),
  up: new Vector3(0, 1, 0),
  skin: 0.02,
  slopeLimit: 0.9,
  ready: true,
  grounded: true,
  squeezed: false,
  contacts: [new Vector3(0, 1, 0), new Vector3(1, 0, 0), new Vector3(0, -1, 0)].map((normal) => ({
    point: normal.clone().negate(),
    normal,
    gap: 0.02,
    object: null,
    instance: 0,
  })),
};

function fieldAt(x: number): SurfaceField {
  return SurfaceField.from((_, [, y]) => (y < 0 ? { distance: 1 / -y, normal: [0, 1, 0] } : null), {
    resolution: 16,
    far: 3,
    center: new Vector3(x, 1, 0),
  });
}

/** Bytes of heap that each call leaves behind: the least of several looks, since all else only adds. */
function bytesEach(calls: number, run: (i: number) => void): number {
  for (let i = 0; i < calls; i++) run(i);
  let least = Infinity;
  for (let trial = 0; trial < 5; trial++) {
    const before = process.memoryUsage().heapUsed;
    for (let i = 0; i < calls; i++) run(i);
    const grown = process.memoryUsage().heapUsed - before;
    if (grown >= 0) least = Math.min(least, grown / calls);
  }
  return least;
}

describe('the helpers', () => {
  it('should make no object in a frame', () => {
    const body = new CharacterHelper(character);
    const contacts = new ContactsHelper(character);
    const each = bytesEach(20_000, () => {
      body.update();
      contacts.update();
    });
    expect(each).toBeLessThan(8 * NUMBER);
  });

  it('should make no object for a new field', () => {
    const fields = [fieldAt(0), fieldAt(0.5)];
    const collider = { field: fields[0]! };
    const surfels = new SurfelsHelper(collider);
    const free = new FreeSpaceHelper(collider);
    const each = bytesEach(600, (i) => {
      collider.field = fields[i % 2]!;
      surfels.update();
      free.update();
    });
    // Of 1536 texels.
    expect(each).toBeLessThan(8 * NUMBER);
  });

  it('should do nothing while they are not visible', () => {
    const helper = new SurfelsHelper({ field: fieldAt(0) });
    helper.visible = false;
    helper.update();
    expect(helper.children).toHaveLength(0);
    helper.visible = true;
    helper.update();
    expect(helper.children[0]).toBeInstanceOf(InstancedMesh);
    expect((helper.children[0] as InstancedMesh).count).toBe(6 * 16 ** 2);
  });

  it('should be ghosts, whatever a collider takes for solid', () => {
    const collider = { field: fieldAt(0) };
    for (const helper of [
      new CharacterHelper(character),
      new ContactsHelper(character),
      new SurfelsHelper(collider),
      new FreeSpaceHelper(collider),
    ]) {
      helper.update();
      expect(helper.userData.collider).toBe(false);
      helper.traverse((object) => expect(object.castShadow).toBe(false));
    }
  });
});
