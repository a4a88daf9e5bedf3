/** Steps of the red channel: 8 bits, as in the paper. */
const RED_STEPS = 255;

/**
 * Equation (10): 1 at `rMin` from the centre, 0 at `rMax`; clamped to 0..1 as the colour buffer does, so what is nearer
 * than `rMin` still reads 1.
 *
 * The colour buffer keeps it in steps of 1/255, that is (rMax - rMin)/255 metres (0.69 mm for a shell of 0.175 m), to
 * the nearest: a penetration under half a step reads 0, as if nothing were there.
 *
 * @param distance from the centre, metres; Infinity gives 0
 * @param rMin metres, >= 0
 * @param rMax metres, > rMin
 */
export function redOf(distance: number, rMin: number, rMax: number): number {
  return Math.min(1, Math.max(0, 1 - (distance - rMin) / (rMax - rMin)));
}

/** Metres between two neighbouring values of the 8-bit red. */
export function redStep(rMin: number, rMax: number): number {
  return (rMax - rMin) / RED_STEPS;
}

/**
 * The inverse of (10): metres from the centre for a red of 0..1, between `rMin` and `rMax`. A red of 0 means "rMax or
 * farther", a red of 1 "rMin or nearer".
 */
export function distanceOf(red: number, rMin: number, rMax: number): number {
  return rMin + (1 - red) * (rMax - rMin);
}
