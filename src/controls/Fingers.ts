import { TouchStick } from './TouchStick.js';

/** What `Fingers` reports. */
export interface FingersListener {
  /** A finger that looks has moved by so many pixels. */
  swipe(dx: number, dy: number): void;
  /** Two fingers have gone so many times as far apart as they were. */
  pinch(ratio: number): void;
}

/** What `Fingers` is told; `CharacterControls` has this field. */
export interface FingersSettings {
  /** Whether the left half walks; if not, every finger looks. */
  touchStick: boolean;
}

/** One finger that looks. */
interface Finger {
  id: number;
  x: number;
  y: number;
}

const NONE = -1;

/**
 * Fingers on a screen: the first in the left half is the stick, one in the right half looks, two of them pinch. Holds no
 * listeners of its own: `PointerLook` hands it the events.
 */
export class Fingers {
  readonly stick = new TouchStick();

  readonly #settings: FingersSettings;
  readonly #listener: FingersListener;
  readonly #looking: readonly [Finger, Finger] = [
    { id: NONE, x: 0, y: 0 },
    { id: NONE, x: 0, y: 0 },
  ];
  #thumb = NONE;

  constructor(settings: FingersSettings, listener: FingersListener) {
    this.#settings = settings;
    this.#listener = listener;
  }

  /** Takes a `pointerdown` of a finger. @param left whether it came down in the left half */
  down({ pointerId, clientX, clientY }: PointerEvent, left: boolean): void {
    if (left && this.#settings.touchStick && this.#thumb === NONE) {
      this.#thumb = pointerId;
      this.stick.start(clientX, clientY);
      return;
    }
    const finger = this.#fingerOf(NONE);
    if (finger === null) return;
    finger.id = pointerId;
    finger.x = clientX;
    finger.y = clientY;
  }

  /** Takes a `pointermove` of a finger. */
  move({ pointerId, clientX, clientY }: PointerEvent): void {
    if (pointerId === this.#thumb) {
      this.stick.move(clientX, clientY);
      return;
    }
    const finger = this.#fingerOf(pointerId);
    if (finger === null) return;
    const before = this.#spread();
    const dx = clientX - finger.x;
    const dy = clientY - finger.y;
    finger.x = clientX;
    finger.y = clientY;
    if (before > 0) this.#listener.pinch(this.#spread() / before);
    else this.#listener.swipe(dx, dy);
  }

  /** Takes a `pointerup` or `pointercancel` of a finger. */
  up({ pointerId }: PointerEvent): void {
    if (pointerId === this.#thumb) {
      this.#thumb = NONE;
      this.stick.end();
    }
    const finger = this.#fingerOf(pointerId);
    if (finger !== null) finger.id = NONE;
  }

  /** Lets go of all: the page will not see them come up. */
  clear(): void {
    this.#thumb = NONE;
    this.stick.end();
    for (const finger of this.#looking) finger.id = NONE;
  }

  #fingerOf(id: number): Finger | null {
    const [a, b] = this.#looking;
    return a.id === id ? a : b.id === id ? b : null;
  }

  /** Pixels between two fingers that look; 0 with fewer. */
  #spread(): number {
    const [a, b] = this.#looking;
    return a.id === NONE || b.id === NONE ? 0 : Math.hypot(a.x - b.x, a.y - b.y);
  }
}
