// @ts-check
// `npm run build:icons`: public/icon-*.png, from public/icon.svg.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import sharp from 'sharp';
import { root } from './run.mjs';

const drawing = readFileSync(join(root, 'public/icon.svg'), 'utf8');
// A system cuts its own corners: these fill the square, and keep to the middle that no cut reaches.
const square = drawing.replace(' rx="7"', '');

for (const [name, svg, size] of /** @type {const} */ ([
  ['icon-180', square, 180],
  ['icon-192', drawing, 192],
  ['icon-512', drawing, 512],
  ['icon-maskable-512', square, 512],
])) {
  await sharp(Buffer.from(svg), { density: (72 * size) / 32 })
    .resize(size, size)
    .png({ palette: true, compressionLevel: 9 })
    .toFile(join(root, `public/${name}.png`));
}
