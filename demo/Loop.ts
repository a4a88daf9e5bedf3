import { Timer, type WebGLRenderer } from 'three';

/** What a loop goes through. */
export interface Turn {
  /** Once a turn, before the frame, by the browser's clock alone. */
  before(delta: number): void;
  frame(delta: number): void;
  /** Resolved once all that the last frame asked of the GPU is back. */
  settle(): Promise<void>;
}

/** Frame after frame, by the browser's clock or by hand. */
export class Loop {
  readonly #renderer: WebGLRenderer;
  readonly #turn: Turn;
  readonly #timer = new Timer();

  constructor(renderer: WebGLRenderer, turn: Turn) {
    this.#renderer = renderer;
    this.#turn = turn;
    this.#timer.connect(document);
  }

  run(): void {
    this.#timer.reset();
    this.#renderer.setAnimationLoop((time) => {
      this.#timer.update(time);
      // The first time may lie before the reset.
      const delta = Math.max(0, this.#timer.getDelta());
      this.#turn.before(delta);
      this.#turn.frame(delta);
    });
  }

  rest(): void {
    this.#renderer.setAnimationLoop(null);
  }

  /** Stops, and goes on by hand: `frames` of `delta` seconds each, alike on every machine. */
  async step(frames: number, delta = 1 / 60): Promise<void> {
    this.rest();
    for (let i = 0; i < frames; i++) {
      this.#turn.frame(delta);
      await this.#turn.settle();
    }
  }
}
