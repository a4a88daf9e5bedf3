import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { AxisMaxima, AxisResponse, CharacterController, SurfaceField } from 'three-cube-collider';
import type { CharacterCollider } from 'three-cube-collider';
import { decodeSurface } from '../../src/cube/encoding.js';
import { bytesEach } from '../support/bytesEach.js';

/** What V8 wraps a double in that is handed from function to function; a Vector3 is six of these. */
const NUMBER = 16;

const SURVEY = { moved: false, changed: false, deforms: false, sensors: [] };

function standing(found: Partial<CharacterCollider>): CharacterController {
  const collider: CharacterCollider = {
    position: new Vector3(),
    output: found.maxima ? 'axis' : 'surface',
    far: 1.8,
    autoFar: false,
    field: null,
    maxima: null,
    readback: 'sync',
    update: () => true,
    survey: () => SURVEY,
    invalidate: () => {},
    exclude: () => {},
    include: () => {},
    ...found,
  };
  const character = new CharacterController(collider, { response: new AxisResponse() });
  character.walk(new Vector3(0.001, 0, 0));
  return character;
}

describe('hot paths', () => {
  it('should make no object in a step on the paper’s maxima', () => {
    const maxima = new AxisMaxima(0.175, 0.35);
    maxima.center.set(0, 0.35, 0);
    maxima.set(3, 0.05, 15, 15, 32);
    const character = standing({ maxima });
    expect(bytesEach(20_000, () => character.step(1 / 60))).toBeLessThan(8 * NUMBER);
  });

  it('should make no object in a step on a surface field', () => {
    const center = new Vector3(0, 0.3, 0);
    const field = SurfaceField.from(
      ({ y }, direction) => ({ distance: y / -direction[1], normal: [0, 1, 0] }),
      { resolution: 16, far: 1.8, center },
    );
    for (let i = 0; i < field.count; i++)
      if (!(field.distance[i]! > 0)) field.distance[i] = Infinity;
    const character = standing({ field });
    expect(bytesEach(1_000, () => character.step(1 / 60))).toBeLessThan(11 * NUMBER);
  });

  it('should make no object when a read is decoded', () => {
    const field = new SurfaceField(32, 2);
    const floats = new Float32Array(4 * field.count).fill(1);
    const bytes = new Uint8Array(4 * field.count).fill(7);
    expect(bytesEach(200, () => decodeSurface('RGBA32F', floats, field))).toBeLessThan(256);
    expect(bytesEach(200, () => decodeSurface('RGBA16F', floats, field))).toBeLessThan(256);
    expect(bytesEach(200, () => decodeSurface('RGBA8', bytes, field))).toBeLessThan(256);
  });
});
