/**
 * Colours of what the helpers show, sRGB: Okabe and Ito's palette, which colour-blind people tell apart too. For legends.
 */
export const HELPER_COLORS = {
  /** Surfaces that can be stood on. */
  floor: 0x0072b2,
  /** Surfaces that are too steep for it. */
  wall: 0xe69f00,
  /** Surfaces that look down. */
  ceiling: 0xcc79a7,
  /** Surfaces seen from behind. */
  back: 0x4a4f55,
  /** The border of the space that was seen to be free. */
  free: 0x56b4e9,
  /** A character on its feet. */
  grounded: 0x00c08b,
  /** A character in the air. */
  airborne: 0x56b4e9,
  /** A character that stands still because it does not know its surroundings, or has no room. */
  held: 0xd55e00,
} as const;

/** A surface whose normal points down by more than this (sine) is a ceiling. */
const OVERHANG = 0.5;

/** What a surface is to somebody who walks. */
export type Facing = 'floor' | 'wall' | 'ceiling';

/**
 * @param rise part of the surface's unit normal along up
 * @param flattest cosine of the steepest slope that is walked
 */
export function facingOf(rise: number, flattest: number): Facing {
  if (rise >= flattest) return 'floor';
  return rise < -OVERHANG ? 'ceiling' : 'wall';
}
