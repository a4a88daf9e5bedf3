/** Thumb's way from its origin to a walk at full speed, pixels. */
const RADIUS = 52;
/** In radii: pushed so far out, it runs; farther out the origin comes along, so that turning round is quick. */
const RUN = 1.45;
const LEASH = 1.6;
/** Part of the radius that a resting thumb may stray. */
const REST = 0.15;

/**
 * A stick that appears under the thumb: it says how one walks, and where to draw it. `controls.stick` is one; draw it
 * while `active`, a ring of `radius` around the origin and a knob at `x`, `y` from there.
 */
export class TouchStick {
  /** Whether a thumb is on it. */
  active = false;
  /** Where the thumb came down, CSS pixels in the window (`clientX`, `clientY`); it follows a thumb that goes far. */
  originX = 0;
  /** The same, downward: `clientY`. */
  originY = 0;
  /** Thumb's way from there, CSS pixels, right positive. */
  x = 0;
  /** The same, down positive. */
  y = 0;
  /** CSS pixels: so far out is a walk at full speed, half as far again a run. */
  readonly radius = RADIUS;

  /** Which part of a walk's speed is wanted, 0 to 1. */
  get tilt(): number {
    const out = Math.sqrt(this.x * this.x + this.y * this.y) / RADIUS;
    return Math.max(0, Math.min(1, (out - REST) / (1 - REST)));
  }

  /** Whether it is pushed far enough out to run. */
  get runs(): boolean {
    return Math.sqrt(this.x * this.x + this.y * this.y) >= RUN * RADIUS;
  }

  /** The thumb comes down. */
  start(clientX: number, clientY: number): void {
    this.active = true;
    this.originX = clientX;
    this.originY = clientY;
    this.x = this.y = 0;
  }

  /** The thumb is there now, CSS pixels in the window. */
  move(clientX: number, clientY: number): void {
    this.x = clientX - this.originX;
    this.y = clientY - this.originY;
    const out = Math.sqrt(this.x * this.x + this.y * this.y);
    if (out <= LEASH * RADIUS) return;
    const kept = (LEASH * RADIUS) / out;
    this.originX += (1 - kept) * this.x;
    this.originY += (1 - kept) * this.y;
    this.x *= kept;
    this.y *= kept;
  }

  /** The thumb was lifted. */
  end(): void {
    this.active = false;
    this.x = this.y = 0;
  }
}
