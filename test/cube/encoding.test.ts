import { describe, expect, it } from 'vitest';
import { seeded } from '../../e2e/support/axisScenes.js';
import { decodeSurface, hasIdTexture, TEXEL_FORMATS } from '../../src/cube/encoding.js';
import { texelDirections } from '../../src/cube/texelDirections.js';
import { SurfaceField } from '../../src/field/SurfaceField.js';

const RESOLUTION = 8;
const COUNT = 6 * RESOLUTION * RESOLUTION;

describe.each(TEXEL_FORMATS)('decodeSurface of %s', (format) => {
  const random = seeded(11);
  const upTo = (n: number) => Math.floor(random() * n);

  /** A texel of anything or, four times in ten, of nothing. */
  function texel(): number[] {
    if (random() < 0.4) return [0, 0, 0, 0];
    const sign = random() < 0.5 ? -1 : 1;
    if (format === 'RGBA8') return [upTo(256), 1 + upTo(255), upTo(255), upTo(255)];
    if (format === 'RGBA16F') {
      return [sign * (1 + upTo(2048)), upTo(2048), upTo(2047) - 1023, upTo(2047) - 1023];
    }
    return [0.1 + random(), upTo(4095) * 4096 + upTo(4095), sign * 16 * (1 + upTo(9)), upTo(99)];
  }

  function read() {
    const numbers = Array.from({ length: COUNT }, texel).flat();
    const data = format === 'RGBA8' ? Uint8Array.from(numbers) : Float32Array.from(numbers);
    const ids = hasIdTexture(format) ? Uint32Array.from(numbers, () => upTo(1000)) : null;
    return { data, ids };
  }

  it.each([1, 4])(
    'should leave nothing of what was there before, supersample %i',
    (supersample) => {
      const field = () => new SurfaceField(RESOLUTION, 2, texelDirections(RESOLUTION));
      const used = field();
      for (let round = 0; round < 20; round++) {
        const { data, ids } = read();
        decodeSurface(format, data, used, ids, supersample);
        const fresh = field();
        decodeSurface(format, data, fresh, ids, supersample);
        for (const name of [
          'distance',
          'direction',
          'normal',
          'front',
          'object',
          'instance',
        ] as const) {
          expect(used[name], name).toEqual(fresh[name]);
        }
      }
      const misses = used.distance.filter((distance) => distance === Infinity).length;
      expect(misses).toBeGreaterThan(COUNT / 4);
      expect(misses).toBeLessThan(COUNT / 2);
    },
  );
});
