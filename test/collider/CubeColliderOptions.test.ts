import { describe, expect, it } from 'vitest';
import { CubeCollider, type CubeColliderOptions, DEFAULTS } from 'three-cube-collider';

const wrong: [CubeColliderOptions, RegExp][] = [
  [{ near: 0.5, far: 0.1 }, /"far" must be greater than "near" \(got 0\.5, 0\.1\)/],
  [{ near: 1, far: 1 }, /"far" must be greater than "near"/],
  [{ far: 0 }, /"far" must be a number greater than 0 \(got 0\)/],
  [{ far: NaN }, /"far" must be a number greater than 0 \(got NaN\)/],
  [{ far: Infinity }, /"far" must be a number greater than 0/],
  [{ near: -0.1 }, /"near" must be a number greater than 0/],
  ...[3, 257, 31.5, NaN, -32, '32' as never].map((resolution): [CubeColliderOptions, RegExp] => [
    { resolution },
    /"resolution" must be an integer from 4 to 256/,
  ]),
  ...[0, 3, 8, NaN, '2' as never].map((supersample): [CubeColliderOptions, RegExp] => [
    { supersample: supersample as never },
    /"supersample" must be 1 or 2 or 4/,
  ]),
  [{ output: 'axis', supersample: 2 }, /"supersample" must be 1 in the paper's mode/],
  [{ output: 'axis', rMin: 0.5, rMax: 0.35 }, /"rMax" must be greater than "rMin"/],
  [{ output: 'axis', rMax: -1 }, /"rMax" must be a number greater than 0 \(got -1\)/],
  [{ output: 'axis', near: 0.2 }, /"near" must be at most "rMin"\/√3/],
  [{ output: 'axis', far: 0.2 }, /"far" must be at least "rMax"/],
  [{ output: 'depth' as never }, /"output" must be 'surface' or 'axis' \(got depth\)/],
  [{ readback: 'later' as never }, /"readback" must be 'async' or 'sync'/],
  [{ sides: 'front' as never }, /"sides" must be 'both' or 'drawn'/],
  [{ format: 'RGB565' as never }, /"format" must be 'auto' or 'RGBA32F' or 'RGBA16F' or 'RGBA8'/],
  [{ maxAge: -1 }, /"maxAge" must be a number greater than 0/],
  [{ slack: 0 }, /"slack" must be a number greater than 0/],
];

describe('CubeCollider’s options', () => {
  it.each(wrong)('should refuse %j in one clear message', (options, message) => {
    expect(() => new CubeCollider(options)).toThrow(RangeError);
    expect(() => new CubeCollider(options)).toThrow(message);
    expect(() => new CubeCollider(options)).toThrow(/^CubeCollider: /);
  });

  it('should refuse an option that does not exist, and say which do', () => {
    const wish = { rmax: 3 } as CubeColliderOptions;
    expect(() => new CubeCollider(wish)).toThrow(TypeError);
    expect(() => new CubeCollider(wish)).toThrow(/no option "rmax"; there are .*rMax/);
  });

  it('should refuse a filter that is no function', () => {
    expect(() => new CubeCollider({ filter: true as never })).toThrow(TypeError);
  });

  it('should fill in the defaults', () => {
    const collider = new CubeCollider();
    const { output, resolution, supersample, far, readback, sides, nearRatio } = DEFAULTS.collider;
    expect(collider).toMatchObject({
      output,
      resolution,
      supersample,
      far,
      readback,
      sides,
      near: nearRatio * far,
    });
    expect(collider.field).toBeNull();
    expect(collider.maxima).toBeNull();
    expect(collider.renderTarget).toBeNull();
    expect(collider.isObject3D).toBe(true);
  });

  it('should take the paper’s near, far and reading for the paper’s mode', () => {
    const collider = new CubeCollider({ output: 'axis', rMin: 0.25, rMax: 0.5 });
    expect(collider).toMatchObject({ readback: 'sync', far: 0.5, near: 0.005, format: 'RGBA8' });
    // However thin the shell's inside, near follows rMin.
    const thin = new CubeCollider({ output: 'axis', rMin: 0.001, rMax: 0.5 });
    expect(thin.near).toBeCloseTo(0.001 / Math.sqrt(3), 10);
  });

  it('should accept every resolution from 4 to 256', () => {
    for (const resolution of [4, 5, 31, 128, 256]) {
      expect(new CubeCollider({ resolution }).resolution).toBe(resolution);
    }
  });
});
