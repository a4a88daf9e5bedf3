import {
  DataTexture,
  EquirectangularReflectionMapping,
  LinearFilter,
  type Material,
  MeshStandardMaterial,
  SRGBColorSpace,
} from 'three';

/** Sky, horizon and ground, sRGB. */
const [ZENITH, HORIZON, GROUND] = [
  [96, 148, 196],
  [216, 226, 224],
  [150, 132, 106],
] as const;
const [WIDTH, HEIGHT] = [64, 32];
/** Metal from here on shows mostly what it mirrors. */
const METAL = 0.2;

/**
 * Gives metal something to mirror, without which it is black wherever no sun is: exporters leave many a wall as the metal
 * that glTF takes for granted.
 */
export function mirrorSky(materials: Iterable<Material>): void {
  let sky: DataTexture | null = null;
  for (const material of materials) {
    if (!(material instanceof MeshStandardMaterial)) continue;
    if (material.metalness < METAL || material.envMap !== null) continue;
    material.envMap = sky ??= createSky();
  }
}

function createSky(): DataTexture {
  const data = new Uint8Array(4 * WIDTH * HEIGHT);
  for (let row = 0; row < HEIGHT; row++) {
    // From below upward.
    const up = (2 * (row + 0.5)) / HEIGHT - 1;
    const [far, part] = up > 0 ? [ZENITH, Math.sqrt(up)] : [GROUND, Math.min(1, -6 * up)];
    const color = HORIZON.map((value, k) => value + (far[k]! - value) * part);
    for (let column = 0; column < WIDTH; column++)
      data.set([...color, 255], 4 * (row * WIDTH + column));
  }
  const sky = new DataTexture(data, WIDTH, HEIGHT);
  sky.mapping = EquirectangularReflectionMapping;
  sky.colorSpace = SRGBColorSpace;
  sky.magFilter = sky.minFilter = LinearFilter;
  sky.needsUpdate = true;
  return sky;
}
