import {
  Color,
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  SRGBColorSpace,
} from 'three';

/** Two by two tiles of two colours. */
export function checkers(dark: string, light: string): DataTexture {
  const size = 64;
  const data = new Uint8Array(4 * size * size);
  const tones = [dark, light].map((hex) => new Color().setStyle(hex).getHex());
  for (let i = 0; i < size * size; i++) {
    const [x, y] = [i % size, Math.floor(i / size)];
    const tone = tones[(x < size / 2 ? 0 : 1) ^ (y < size / 2 ? 0 : 1)]!;
    // A thin joint between the tiles.
    const joint = x % (size / 2) === 0 || y % (size / 2) === 0 ? 0.86 : 1;
    for (let k = 0; k < 3; k++) data[4 * i + k] = joint * ((tone >> (16 - 8 * k)) & 255);
    data[4 * i + 3] = 255;
  }
  const texture = new DataTexture(data, size, size);
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
