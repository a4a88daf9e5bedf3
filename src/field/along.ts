import { directionTexel } from '../cube/texelDirections.js';
import type { SurfaceField } from './SurfaceField.js';

/** What a field saw in one direction. */
export interface Seen {
  /** Metres from the centre along the direction asked for, to the plane of what was seen; Infinity for nothing. */
  distance: number;
  /** The texel that saw it. */
  texel: number;
}

/**
 * The distance and the texel in a direction, in constant time: the plane that the direction's texel saw, met along the
 * direction itself. Allocates nothing.
 *
 * @param x @param y @param z unit vector, world axes
 * @returns `target`
 */
export function along(field: SurfaceField, x: number, y: number, z: number, target: Seen): Seen {
  const texel = directionTexel(x, y, z, field.resolution);
  const { direction, normal } = field;
  const k = 3 * texel;
  let distance = field.distance[texel]!;
  if (distance < Infinity) {
    const nx = normal[k]!;
    const ny = normal[k + 1]!;
    const nz = normal[k + 2]!;
    const own = nx * direction[k]! + ny * direction[k + 1]! + nz * direction[k + 2]!;
    const asked = nx * x + ny * y + nz * z;
    // At a slant the plane runs away from what was seen: no farther than to half as far or twice.
    const part = own / asked;
    if (part > 0.5 && part < 2) distance *= part;
  }
  target.distance = distance;
  target.texel = texel;
  return target;
}
