import {
  CanvasTexture,
  DoubleSide,
  Group,
  MathUtils,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  SRGBColorSpace,
} from 'three';
import { assemble, merge, type Materials, slab } from '../pieces.js';
import type { Exhibit } from './Exhibit.js';

const [WIDTH, HEIGHT] = [6.4, 2.4];
/** Pixels a metre. */
const PIXELS = 160;
const PLANKS = 32;
/** The hole's outline from its left foot round to its right one, metres from the middle of the fence's foot. */
const HOLE = [
  [-0.62, -0.1],
  [-0.66, 0.5],
  [-0.78, 0.62],
  [-0.6, 0.95],
  [-0.74, 1.5],
  [-0.5, 1.62],
  [-0.42, 2.02],
  [-0.2, 1.96],
  [0.02, 2.12],
  [0.2, 1.98],
  [0.44, 2.06],
  [0.5, 1.7],
  [0.76, 1.52],
  [0.64, 1.1],
  [0.8, 0.84],
  [0.64, 0.55],
  [0.68, -0.1],
] as const;
const WOOD = ['#a9794f', '#b3845a', '#9c6f49', '#b98c63', '#a37550'];

/** A fence of two triangles: its planks, their tips and the hole through them are an alpha test's. */
export function createFence(material: Materials): Exhibit {
  const fence = new Group();
  fence.name = 'fence';
  const texture = new CanvasTexture(paint());
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 4;
  const planks = new Mesh(
    new PlaneGeometry(WIDTH, HEIGHT).translate(0, HEIGHT / 2, 0),
    new MeshStandardMaterial({ map: texture, alphaTest: 0.5, side: DoubleSide, roughness: 0.85 }),
  );
  planks.name = 'planks';
  planks.castShadow = planks.receiveShadow = true;

  const ends = [-1, 1].map((side) => side * (WIDTH / 2 + 0.18));
  const posts = assemble('fence posts', [
    [merge(...ends.map((x) => slab(0.36, 2.7, 0.36, x).translate(0, 2.6, 0))), material('stone')],
    [merge(...ends.map((x) => slab(0.5, 0.14, 0.5, x).translate(0, 2.72, 0))), material('tile')],
  ]);
  fence.add(planks, posts);
  return { object: fence };
}

/** Pointed planks on two rails, with a hole that something big has left. */
function paint(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH * PIXELS;
  canvas.height = HEIGHT * PIXELS;
  const context = canvas.getContext('2d')!;
  // From here on in metres, upward from the middle of the foot.
  context.setTransform(PIXELS, 0, 0, -PIXELS, canvas.width / 2, canvas.height);
  const polygon = (points: readonly (readonly [number, number])[]) => {
    context.beginPath();
    points.forEach(([x, y]) => context.lineTo(x, y));
    context.closePath();
    context.fill();
  };
  const random = MathUtils.seededRandom;
  random(5);
  const wide = WIDTH / PLANKS;
  for (let i = 0; i < PLANKS; i++) {
    const left = -WIDTH / 2 + i * wide;
    const top = 2.12 + 0.08 * random();
    context.fillStyle = WOOD[Math.floor(random() * WOOD.length)]!;
    polygon([
      [left, 0],
      [left, top],
      [left + wide / 2, top + 0.15],
      [left + wide, top],
      [left + wide, 0],
    ]);
    // Its grain, and the dark joint to the next.
    context.globalAlpha = 0.14;
    context.fillStyle = '#4a2f1d';
    for (let k = 0; k < 5; k++) {
      const x = left + wide * random();
      const y = top * random();
      context.fillRect(x, y * 0.5, 0.008, top - y);
    }
    context.globalAlpha = 0.55;
    context.fillRect(left + wide - 0.014, 0, 0.014, top);
    context.globalAlpha = 1;
  }
  for (const y of [0.5, 1.65]) {
    context.fillStyle = '#8a5f3d';
    context.fillRect(-WIDTH / 2, y, WIDTH, 0.14);
    context.fillStyle = '#3a3532';
    for (let i = 0; i < PLANKS; i++) {
      context.fillRect(-WIDTH / 2 + (i + 0.5) * wide - 0.012, y + 0.058, 0.024, 0.024);
    }
  }
  // Lighter where the wood broke, then nothing.
  context.lineJoin = 'bevel';
  context.strokeStyle = '#dcb98c';
  context.lineWidth = 0.1;
  context.globalCompositeOperation = 'source-atop';
  context.beginPath();
  HOLE.forEach(([x, y]) => context.lineTo(x, y));
  context.stroke();
  context.globalCompositeOperation = 'destination-out';
  polygon(HOLE);
  return canvas;
}
