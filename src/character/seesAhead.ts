import type { Capsule } from '../field/Capsule.js';
import type { FieldMemory } from '../field/FieldMemory.js';

/** Directions around the body that are looked at, of which the leading ones count. */
const AROUND = 12;
/** Levels: foot, middle, head. */
const LEVELS = 3;
/** Places lie at this part of the radius: the rim itself may lie in a surface's own texels. */
const INSET = 0.9;
/** What lies no deeper than this behind a surface is the inside of it, metres. */
const DEPTH = 0.12;

/**
 * Do the fields know what is where the body's leading side will be after a displacement? Not if part of it goes into the
 * shadow of something nearer to the field's centre: behind a door's jamb, under an edge. Allocates nothing.
 *
 * @param x @param y @param z the displacement, body's frame, metres
 */
export function seesAhead(
  memory: FieldMemory,
  body: Capsule,
  x: number,
  y: number,
  z: number,
): boolean {
  const { radius, height } = body;
  const length = Math.sqrt(x * x + z * z);
  const rim = INSET * radius;
  for (let a = 0; a < AROUND; a++) {
    const angle = (2 * Math.PI * a) / AROUND;
    const cx = Math.cos(angle);
    const cz = Math.sin(angle);
    // Of a level way the leading half; of a fall all around.
    if (cx * x + cz * z < -0.1 * length) continue;
    for (let level = 0; level < LEVELS; level++) {
      const up = radius + ((height - 2 * radius) * level) / (LEVELS - 1);
      const px = body.x + x + rim * cx;
      const pz = body.z + z + rim * cz;
      if (memory.isHidden(px, body.y + up + y, pz, DEPTH)) return false;
    }
  }
  // The crown and the sole.
  const top = y > 0 ? height - radius + rim : radius - rim;
  return y === 0 || !memory.isHidden(body.x + x, body.y + top + y, body.z + z, DEPTH);
}
