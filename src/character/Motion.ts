/** How a character is moved: by the paper's loop (`AxisMotion`) or over surfels (`SlideMotion`). */
export interface Motion<R, S> {
  /** Whether the collider's data can vouch for the body's place. While false, nothing moves. */
  readonly ready: boolean;
  readonly grounded: boolean;
  /** The body was put elsewhere, at rest. */
  reset(): void;
  /** Jumps now or, where the motion can, as soon as it may. Returns whether now. */
  jump(): boolean;
  /** Moves on by `delta` seconds against what is known, drawing nothing. */
  step(delta: number): void;
  /** Moves on by `delta` seconds and draws what is due. */
  update(renderer: R, scene: S, delta: number): void;
}
