import type { Capsule } from './Capsule.js';
import type { FieldMemory } from './FieldMemory.js';
import { STRIDE } from './Surfels.js';

/**
 * Is there anything to step onto: a surfel no steeper than `slope`, higher above the foot than `low` and no higher than
 * `high`, within `reach` of the capsule's side? A quick look that spares a longer one. Allocates nothing.
 *
 * @param slope least Y of its normal
 */
export function hasTread(
  memory: FieldMemory,
  capsule: Capsule,
  low: number,
  high: number,
  reach: number,
  slope: number,
): boolean {
  memory.gather(capsule, reach);
  for (let k = 0; k < memory.kept.length; k++) {
    const { surfels, near, nearCount } = memory.kept[k]!;
    const { data, extent, origin } = surfels;
    const x = capsule.x - origin.x;
    const z = capsule.z - origin.z;
    const foot = capsule.y - origin.y;
    for (let a = 0; a < nearCount; a++) {
      const i = near[a]!;
      const o = STRIDE * i;
      const ny = data[o + 4]!;
      if (ny < slope) continue;
      const y = data[o + 1]! - foot;
      const e = extent[i]!;
      const rise = e * Math.sqrt(Math.max(0, 1 - ny * ny));
      if (y < low - rise || y > high + rise) continue;
      const dx = data[o]! - x;
      const dz = data[o + 2]! - z;
      const within = capsule.radius + reach + e;
      if (dx * dx + dz * dz < within * within) return true;
    }
  }
  return false;
}
