import type { Fingers } from './Fingers.js';

/** Pointer travel that still counts as a click, pixels. */
const CLICK_TRAVEL = 4;
/** Pixels of a wheel's line and page, as browsers scroll them. */
const WHEEL_UNIT = [1, 33, 400] as const;

/** What `PointerLook` is told; `CharacterControls` has these fields. */
export interface PointerLookSettings {
  /** Whether input is wanted now. */
  enabled: boolean;
  /** Whether a click captures the pointer; if not, dragging looks. */
  pointerLock: boolean;
  /** Whether to ask for raw mouse travel, without the system's acceleration. */
  unadjustedMovement: boolean;
}

/** What `PointerLook` reports. */
export interface PointerLookListener {
  /** The pointer moved by so many pixels while it steers the view. */
  look(dx: number, dy: number): void;
  /** The wheel turned by so many pixels, positive toward the user; true if it was used. */
  zoom(pixels: number): boolean;
  /** The pointer was captured, or let go. */
  locked(locked: boolean): void;
}

/**
 * Mouse look on one element: captured by a click, and by dragging wherever the browser refuses the capture (an iframe
 * without permission, a second within Escape). Fingers are handed on.
 */
export class PointerLook {
  /** Whether the pointer is captured. */
  isLocked = false;

  #element: HTMLElement | null = null;
  #travel = 0;
  #lastX = 0;
  #lastY = 0;
  #dragging = -1;
  #touched = false;
  #touchAction = '';

  readonly #settings: PointerLookSettings;
  readonly #listener: PointerLookListener;
  readonly #fingers: Fingers;

  constructor(settings: PointerLookSettings, listener: PointerLookListener, fingers: Fingers) {
    this.#settings = settings;
    this.#listener = listener;
    this.#fingers = fingers;
  }

  connect(element: HTMLElement): void {
    this.#element = element;
    // Or the browser takes a finger's drag for a scroll.
    this.#touchAction = element.style.touchAction;
    element.style.touchAction = 'none';
    const document = element.ownerDocument;
    element.addEventListener('pointerdown', this.#onPointerDown);
    element.addEventListener('pointermove', this.#onPointerMove);
    element.addEventListener('pointerup', this.#onPointerUp);
    element.addEventListener('pointercancel', this.#onPointerUp);
    element.addEventListener('click', this.#onClick);
    element.addEventListener('wheel', this.#onWheel, { passive: false });
    document.addEventListener('pointerlockchange', this.#onLockChange);
  }

  disconnect(): void {
    const element = this.#element;
    if (element === null) return;
    this.unlock();
    element.removeEventListener('pointerdown', this.#onPointerDown);
    element.removeEventListener('pointermove', this.#onPointerMove);
    element.removeEventListener('pointerup', this.#onPointerUp);
    element.removeEventListener('pointercancel', this.#onPointerUp);
    element.removeEventListener('click', this.#onClick);
    element.removeEventListener('wheel', this.#onWheel);
    element.ownerDocument.removeEventListener('pointerlockchange', this.#onLockChange);
    if (this.isLocked) {
      this.isLocked = false;
      this.#listener.locked(false);
    }
    element.style.touchAction = this.#touchAction;
    this.#element = null;
    this.#dragging = -1;
  }

  /** Asks for the pointer. A refusal is no error: dragging looks then. Must come from a user's gesture. */
  async lock(unadjustedMovement = this.#settings.unadjustedMovement): Promise<void> {
    const element = this.#element;
    if (element === null || this.isLocked || typeof element.requestPointerLock !== 'function')
      return;
    try {
      await element.requestPointerLock({ unadjustedMovement });
    } catch (error) {
      // Raw travel is not to be had everywhere; the plain capture may be.
      if (unadjustedMovement && (error as Error).name === 'NotSupportedError')
        await this.lock(false);
    }
  }

  /** Lets the pointer go. */
  unlock(): void {
    const document = this.#element?.ownerDocument;
    if (this.isLocked && document?.pointerLockElement === this.#element)
      document?.exitPointerLock();
  }

  readonly #onPointerDown = (event: PointerEvent): void => {
    this.#touched = event.pointerType === 'touch';
    this.#travel = 0;
    if (!this.#settings.enabled) return;
    if (this.#touched) {
      const { left, width } = this.#element!.getBoundingClientRect();
      this.#fingers.down(event, event.clientX < left + width / 2);
    } else {
      if (this.isLocked || this.#dragging !== -1) return;
      this.#dragging = event.pointerId;
      this.#lastX = event.clientX;
      this.#lastY = event.clientY;
    }
    try {
      // So that a drag that ends outside the window ends.
      this.#element?.setPointerCapture?.(event.pointerId);
    } catch {
      // The pointer is gone already.
    }
  };

  readonly #onPointerMove = (event: PointerEvent): void => {
    if (!this.#settings.enabled) return;
    if (event.pointerType === 'touch') {
      this.#fingers.move(event);
    } else if (this.isLocked) {
      this.#listener.look(event.movementX, event.movementY);
    } else if (this.#dragging === event.pointerId) {
      const dx = event.clientX - this.#lastX;
      const dy = event.clientY - this.#lastY;
      this.#lastX = event.clientX;
      this.#lastY = event.clientY;
      this.#travel += Math.abs(dx) + Math.abs(dy);
      this.#listener.look(dx, dy);
    }
  };

  readonly #onPointerUp = (event: PointerEvent): void => {
    if (event.pointerType === 'touch') this.#fingers.up(event);
    else if (this.#dragging === event.pointerId) this.#dragging = -1;
  };

  readonly #onClick = (): void => {
    if (!this.#settings.enabled || !this.#settings.pointerLock || this.#touched) return;
    if (this.#travel <= CLICK_TRAVEL) void this.lock();
  };

  readonly #onWheel = (event: WheelEvent): void => {
    if (!this.#settings.enabled || event.ctrlKey) return;
    const pixels = event.deltaY * (WHEEL_UNIT[event.deltaMode] ?? 1);
    if (this.#listener.zoom(pixels)) event.preventDefault();
  };

  readonly #onLockChange = (): void => {
    const locked = this.#element?.ownerDocument.pointerLockElement === this.#element;
    if (locked === this.isLocked) return;
    this.isLocked = locked;
    this.#dragging = -1;
    this.#listener.locked(locked);
  };
}
