import type { Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import { redOf } from '../cube/axisRed.js';
import { texelIndex } from '../cube/atlas.js';
import { directionTexel } from '../cube/texelDirections.js';
import type { SurfaceField } from './SurfaceField.js';

/**
 * Equations (17)-(22) on the processor: the highest red of each face of a surface field, so that the paper's response
 * can work on `output: 'surface'` too. `target.rMin` and `target.rMax` are kept, all else is overwritten. Allocates
 * nothing.
 *
 * Mend of (17)-(22), which leave ties open: the texel nearest to the face's middle wins, then the first in row order
 * (y, then x), as in the GPU's reduction. A flat wall's push then points along its normal, and a symmetric scene's
 * pushes cancel exactly.
 *
 * @returns `target`, its `center` the field's
 */
export function axisMaxima(field: SurfaceField, target: AxisMaxima): AxisMaxima {
  const { resolution: n, direction, distance } = field;
  const { rMin, rMax } = target;
  target.center.copy(field.center);
  for (let face = 0; face < 6; face++) {
    let best = 0;
    let bestOff = Infinity;
    let bestX = 0;
    let bestY = 0;
    for (let y = 0; y < n; y++) {
      for (let x = 0; x < n; x++) {
        const red = redOf(distance[texelIndex(face, x, y, n)]!, rMin, rMax);
        if (red < best) continue;
        const off = (2 * x + 1 - n) ** 2 + (2 * y + 1 - n) ** 2;
        if (red === best && off >= bestOff) continue;
        best = red;
        bestOff = off;
        bestX = x;
        bestY = y;
      }
    }
    target.set(face, best, bestX, bestY, n);
    // Drawn finer, a texel's direction is its own.
    const winner = 3 * texelIndex(face, bestX, bestY, n);
    for (let i = 0; i < 3; i++) target.direction[3 * face + i] = direction[winner + i]!;
  }
  return target;
}

/** Highest red so far, per face, in doubles. */
const bestRed = new Float64Array(6);

/**
 * The maxima a cubemap would have if it were drawn at `center`, from a field drawn elsewhere: every surface point that
 * the field saw is seen again from there. Lets one wide field (its `far` well beyond rMax) serve a character that has
 * moved on since it was drawn.
 *
 * What the field's own centre could not see is missing, and the points lie as far apart as the field's texels do at
 * their distance: a flat floor D below the field is met up to (√2·D/N)²/(2·rMax) too low (2 mm at 0.9 m, N = 32).
 * `target.texel` gets the texel that the winning direction passes through. Allocates nothing.
 *
 * @param center world space, metres; |center - field.center| + target.rMax should not exceed `field.far`
 * @returns `target`, its `center` the one given
 */
export function axisMaximaAt(field: SurfaceField, center: Vector3, target: AxisMaxima): AxisMaxima {
  if (center.equals(field.center)) return axisMaxima(field, target);
  const { count, direction, distance, resolution: n } = field;
  const { rMin, rMax } = target;
  const ox = field.center.x - center.x;
  const oy = field.center.y - center.y;
  const oz = field.center.z - center.z;
  const farthest = rMax + Math.sqrt(ox * ox + oy * oy + oz * oz);
  target.center.copy(center);
  target.direction.fill(0);
  target.texel.fill(0);
  bestRed.fill(0);
  for (let texel = 0; texel < count; texel++) {
    const d = distance[texel]!;
    if (d >= farthest) continue;
    const x = ox + direction[3 * texel]! * d;
    const y = oy + direction[3 * texel + 1]! * d;
    const z = oz + direction[3 * texel + 2]! * d;
    const squared = x * x + y * y + z * z;
    if (squared >= rMax * rMax || squared === 0) continue;
    const length = Math.sqrt(squared);
    const seen = directionTexel(x, y, z, n);
    const face = Math.floor(seen / (n * n));
    const red = redOf(length, rMin, rMax);
    if (red <= bestRed[face]!) continue;
    bestRed[face] = red;
    target.direction[3 * face] = x / length;
    target.direction[3 * face + 1] = y / length;
    target.direction[3 * face + 2] = z / length;
    target.texel[2 * face] = seen % n;
    target.texel[2 * face + 1] = Math.floor(seen / n) % n;
  }
  for (let face = 0; face < 6; face++) target.red[face] = bestRed[face]!;
  return target;
}
