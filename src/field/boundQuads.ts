import { FACE_VECTORS } from '../cube/faces.js';
import { SIDES } from './neighbours.js';
import type { Texels } from './Texels.js';

/** As far as a piece goes from its point, metres: see `setCorners`. */
export const LONGEST = 1;

/** The middle of a ball: x, y, z, world axes, from the field's centre. (Numbers handed over would be boxed.) */
export const middle = /* @__PURE__ */ new Float64Array(3);

/**
 * Radius of the ball around `middle` in which the pieces of some texels lie, however they are cut: that reaches the
 * corners of what each can reach in its plane. Written into `target` at `t`, if it is less than what is there.
 *
 * @param list texels; those without a surfel (`ofTexel` below 0) are passed over
 * @param from the first of them in `list`
 * @param to behind the last
 * @param reach how far each goes toward each side from its middle, in texels (see `Extents`); null for as far as any can
 * @param side the same where `reach` is null
 */
export function boundQuads(
  texels: Texels,
  list: Int32Array,
  from: number,
  to: number,
  ofTexel: Int32Array,
  reach: Float32Array | null,
  side: number,
  target: Float32Array,
  t: number,
): void {
  const { direction, distance, normal, resolution: n } = texels;
  const cx = middle[0]!;
  const cy = middle[1]!;
  const cz = middle[2]!;
  const step = 2 / n;
  let farthest = 0;
  for (let a = from; a < to; a++) {
    const texel = list[a]!;
    if (ofTexel[texel]! < 0) continue;
    const face = FACE_VECTORS[Math.floor(texel / (n * n))]!;
    const fx = face[0]!;
    const fy = face[1]!;
    const fz = face[2]!;
    const rx = face[3]!;
    const ry = face[4]!;
    const rz = face[5]!;
    const ux = face[6]!;
    const uy = face[7]!;
    const uz = face[8]!;
    const k = 3 * texel;
    const nx = normal[k]!;
    const ny = normal[k + 1]!;
    const nz = normal[k + 2]!;
    const d = distance[texel]!;
    const px = d * direction[k]!;
    const py = d * direction[k + 1]!;
    const pz = d * direction[k + 2]!;
    const offset = nx * px + ny * py + nz * pz;
    const nf = nx * fx + ny * fy + nz * fz;
    const nr = nx * rx + ny * ry + nz * rz;
    const nu = nx * ux + ny * uy + nz * uz;
    const ox = px - cx;
    const oy = py - cy;
    const oz = pz - cz;
    // No piece is longer, whatever its rays meet.
    const away = ox * ox + oy * oy + oz * oz;
    if (away > farthest) farthest = away;
    const most = Math.sqrt(away) + LONGEST;
    const longest = most * most;
    const middleX = ((texel % n) + 0.5) * step - 1;
    const middleY = ((Math.floor(texel / n) % n) + 0.5) * step - 1;
    const s = SIDES * texel;
    const right = middleX + step * (reach === null ? side : reach[s]!);
    const left = middleX - step * (reach === null ? side : reach[s + 1]!);
    const top = middleY + step * (reach === null ? side : reach[s + 2]!);
    const bottom = middleY - step * (reach === null ? side : reach[s + 3]!);
    for (let c = 0; c < 4; c++) {
      const across = c === 0 || c === 3 ? right : left;
      const up = c < 2 ? top : bottom;
      const depth = offset / (nf + across * nr + up * nu);
      let squared = longest;
      if (depth > 0) {
        const x = depth * (fx + across * rx + up * ux) - cx;
        const y = depth * (fy + across * ry + up * uy) - cy;
        const z = depth * (fz + across * rz + up * uz) - cz;
        const corner = x * x + y * y + z * z;
        if (corner < longest) squared = corner;
      }
      if (squared > farthest) farthest = squared;
    }
  }
  // Rounded, it must still hold all.
  const radius = Math.sqrt(farthest) * (1 + 1e-6) + 1e-6;
  if (radius < target[t]!) target[t] = radius;
}
