/** A level that nobody wonders at: across, and high, metres. */
const TYPICAL = { width: 40, height: 8 };
/** Thinner than this part of its width, a level's height says nothing. */
const FLAT = 1 / 40;
/**
 * Millimetres, centimetres, as it is, and toys; with what it takes to leave metres, which glTF prescribes, for them:
 * natural logarithms of sizes.
 */
const SCALES = [
  [1, 0],
  [0.01, 5],
  [0.001, 8.3],
  [10, 5],
  [100, 5],
  [1000, 8.3],
] as const;
/** Wider than this no unit makes it a level: it is made `TYPICAL.width` wide. Metres. */
const [LEAST, MOST] = [0.2, 20_000];

/**
 * Metres of a file's unit: 1, unless another is far likelier for a level that a person of 1.8 m walks in.
 *
 * @param size of the box around it, Y up
 */
export function guessScale(size: { x: number; y: number; z: number }): number {
  const width = Math.max(size.x, size.z);
  const across = Math.max(width, size.y / 4);
  if (!(across > 0) || !Number.isFinite(across)) return 1;
  let best: number = 1;
  let least = Infinity;
  for (const [scale, reluctance] of SCALES) {
    const strange = strangeness(across, size.y, scale) + reluctance;
    if (strange < least) [best, least] = [scale, strange];
  }
  if (across * best >= LEAST && across * best <= MOST) return best;
  return Number((TYPICAL.width / across).toPrecision(3));
}

function strangeness(width: number, height: number, scale: number): number {
  const wide = Math.abs(Math.log((width * scale) / TYPICAL.width));
  if (height < FLAT * width) return 2 * wide;
  return wide + Math.abs(Math.log((height * scale) / TYPICAL.height));
}
