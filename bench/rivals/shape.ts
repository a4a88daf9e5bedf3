/** What every walker of the comparison is and does, so that only the way it collides differs. Metres, seconds. */
export const SHAPE = {
  /** Of the capsule. */
  radius: 0.35,
  /** Of the capsule, from its lowest point to its highest. */
  height: 1.8,
  gravity: 20,
  /** Speed at which a jump begins, m/s: 1.1 m high. */
  jumpSpeed: Math.sqrt(2 * 20 * 1.1),
  jumpHeight: 1.1,
  /** Wanted speed over ground, m/s. */
  speed: 5,
} as const;
