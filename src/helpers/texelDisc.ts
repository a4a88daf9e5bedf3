import type { SurfaceField } from '../field/SurfaceField.js';

/** How much of its texel a disc fills: a gap between it and the next. */
const FILL = 0.86;
/** A surface seen from aside stretches a texel on it; no more than this is shown. */
const LONGEST = 6;
/** Off the surface toward who sees it, as a part of the distance: beside `polygonOffset`, for curved ones. */
const OFF = 0.002;

/**
 * Writes the matrix that makes of a disc (around the origin, of radius 1, facing +Z) what one texel covers of the surface
 * it saw: an ellipse, stretched as far as the surface is seen from aside. Where nothing was seen it has no size.
 *
 * @param target 16 numbers, column by column, from `offset` on; relative to the field's centre, world axes, metres
 */
export function texelDisc(
  field: SurfaceField,
  texel: number,
  target: { [index: number]: number },
  offset: number,
): void {
  const distance = field.distance[texel]!;
  if (!(distance < Infinity)) {
    for (let i = 0; i < 16; i++) target[offset + i] = 0;
    return;
  }
  const k = 3 * texel;
  const rx = field.direction[k]!;
  const ry = field.direction[k + 1]!;
  const rz = field.direction[k + 2]!;
  const nx = field.normal[k]!;
  const ny = field.normal[k + 1]!;
  const nz = field.normal[k + 2]!;
  const slant = -(rx * nx + ry * ny + rz * nz);
  // Along the ray within the surface: its stretched axis; any if it is seen straight on.
  let ax = rx + slant * nx;
  let ay = ry + slant * ny;
  let az = rz + slant * nz;
  let length = Math.sqrt(ax * ax + ay * ay + az * az);
  if (length < 1e-4) {
    const flat = Math.abs(nx) < 0.5;
    ax = flat ? 1 - nx * nx : -nx * ny;
    ay = flat ? -nx * ny : 1 - ny * ny;
    az = flat ? -nx * nz : -ny * nz;
    length = Math.sqrt(ax * ax + ay * ay + az * az);
  }
  ax /= length;
  ay /= length;
  az /= length;
  // Between its ray and its face's axis; a texel away from that is smaller, and more so away from the middle than around.
  const cosine = Math.max(Math.abs(rx), Math.abs(ry), Math.abs(rz));
  const around = (FILL * distance * cosine) / field.resolution;
  const away = around * Math.min(LONGEST, cosine / Math.max(slant, 1e-3));
  target[offset] = away * ax;
  target[offset + 1] = away * ay;
  target[offset + 2] = away * az;
  target[offset + 3] = 0;
  target[offset + 4] = around * (ny * az - nz * ay);
  target[offset + 5] = around * (nz * ax - nx * az);
  target[offset + 6] = around * (nx * ay - ny * ax);
  target[offset + 7] = 0;
  target[offset + 8] = nx;
  target[offset + 9] = ny;
  target[offset + 10] = nz;
  target[offset + 11] = 0;
  const off = OFF * distance;
  target[offset + 12] = rx * distance + nx * off;
  target[offset + 13] = ry * distance + ny * off;
  target[offset + 14] = rz * distance + nz * off;
  target[offset + 15] = 1;
}
