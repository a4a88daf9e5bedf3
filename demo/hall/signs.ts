import {
  type BufferGeometry,
  CanvasTexture,
  type Mesh,
  MeshStandardMaterial,
  SRGBColorSpace,
} from 'three';
import { advance, GLYPHS } from '../../scripts/level/glyphs.mjs';
import { MATERIALS } from '../../scripts/level/palette.mjs';
import { assemble, merge, type Materials, slab } from '../pieces.js';

/** A plate on a post, or a plate alone, printed on both sides. */
export interface Sign {
  caption: string;
  text: string;
  /** Name in the level's palette. */
  family: keyof typeof MATERIALS;
  x: number;
  z: number;
  /** Of the plate's lower edge, metres; a plate without a post has one. */
  above?: number;
  /** How many times as large as the others. */
  size?: number;
}

/** Of the plates, metres; of their pictures, pixels. */
const [WIDTH, HEIGHT] = [0.9, 0.45];
const CELL = [512, 256] as const;
const COLUMNS = 2;
const [PAPER, INK] = ['#f6ecd6', '#342e2a'];

/** All signs in one mesh, in the style of the level's. */
export function createSigns(signs: readonly Sign[], material: Materials): Mesh {
  const canvas = document.createElement('canvas');
  const rows = Math.ceil(signs.length / COLUMNS);
  canvas.width = CELL[0] * COLUMNS;
  canvas.height = CELL[1] * rows;
  const context = canvas.getContext('2d')!;
  context.lineCap = context.lineJoin = 'round';
  const plates = signs.map((sign, i) => {
    const [column, row] = [i % COLUMNS, Math.floor(i / COLUMNS)];
    paint(context, sign, column * CELL[0], row * CELL[1]);
    return createPlate(sign, column / COLUMNS, 1 - (row + 1) / rows, 1 / COLUMNS, 1 / rows);
  });
  const posts = signs
    .filter(({ above }) => above === undefined)
    .map(({ x, z }) => slab(0.05, 1.1, 0.02, x, z).translate(0, 1.1, 0));
  const picture = new CanvasTexture(canvas);
  picture.colorSpace = SRGBColorSpace;
  picture.anisotropy = 8;
  const mesh = assemble('hall signs', [
    [merge(...plates), new MeshStandardMaterial({ map: picture, roughness: 0.7 })],
    [merge(...posts), material('metal')],
  ]);
  return mesh;
}

/** A thin box whose north and south faces show its cell of the picture; the rest a patch of its band. */
function createPlate(
  { x, z, above = 1.05, size = 1 }: Sign,
  u: number,
  v: number,
  du: number,
  dv: number,
): BufferGeometry {
  const plate = slab(size * WIDTH, size * HEIGHT, 0.03, x, z);
  plate.translate(0, above + size * HEIGHT, 0);
  const { uv, normal } = plate.attributes;
  for (let i = 0; i < uv!.count; i++) {
    // A box's faces come with their pictures upright to who looks at them.
    if (Math.abs(normal!.getZ(i)) > 0.5) {
      const corner = i % 4;
      uv!.setXY(i, u + du * (corner % 2), v + dv * (corner < 2 ? 1 : 0));
    } else uv!.setXY(i, u + 0.02 * du, v + 0.98 * dv);
  }
  return plate;
}

function paint(context: CanvasRenderingContext2D, sign: Sign, x: number, y: number): void {
  const [width, height] = CELL;
  context.fillStyle = MATERIALS[sign.family].color;
  context.fillRect(x, y, width, height);
  context.fillStyle = PAPER;
  context.fillRect(x + 12, y + 84, width - 24, height - 96);
  write(context, sign.caption, x + width / 2, y + 44, 46, 452, 10, INK);
  write(context, sign.text, x + width / 2, y + 164, 92, 440, 17, INK);
}

/** Text centred on (x, y), capitals `height` high, no wider than `width`. */
function write(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  height: number,
  width: number,
  weight: number,
  color: string,
): void {
  const units = [...text].reduce((sum, letter) => sum + advance(letter), -2);
  const scale = Math.min(height / 6, width / units);
  context.strokeStyle = color;
  context.lineWidth = Math.min(weight, 1.3 * scale);
  let left = x - (units * scale) / 2;
  for (const letter of text) {
    const lines: number[][][] = GLYPHS[letter as keyof typeof GLYPHS];
    for (const line of lines) {
      context.beginPath();
      for (const [gx, gy] of line) context.lineTo(left + gx! * scale, y + (gy! - 3) * scale);
      context.stroke();
    }
    left += advance(letter) * scale;
  }
}
