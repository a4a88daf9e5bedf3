/** The coefficients of Matt Zucker's polynomial (shadertoy.com/view/WlfXRN, CC0), red, green, blue each, lowest first. */
export const VIRIDIS = [
  [0.2777273272234177, 0.005407344544966578, 0.3340998053353061],
  [0.1050930431085774, 1.404613529898575, 1.384590162594685],
  [-0.3308618287255563, 0.214847559468213, 0.09509516302823659],
  [-4.634230498983486, -5.799100973351585, -19.33244095627987],
  [6.228269936347081, 14.17993336680509, 56.69055260068105],
  [4.776384997670288, -13.74514537774601, -65.35303263337234],
  [-5.435455855934631, 4.645852612178535, 26.3124352495832],
] as const;

/**
 * One channel of viridis: even steps look like even steps, to the colour-blind too.
 *
 * @param t 0, dark, to 1, bright
 * @param channel 0 red, 1 green, 2 blue
 * @returns 0 to 1, sRGB
 */
export function viridis(t: number, channel: 0 | 1 | 2): number {
  let value = 0;
  for (let power = VIRIDIS.length - 1; power >= 0; power--) {
    value = value * t + VIRIDIS[power]![channel];
  }
  return Math.min(1, Math.max(0, value));
}
