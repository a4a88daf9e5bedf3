// The geometry kit: a shape gathers convex polygons, wound counter-clockwise seen from outside, by material.

const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const normalize = (a) => {
  const length = Math.hypot(...a);
  return [a[0] / length, a[1] / length, a[2] / length];
};

/** Texture repeats every so many metres, for every material without its own UVs. */
export const TEXTURE_SIZE = 2;

/** Box faces are cut into cells no larger than this, metres, so that baked occlusion has vertices to live on. */
const CELL = 2.5;
/** Walls standing on the ground are also cut here, metres: occlusion is strongest below. */
const SKIRT = 0.4;
/** Half a plank of the wood texture, metres. */
const PLANK = 0.1;
/** How deep pieces that stand on the ground reach into it, metres: no seam, no coplanar faces. */
export const SUNK = -0.02;

/** `[from, to]` with the wanted cuts inside it, and more until no cell is larger than `CELL`. */
function cutLines(from, to, cuts = []) {
  const stops = [from, ...cuts.filter((c) => c > from && c < to).sort((a, b) => a - b), to];
  const lines = [from];
  for (let i = 1; i < stops.length; i++) {
    const pieces = Math.ceil((stops[i] - stops[i - 1]) / CELL - 1e-6);
    for (let k = 1; k < pieces; k++)
      lines.push(stops[i - 1] + ((stops[i] - stops[i - 1]) * k) / pieces);
    lines.push(stops[i]);
  }
  return lines;
}

/** A material for every side: `'stone'` or `{ top, side, bottom }`, those left out falling back to `side`. */
const pick = (materials, normal) => {
  if (typeof materials === 'string') return materials;
  const { side, top = side, bottom = side } = materials;
  return normal[1] > 0.3 ? top : normal[1] < -0.3 ? bottom : side;
};

export class Shape {
  /** @param name the node's name in the file. */
  constructor(name) {
    this.name = name;
    /** Material name to `{ positions, normals, uvs, colors, anchors, indices }`, flat arrays. */
    this.parts = new Map();
    this.place();
  }

  /** Everything added from now on is turned about Y by `quarters` × 90° (exactly), then moved. */
  place(x = 0, y = 0, z = 0, quarters = 0) {
    this.frame = { x, y, z, quarters: ((quarters % 4) + 4) % 4 };
    return this;
  }

  #turn([x, y, z]) {
    switch (this.frame.quarters) {
      case 1:
        return [z, y, -x];
      case 2:
        return [-x, y, -z];
      case 3:
        return [-z, y, x];
      default:
        return [x, y, z];
    }
  }

  /**
   * Adds one convex, planar polygon. The first vertex must not lie on a line with the second and third, nor with the
   * last two: the polygon is cut into a fan from it.
   * `uvs` in repeats, else projected along the plane in metres; `normals` else the plane's; `tints` [r, g, b] 0 to 1;
   * `grain` { axis, middle }: the texture's v runs along that axis, its first plank over the middle. `round`: part of a
   * round thing, whose corners look alike from every polygon that they belong to.
   */
  polygon(materials, points, { normals, uvs, tints, grain, round } = {}) {
    const { x, y, z } = this.frame;
    const world = points.map((p) => {
      const turned = this.#turn(p);
      return [turned[0] + x, turned[1] + y, turned[2] + z];
    });
    const flat = normalize(cross(sub(world[1], world[0]), sub(world[2], world[0])));
    const level = Math.abs(flat[1]) > 0.999;
    let uAxis = level ? [1, 0, 0] : normalize(cross([0, 1, 0], flat));
    let vAxis = level ? [0, 0, 1] : cross(uAxis, flat);
    let origin = [0, 0, 0];
    const along = grain && this.#turn(grain.axis);
    if (along && Math.abs(dot(along, flat)) < 0.1) {
      vAxis = along;
      uAxis = cross(flat, along);
      const turned = this.#turn(grain.middle);
      origin = sub(
        [turned[0] + x, turned[1] + y, turned[2] + z],
        uAxis.map((value) => value * PLANK),
      );
    }
    const middle = world
      .reduce((sum, p) => [sum[0] + p[0], sum[1] + p[1], sum[2] + p[2]], [0, 0, 0])
      .map((value) => value / world.length);

    const material = pick(materials, flat);
    if (!this.parts.has(material))
      this.parts.set(material, {
        positions: [],
        normals: [],
        uvs: [],
        colors: [],
        anchors: [],
        indices: [],
      });
    const part = this.parts.get(material);
    const first = part.positions.length / 3;
    world.forEach((p, i) => {
      part.positions.push(...p);
      part.normals.push(...(normals ? this.#turn(normals[i]) : flat));
      const q = sub(p, origin);
      part.uvs.push(
        ...(uvs ? uvs[i] : [dot(q, uAxis) / TEXTURE_SIZE, dot(q, vAxis) / TEXTURE_SIZE]),
      );
      part.colors.push(...(tints?.[i] ?? [1, 1, 1]));
      part.anchors.push(...(round ? p : middle));
    });
    for (let i = 2; i < points.length; i++) part.indices.push(first, first + i - 1, first + i);
    return this;
  }

  /**
   * A box from corner to corner. `cuts` { x, y, z }: lines where a neighbour's vertices lie, to leave no T-junction.
   * Wood runs along the longest side, or along `cuts.grain`, an axis' number.
   */
  box(materials, [x0, y0, z0], [x1, y1, z1], cuts = {}) {
    const sizes = [x1 - x0, y1 - y0, z1 - z0];
    const longest = cuts.grain ?? sizes.indexOf(Math.max(...sizes));
    const wooden = materials === 'wood' || materials.top === 'wood';
    const grain = wooden && {
      axis: [0, 1, 2].map((axis) => (axis === longest ? 1 : 0)),
      middle: [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2],
    };
    const xs = cutLines(x0, x1, cuts.x);
    const ys = cutLines(y0, y1, [...(cuts.y ?? []), ...(y0 <= 0 && y1 > 0.9 ? [SKIRT] : [])]);
    const zs = cutLines(z0, z1, cuts.z);
    const cells = (a, b, face) => {
      for (let i = 1; i < a.length; i++)
        for (let j = 1; j < b.length; j++)
          this.polygon(materials, face(a[i - 1], a[i], b[j - 1], b[j]), { grain });
    };
    cells(zs, ys, (a, b, c, d) => [
      [x1, c, b],
      [x1, c, a],
      [x1, d, a],
      [x1, d, b],
    ]);
    cells(zs, ys, (a, b, c, d) => [
      [x0, c, a],
      [x0, c, b],
      [x0, d, b],
      [x0, d, a],
    ]);
    cells(xs, zs, (a, b, c, d) => [
      [a, y1, d],
      [b, y1, d],
      [b, y1, c],
      [a, y1, c],
    ]);
    cells(xs, zs, (a, b, c, d) => [
      [a, y0, c],
      [b, y0, c],
      [b, y0, d],
      [a, y0, d],
    ]);
    cells(xs, ys, (a, b, c, d) => [
      [a, c, z1],
      [b, c, z1],
      [b, d, z1],
      [a, d, z1],
    ]);
    cells(xs, ys, (a, b, c, d) => [
      [b, c, z0],
      [a, c, z0],
      [a, d, z0],
      [b, d, z0],
    ]);
    return this;
  }

  /** A convex outline of [x, y], counter-clockwise seen from +Z, drawn out from `z0` to `z1`. */
  prism(materials, outline, z0, z1) {
    this.polygon(
      materials,
      outline.map(([x, y]) => [x, y, z1]),
    );
    this.polygon(
      materials,
      [...outline].reverse().map(([x, y]) => [x, y, z0]),
    );
    outline.forEach(([x, y], i) => {
      const [nx, ny] = outline[(i + 1) % outline.length];
      this.polygon(materials, [
        [x, y, z1],
        [x, y, z0],
        [nx, ny, z0],
        [nx, ny, z1],
      ]);
    });
    return this;
  }

  /**
   * Turns a profile of [radius, y], from its lowest point to its highest, about the Y axis; open ends get lids.
   * `smooth`: shaded round along the profile too, for trees and bells; else only around the axis. `facets`: flat shaded.
   */
  lathe(materials, profile, segments, { smooth = false, facets = false, phase = 0 } = {}) {
    const around = Array.from({ length: segments + 1 }, (_, i) => {
      const angle = ((i % segments) / segments + phase) * 2 * Math.PI;
      return [Math.cos(angle), Math.sin(angle)];
    });
    const slopes = profile.slice(1).map(([r, y], i) => {
      const [r0, y0] = profile[i];
      const length = Math.hypot(r - r0, y - y0);
      return [(y - y0) / length, (r0 - r) / length];
    });
    const slopeAt = (ring, piece) => {
      const next = slopes[ring];
      const last = slopes[ring - 1];
      return !smooth || !next || !last ? slopes[piece] : [next[0] + last[0], next[1] + last[1]];
    };
    const widest = Math.max(...profile.map(([r]) => r));
    let along = 0;
    for (let k = 0; k < slopes.length; k++) {
      const [r0, y0] = profile[k];
      const [r1, y1] = profile[k + 1];
      const length = Math.hypot(r1 - r0, y1 - y0);
      // What is smooth shares its vertices from ring to ring.
      const girth = (2 * Math.PI * (smooth ? widest : Math.max(r0, r1))) / segments / TEXTURE_SIZE;
      for (let i = 0; i < segments; i++) {
        const ends = [
          [i, r0, y0, k],
          [i, r1, y1, k + 1],
          ...(r1 > 0 ? [[i + 1, r1, y1, k + 1]] : []),
          ...(r0 > 0 ? [[i + 1, r0, y0, k]] : []),
        ];
        this.polygon(
          materials,
          ends.map(([s, r, y]) => [around[s][0] * r, y, around[s][1] * r]),
          {
            round: smooth,
            normals: facets
              ? undefined
              : ends.map(([s, , , ring]) => {
                  const [out, up] = slopeAt(ring, k);
                  return normalize([around[s][0] * out, up, around[s][1] * out]);
                }),
            uvs: ends.map(([s, , , ring]) => [
              -s * girth,
              -(along + (ring > k ? length : 0)) / TEXTURE_SIZE,
            ]),
          },
        );
      }
      along += length;
    }
    const ring = (r, y) => around.slice(0, segments).map(([c, s]) => [c * r, y, s * r]);
    const [low, high] = [profile[0], profile[profile.length - 1]];
    if (low[0] > 0) this.polygon(materials, ring(...low));
    if (high[0] > 0) this.polygon(materials, ring(...high).reverse());
    return this;
  }
}
