// A valley in 3D Tiles, for the guide: 16 tiles around a meadow, each coarse and fine.

import { mkdir, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { Document, Logger, NodeIO } from '@gltf-transform/core';
import { KHRMeshQuantization } from '@gltf-transform/extensions';
import { quantize } from '@gltf-transform/functions';
import { fbm, hash, smootherstep } from '../noise.mjs';

/** Tiles along an edge, and how wide each is, metres. */
const TILES = 4;
const WIDTH = 48;
/** Cells along a tile's edge, sides of a tree's cone, and how far from the truth its surface may be, metres. */
const LEVELS = {
  coarse: { cells: 6, sides: 4, error: 2 },
  fine: { cells: 18, sides: 6, error: 0 },
};
/** Tiles of both kinds meet at seams; what hangs down from their edges closes these, metres. */
const SKIRT = 1.5;
const TREES = 9;

const MEADOW = [0.34, 0.47, 0.16];
const HEATH = [0.52, 0.47, 0.2];
const ROCK = [0.46, 0.43, 0.41];
const PATH = [0.72, 0.6, 0.42];
const FIR = [0.16, 0.3, 0.16];
const TRUNK = [0.3, 0.19, 0.11];

/** Where the path runs, by z. */
const path = (z) => 9 * Math.sin(z / 21) + 4 * Math.sin(z / 9 + 1);
const besidePath = (x, z) => smootherstep(1.5, 7, Math.abs(x - path(z)));

/** Hills rise from both sides of the path. */
function height(x, z) {
  const hills = fbm(x / 26 + 60, z / 26 + 60, { seed: 11, octaves: 4 }) - 0.4;
  const aside = Math.abs(x - path(z)) / 60;
  const floor = 3 * Math.sin(z / 30);
  return floor + besidePath(x, z) * (9 * hills + 26 * Math.max(0, aside - 0.12) ** 1.5);
}

const mix = (a, b, t) => a.map((value, k) => value + (b[k] - value) * t);

function color(x, z) {
  const slope = Math.hypot(
    height(x + 1, z) - height(x - 1, z),
    height(x, z + 1) - height(x, z - 1),
  );
  const speckle = 0.88 + 0.24 * hash(Math.round(x * 2), Math.round(z * 2), 9);
  const ground = mix(MEADOW, HEATH, smootherstep(2, 9, height(x, z)));
  const bare = mix(ground, ROCK, smootherstep(1.1, 1.9, slope));
  const trodden = 1 - smootherstep(1.2, 2.4, Math.abs(x - path(z)));
  return mix(bare, PATH, trodden).map((value) => Math.min(1, value * speckle));
}

/** Vertices and triangles, as they are added. */
class Sheet {
  positions = [];
  colors = [];
  indices = [];

  vertex(position, tint) {
    this.positions.push(...position);
    this.colors.push(...tint.map((value) => Math.round(255 * value)), 255);
    return this.positions.length / 3 - 1;
  }

  /** From a ring upward to a point, or to another ring. */
  cone([x, y, z], radius, top, sides, tint, roof = 0, phase = 0) {
    const ring = (r, y) =>
      Array.from({ length: sides }, (_, i) => {
        const angle = 2 * Math.PI * (i / sides + phase);
        return this.vertex([x + r * Math.cos(angle), y, z - r * Math.sin(angle)], tint);
      });
    const low = ring(radius, y);
    const high = roof > 0 ? ring(roof, y + top) : null;
    const tip = high ?? [
      this.vertex(
        [x, y + top, z],
        tint.map((value) => 1.25 * value),
      ),
    ];
    for (let i = 0; i < sides; i++) {
      const k = (i + 1) % sides;
      this.indices.push(low[i], low[k], tip[high ? k : 0]);
      if (high) this.indices.push(low[i], high[k], high[i]);
    }
  }
}

/** The ground of the tile whose north-western corner is at x and z. */
function ground(sheet, x, z, cells) {
  const at = (i, j) => [x + (i / cells) * WIDTH, z + (j / cells) * WIDTH];
  const grid = Array.from({ length: (cells + 1) ** 2 }, (_, n) => {
    const [px, pz] = at(n % (cells + 1), Math.floor(n / (cells + 1)));
    return sheet.vertex([px, height(px, pz), pz], color(px, pz));
  });
  const vertex = (i, j) => grid[j * (cells + 1) + i];
  for (let j = 0; j < cells; j++)
    for (let i = 0; i < cells; i++) {
      const [a, b] = [vertex(i, j), vertex(i, j + 1)];
      const [c, d] = [vertex(i + 1, j + 1), vertex(i + 1, j)];
      sheet.indices.push(a, b, c, a, c, d);
    }
  // Around the edge, counter-clockwise seen from above.
  const edge = [];
  for (let k = 0; k < cells; k++) edge.push([0, k]);
  for (let k = 0; k < cells; k++) edge.push([k, cells]);
  for (let k = 0; k < cells; k++) edge.push([cells, cells - k]);
  for (let k = 0; k < cells; k++) edge.push([cells - k, 0]);
  const hem = edge.map(([i, j]) => {
    const [px, pz] = at(i, j);
    return sheet.vertex([px, height(px, pz) - SKIRT, pz], color(px, pz));
  });
  edge.forEach(([i, j], k) => {
    const next = (k + 1) % edge.length;
    const [a, b] = [vertex(i, j), vertex(...edge[next])];
    sheet.indices.push(a, hem[k], hem[next], a, hem[next], b);
  });
}

/** Firs, never on the path. */
function trees(sheet, column, row, x, z, sides) {
  for (let n = 0; n < TREES; n++) {
    const [px, pz] = [1, 2].map((k) => hash(n, k, 31 * row + column) * (WIDTH - 3) + 1.5);
    const [tx, tz] = [x + px, z + pz];
    if (Math.abs(tx - path(tz)) < 3.5) continue;
    const size = 0.9 + 0.8 * hash(n, 3, 31 * row + column);
    const foot = [tx, height(tx, tz) - 0.3, tz];
    const on = (y) => [tx, foot[1] + y * size, tz];
    if (sides > 4) {
      sheet.cone(foot, 0.22 * size, 1.9 * size, 4, TRUNK, 0.16 * size);
      sheet.cone(on(1.5), 1.5 * size, 2.6 * size, sides, FIR, 0, hash(n, 4));
      sheet.cone(on(3), 1.1 * size, 2.6 * size, sides, FIR, 0, hash(n, 5));
    } else sheet.cone(on(1.2), 1.4 * size, 4.4 * size, sides, FIR, 0, hash(n, 4));
  }
}

/** A file without normals: flat shaded, as glTF has it. */
async function write({ positions, colors, indices }) {
  const document = new Document().setLogger(new Logger(Logger.Verbosity.WARN));
  const buffer = document.createBuffer();
  const accessor = (type, array) =>
    document.createAccessor().setBuffer(buffer).setType(type).setArray(array);
  const material = document.createMaterial().setMetallicFactor(0).setRoughnessFactor(1);
  const primitive = document
    .createPrimitive()
    .setMaterial(material)
    .setIndices(accessor('SCALAR', Uint16Array.from(indices)))
    .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions)))
    .setAttribute('COLOR_0', accessor('VEC4', Uint8Array.from(colors)).setNormalized(true));
  const node = document.createNode('tile').setMesh(document.createMesh().addPrimitive(primitive));
  document.getRoot().setDefaultScene(document.createScene().addChild(node));
  document.getRoot().getAsset().generator = 'three-cube-collider scripts/level';
  await document.transform(quantize());
  return new NodeIO().registerExtensions([KHRMeshQuantization]).writeBinary(document);
}

/** Middle and half axes of what holds all of a sheet; 3D Tiles have Z upward. */
function box({ positions }) {
  const [low, high] = [Math.min, Math.max].map((most) =>
    [0, 1, 2].map((axis) =>
      positions.filter((_, i) => i % 3 === axis).reduce((a, b) => most(a, b)),
    ),
  );
  const [x, y, z] = [0, 1, 2].map((axis) => (low[axis] + high[axis]) / 2);
  const [w, h, d] = [0, 1, 2].map((axis) => (high[axis] - low[axis]) / 2);
  return [x, -z, y, w, 0, 0, 0, d, 0, 0, 0, h].map((value) => Math.round(100 * value) / 100);
}

/** Writes tileset.json and its tiles into a folder; returns the number of bytes. */
export async function buildTiles(folder) {
  await rm(folder, { recursive: true, force: true });
  await mkdir(folder, { recursive: true });
  let bytes = 0;
  const save = async (name, content) => {
    bytes += content.length;
    await writeFile(join(folder, name), content);
  };
  const children = [];
  for (let row = 0; row < TILES; row++)
    for (let column = 0; column < TILES; column++) {
      const [x, z] = [column, row].map((n) => (n - TILES / 2) * WIDTH);
      let tile = null;
      for (const [name, { cells, sides, error }] of Object.entries(LEVELS).reverse()) {
        const sheet = new Sheet();
        ground(sheet, x, z, cells);
        trees(sheet, column, row, x, z, sides);
        const uri = `${name}-${column}-${row}.glb`;
        await save(uri, await write(sheet));
        tile = {
          boundingVolume: { box: box(sheet) },
          geometricError: error,
          refine: 'REPLACE',
          content: { uri },
          ...(tile && { children: [tile] }),
        };
      }
      children.push(tile);
    }
  const half = (TILES * WIDTH) / 2;
  const root = {
    boundingVolume: { box: [0, 0, 10, half, 0, 0, 0, half, 0, 0, 0, 40] },
    geometricError: 20,
    refine: 'ADD',
    children,
  };
  const names = ['3DTILES_content_gltf'];
  const tileset = {
    asset: { version: '1.0' },
    extensionsUsed: names,
    extensionsRequired: names,
    geometricError: 100,
    root,
  };
  await save('tileset.json', `${JSON.stringify(tileset)}\n`);
  return bytes;
}
