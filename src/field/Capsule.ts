/** An upright capsule in the body's frame, whose Y is up. Metres. */
export interface Capsule {
  /** Middle of the foot: its lowest point. */
  x: number;
  y: number;
  z: number;
  radius: number;
  /** From foot to crown, at least 2 · radius; that much is a sphere. */
  height: number;
}
