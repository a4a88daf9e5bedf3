import type { Capsule } from './Capsule.js';
import type { FieldMemory } from './FieldMemory.js';
import { timeOfImpact } from './timeOfImpact.js';

/**
 * How far the capsule can sink until something carries it, with `gap` left between: metres, 0 to `depth`; Infinity if
 * nothing does within `depth`. Allocates nothing.
 */
export function supportDepth(
  memory: FieldMemory,
  capsule: Capsule,
  depth: number,
  gap: number,
): number {
  down.y = -depth;
  // What is nearer than the gap already carries it at once.
  const part = timeOfImpact(memory, capsule, down, gap, -Infinity);
  return part < 1 ? part * depth : Infinity;
}

const down = { x: 0, y: 0, z: 0 };
