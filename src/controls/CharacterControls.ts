import { type Camera, Controls, Euler, Vector3 } from 'three';
import { DEFAULTS } from '../defaults.js';
import { Warnings } from '../Warnings.js';
import { CameraRig, catchUp } from './CameraRig.js';
import type { ControlledCharacter, View } from './ControlledCharacter.js';
import { defaultKeys, Keyboard, type KeyMap } from './Keyboard.js';
import { PointerLook } from './PointerLook.js';

/** Each field of `CharacterControls` of that name; see there. */
export interface CharacterControlsOptions {
  view?: View;
  walkSpeed?: number;
  runSpeed?: number;
  eyeHeight?: number;
  sensitivity?: number;
  maxPitch?: number;
  distance?: number;
  minDistance?: number;
  maxDistance?: number;
  pointerLock?: boolean;
  unadjustedMovement?: boolean;
  agility?: number;
  smoothing?: number;
  /** Keys of the actions to change; the others keep theirs. */
  keys?: Partial<KeyMap>;
}

export interface CharacterControlsEventMap {
  /** The pointer was captured. */
  lock: object;
  /** The pointer was let go, by Escape or by `unlock`. */
  unlock: object;
  /** The view was switched. */
  change: { view: View };
}

/** Part of the distance that a pixel of the wheel adds. */
const ZOOM_RATE = 0.001;
/** Slower than this a character that stops has stopped, m/s. */
const STANDSTILL = 0.01;

const _wish = /* @__PURE__ */ new Vector3();
const _euler = /* @__PURE__ */ new Euler(0, 0, 0, 'YXZ');

/**
 * Walks a character with keyboard and mouse, in first or third person.
 *
 * ```js
 * const controls = new CharacterControls( character, camera, renderer.domElement );
 *
 * renderer.setAnimationLoop( ( time ) => {
 *
 *   timer.update( time );
 *   const delta = timer.getDelta();
 *
 *   controls.update( delta ); // reads the input
 *   character.update( renderer, scene, delta );
 *   controls.follow( delta ); // places the camera
 *
 *   renderer.render( scene, camera );
 *
 * } );
 * ```
 *
 * A click on the element captures the pointer and the mouse looks; where a browser refuses, dragging does. Keys go by
 * their place on the keyboard: WASD or arrows, Shift runs, Space jumps, C held crouches, `keys` changes them. The camera
 * is placed in the world's frame: leave it without a parent, or in one that does not move.
 */
export class CharacterControls extends Controls<CharacterControlsEventMap, Camera> {
  /** Speed of walking, m/s. @default 3 */
  walkSpeed: number = DEFAULTS.controls.walkSpeed;
  /** Speed while Shift is held, m/s. @default 6 */
  runSpeed: number = DEFAULTS.controls.runSpeed;
  /** Height of the eyes above the foot, standing, metres. @default 1.6 */
  eyeHeight: number = DEFAULTS.controls.eyeHeight;
  /** Turn of the view for a pixel of mouse travel, radians. @default 0.002 */
  sensitivity: number = DEFAULTS.controls.sensitivity;
  /** Farthest the view tilts up or down, radians. @default 85° */
  maxPitch: number = DEFAULTS.controls.maxPitch;
  /** Third person: wanted distance from the head, metres; the wheel changes it. @default 4 */
  distance: number = DEFAULTS.controls.distance;
  /** Nearest the wheel brings the camera, metres. @default 1 */
  minDistance: number = DEFAULTS.controls.minDistance;
  /** Farthest the wheel takes the camera, metres. @default 7 */
  maxDistance: number = DEFAULTS.controls.maxDistance;
  /** Whether a click captures the pointer; if not, dragging looks. @default true */
  pointerLock: boolean = DEFAULTS.controls.pointerLock;
  /** Whether to ask for raw mouse travel, without the system's acceleration. @default false */
  unadjustedMovement: boolean = DEFAULTS.controls.unadjustedMovement;
  /** How fast it takes up a new velocity, 1/s: 12 is there in a fifth of a second, Infinity at once. @default 12 */
  agility: number = DEFAULTS.controls.agility;
  /**
   * Scales how fast camera and avatar settle: 1 as made, 2 twice as fast, Infinity at once, which is right for
   * `prefers-reduced-motion`. The head never bobs. @default 1
   */
  smoothing: number = DEFAULTS.controls.smoothing;
  /** Keys of each action, by `KeyboardEvent.code`: WASD or arrows, Shift runs, Space jumps, C crouches. */
  keys: KeyMap = defaultKeys();
  /** Direction of the view about +Y, radians: 0 looks along -Z, growing turns left. Read from the camera at first. */
  yaw = 0;
  /** Tilt of the view, radians, up positive. Read from the camera at first. */
  pitch = 0;

  readonly #warnings = new Warnings('CharacterControls');
  readonly #keyboard = new Keyboard(this);
  readonly #pointer = new PointerLook(this, {
    look: (dx, dy) => this.#turn(dx, dy),
    zoom: (pixels) => this.#zoom(pixels),
    locked: (locked) => this.#onLocked(locked),
  });
  readonly #rig = new CameraRig();
  readonly #velocity = new Vector3();
  #currentView: View = DEFAULTS.controls.view;
  #walking = false;
  #crouching = false;

  /**
   * @param character what to walk
   * @param camera what to place
   * @param domElement listened to, usually `renderer.domElement`; without one call `connect` later
   * @throws {RangeError} if a number is negative or none, or the view is unknown
   */
  constructor(
    public character: ControlledCharacter,
    camera: Camera,
    domElement: HTMLElement | null = null,
    options: CharacterControlsOptions = {},
  ) {
    super(camera, domElement);
    const { keys, view, ...fields } = options;
    for (const [name, value] of Object.entries(fields)) {
      const endless = name === 'agility' || name === 'smoothing';
      if (typeof value === 'number' && !(value >= 0 && (value < Infinity || endless))) {
        throw new RangeError(
          `CharacterControls: "${name}" must be a number from 0 on (got ${value}).`,
        );
      }
      if (value !== undefined) Object.assign(this, { [name]: value });
    }
    Object.assign(this.keys, keys);
    if (view !== undefined) this.view = view;
    _euler.setFromQuaternion(camera.quaternion);
    this.yaw = _euler.y;
    this.pitch = _euler.x;
    if (domElement !== null) this.connect(domElement);
  }

  /** In the head or behind it; may be switched at any time. @default 'first' */
  get view(): View {
    return this.#currentView;
  }

  set view(view: View) {
    if (view !== 'first' && view !== 'third') {
      throw new RangeError(
        `CharacterControls: "view" must be 'first' or 'third' (got ${String(view)}).`,
      );
    }
    if (view === this.#currentView) return;
    this.#currentView = view;
    this.dispatchEvent({ type: 'change', view });
  }

  /** Whether the pointer is captured. */
  get isLocked(): boolean {
    return this.#pointer.isLocked;
  }

  /** Listens to `element` and, for keys, to its document. */
  override connect(element: HTMLElement): void {
    super.connect(element);
    const document = element.ownerDocument;
    document.addEventListener('keydown', this.#onKeyDown);
    document.addEventListener('keyup', this.#onKeyUp);
    document.addEventListener('visibilitychange', this.#letGo);
    document.defaultView?.addEventListener('blur', this.#letGo);
    this.#pointer.connect(element);
  }

  override disconnect(): void {
    const document = this.domElement?.ownerDocument;
    document?.removeEventListener('keydown', this.#onKeyDown);
    document?.removeEventListener('keyup', this.#onKeyUp);
    document?.removeEventListener('visibilitychange', this.#letGo);
    document?.defaultView?.removeEventListener('blur', this.#letGo);
    this.#pointer.disconnect();
    this.#keyboard.clear();
  }

  override dispose(): void {
    this.disconnect();
  }

  /** Captures the pointer; call it from a user's gesture. A refusal is no error: dragging looks then. */
  lock(): Promise<void> {
    return this.#pointer.lock();
  }

  /** Lets the pointer go. */
  unlock(): void {
    this.#pointer.unlock();
  }

  /**
   * Reads the input: what the character wants from now on. Call it before the character's own update.
   *
   * @param delta seconds since the last call
   */
  override update(delta: number): void {
    if (!this.enabled || !(delta >= 0)) {
      this.#stop();
      return;
    }
    const right = Number(this.#keyboard.held('right')) - Number(this.#keyboard.held('left'));
    const back = Number(this.#keyboard.held('back')) - Number(this.#keyboard.held('forward'));
    const speed = this.#keyboard.held('run') ? this.runSpeed : this.walkSpeed;
    const idle = right === 0 && back === 0;
    _wish.set(right, 0, back).normalize().multiplyScalar(speed);
    _wish.applyEuler(_euler.set(0, this.yaw, 0));

    this.#velocity.lerp(_wish, catchUp(this.agility, delta));
    if (!Number.isFinite(this.#velocity.lengthSq())) {
      // A field was set to no number: stand, and go on once it is mended.
      this.#warnings.once('its speeds, "agility" and "yaw" must be numbers; standing still.');
      this.#velocity.set(0, 0, 0);
    }
    if (idle && this.#velocity.lengthSq() < STANDSTILL * STANDSTILL) this.#velocity.set(0, 0, 0);
    // Someone else may walk the character while no key is held: told once to stop, it is left alone.
    const walks = !idle || this.#velocity.lengthSq() > 0;
    if (walks || this.#walking) this.character.walk(this.#velocity);
    this.#walking = walks;
    if (this.#keyboard.taken('jump')) this.character.jump();
    this.#crouch(this.#keyboard.held('crouch'));
  }

  /**
   * Places the camera, and the character's avatar if it has one. Call it after the character's own update.
   *
   * @param delta seconds since the last call
   */
  follow(delta: number): void {
    if (!(delta >= 0)) return;
    const rig = this.#rig;
    const { character } = this;
    rig.smoothing = this.smoothing;
    const boom = this.view === 'third' ? this.distance : 0;
    rig.place(this.object, character, boom, this.eyeHeight, this.yaw, this.pitch, delta);
    if (character.avatar) rig.pose(character.avatar, character, this.#velocity, this.yaw, delta);
  }

  #turn(dx: number, dy: number): void {
    this.yaw -= dx * this.sensitivity;
    this.pitch -= dy * this.sensitivity;
    this.pitch = Math.max(-this.maxPitch, Math.min(this.maxPitch, this.pitch));
  }

  #zoom(pixels: number): boolean {
    if (this.view !== 'third') return false;
    const distance = this.distance * Math.exp(pixels * ZOOM_RATE);
    this.distance = Math.max(this.minDistance, Math.min(this.maxDistance, distance));
    return true;
  }

  /** Stands still, once: a character that others walk is left alone. */
  #stop(): void {
    this.#keyboard.clear();
    this.#velocity.set(0, 0, 0);
    if (this.#walking) this.character.walk(this.#velocity);
    this.#walking = false;
    this.#crouch(false);
  }

  /** Told when it changes: a character that others let crouch is left alone. */
  #crouch(on: boolean): void {
    if (on === this.#crouching) return;
    this.#crouching = on;
    this.character.crouch?.(on);
  }

  #onLocked(locked: boolean): void {
    if (!locked) this.#keyboard.clear();
    this.dispatchEvent({ type: locked ? 'lock' : 'unlock' });
  }

  readonly #onKeyDown = (event: KeyboardEvent): void => {
    if (this.enabled) this.#keyboard.press(event);
  };

  readonly #onKeyUp = (event: KeyboardEvent): void => this.#keyboard.release(event);

  readonly #letGo = (): void => this.#keyboard.clear();
}
