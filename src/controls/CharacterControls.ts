import { type Camera, Controls, Euler, type Object3D, Vector3 } from 'three';
import { DEFAULTS } from '../defaults.js';
import { Warnings } from '../Warnings.js';
import {
  type ButtonAction,
  type ButtonMap,
  defaultButtons,
  defaultKeys,
  type KeyMap,
} from './actions.js';
import type { Boom } from './Boom.js';
import { CameraRig, catchUp } from './CameraRig.js';
import type { ControlledCharacter, View } from './ControlledCharacter.js';
import {
  type CharacterControlsEventMap,
  type CharacterControlsOptions,
  checkBoom,
  checkControlsOptions,
} from './controlsOptions.js';
import { Inputs } from './Inputs.js';
import { PointerLook } from './PointerLook.js';
import type { TouchStick } from './TouchStick.js';

/** Part of the distance that a pixel of the wheel adds. */
const ZOOM_RATE = 0.001;
/** Slower than this a character that stops has stopped, m/s. */
const STANDSTILL = 0.01;

const _wish = /* @__PURE__ */ new Vector3();
const _euler = /* @__PURE__ */ new Euler(0, 0, 0, 'YXZ');

/**
 * Walks a character with keyboard and mouse, fingers or gamepad, in first or third person.
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
 * - **Mouse and keys**: a click on the element captures the pointer and the mouse looks; where a browser refuses, dragging
 *   does. Keys go by their place on the keyboard: WASD or arrows, Shift runs, Space jumps, C held crouches.
 * - **Fingers**: in the left half of the element a stick appears under the thumb (`stick`, to be drawn by the page; pushed
 *   far out it runs), in the right half a finger looks and two zoom. Buttons are the page's: `press('jump')`.
 * - **Gamepads** of the standard mapping: the left stick walks, the right one looks, A jumps, B crouches, LB or a press of
 *   the left stick runs, Y or Back switches the view.
 *
 * What is down is let go of when the page loses the focus, is hidden, or the pointer is let go.
 *
 * The camera is placed in the world's frame: leave it without a parent, or in one that does not move. In third person it
 * passes through walls, unless there is a `boom`.
 */
export class CharacterControls extends Controls<CharacterControlsEventMap, Camera> {
  /** Speed of walking, m/s. @default 3 */
  walkSpeed: number = DEFAULTS.controls.walkSpeed;
  /** Speed while Shift is held, the stick far out, or LB held, m/s. @default 6 */
  runSpeed: number = DEFAULTS.controls.runSpeed;
  /** Height of the eyes above the foot, standing, metres. @default 1.6 */
  eyeHeight: number = DEFAULTS.controls.eyeHeight;
  /** Turn of the view for a pixel of mouse travel, radians. @default 0.002 */
  sensitivity: number = DEFAULTS.controls.sensitivity;
  /** The same for a finger's travel, radians a CSS pixel. @default 0.006 */
  touchSensitivity: number = DEFAULTS.controls.touchSensitivity;
  /** How fast a gamepad's stick turns the view, all the way out, radians a second. @default 3 */
  stickSensitivity: number = DEFAULTS.controls.stickSensitivity;
  /** How fast keys turn the view, see `turnKeys`, radians a second. @default 2 */
  turnSpeed: number = DEFAULTS.controls.turnSpeed;
  /** Whether looking up and down is the other way round, by mouse, finger and stick. @default false */
  invertY: boolean = DEFAULTS.controls.invertY;
  /** Part of a gamepad's stick's way that counts as none, 0 to less than 1. @default 0.15 */
  deadZone: number = DEFAULTS.controls.deadZone;
  /** Whether the left half of the element is a stick for fingers; if not, they look there too. @default true */
  touchStick: boolean = DEFAULTS.controls.touchStick;
  /**
   * Whether the keys of `turnLeft` and `turnRight`, the left and right arrows, turn the view rather than walk: so that the
   * arrows alone reach everywhere. @default false
   */
  turnKeys: boolean = DEFAULTS.controls.turnKeys;
  /** Whether a press of run switches it on and off; else it runs while that is held. @default false */
  toggleRun: boolean = DEFAULTS.controls.toggleRun;
  /** Farthest the view tilts up or down, radians. @default 85° */
  maxPitch: number = DEFAULTS.controls.maxPitch;
  /** Third person: wanted distance from the head, metres; wheel and pinch change it. @default 4 */
  distance: number = DEFAULTS.controls.distance;
  /** Nearest they bring the camera, metres. @default 1 */
  minDistance: number = DEFAULTS.controls.minDistance;
  /** Farthest they take the camera, metres. @default 7 */
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
  /** Keys of each action, by `KeyboardEvent.code`; `view` has none at first. Change it at any time. */
  keys: KeyMap = defaultKeys();
  /** A gamepad's buttons of each action, by their numbers in the standard mapping. Change it at any time. */
  buttons: ButtonMap = defaultButtons();
  /** Direction of the view about +Y, radians: 0 looks along -Z, growing turns left. Read from the camera at first. */
  yaw = 0;
  /** Tilt of the view, radians, up positive. Read from the camera at first. */
  pitch = 0;

  readonly #warnings = new Warnings('CharacterControls');
  readonly #inputs = new Inputs(this, {
    swipe: (dx, dy) => this.#turn(dx * this.touchSensitivity, dy * this.touchSensitivity),
    pinch: (ratio) => this.#zoom(1 / ratio),
  });
  readonly #pointer = new PointerLook(
    this,
    {
      look: (dx, dy) => this.#turn(dx * this.sensitivity, dy * this.sensitivity),
      zoom: (pixels) => this.#zoom(Math.exp(pixels * ZOOM_RATE)),
      locked: (locked) => this.#onLocked(locked),
    },
    this.#inputs.fingers,
  );
  readonly #rig = new CameraRig();
  /** What the boom has been told to pass over. */
  #ignored: Object3D | null = null;
  readonly #velocity = new Vector3();
  #currentView: View = DEFAULTS.controls.view;
  #walking = false;
  #crouching = false;

  /**
   * @param character what to walk
   * @param camera what to place
   * @param domElement listened to, usually `renderer.domElement`; without one call `connect` later
   * @throws {RangeError} if a number is negative or none, or the view is unknown; TypeError if the boom is none
   */
  constructor(
    public character: ControlledCharacter,
    camera: Camera,
    domElement: HTMLElement | null = null,
    options: CharacterControlsOptions = {},
  ) {
    super(camera, domElement);
    checkControlsOptions(options);
    const { keys, buttons, view, ...fields } = options;
    for (const [name, value] of Object.entries(fields)) {
      if (value !== undefined) Object.assign(this, { [name]: value });
    }
    Object.assign(this.buttons, buttons);
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

  /** Keeps the third-person camera out of walls: a `CameraBoom`; null lets it through. @default null */
  get boom(): Boom | null {
    return this.#rig.boom;
  }

  set boom(boom: Boom | null) {
    checkBoom(boom);
    this.#rig.boom = boom;
    this.#ignored = null;
  }

  /** The stick under a thumb: whether there is one, and where to draw it. */
  get stick(): Readonly<TouchStick> {
    return this.#inputs.fingers.stick;
  }

  /**
   * How much of the avatar should be seen, 0 to 1: less than 1 where the camera comes near, by a wall behind it or a change
   * of view. At 0 the avatar is made invisible; to fade it before that is left to its materials.
   */
  get avatarOpacity(): number {
    return this.#rig.avatarOpacity;
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
    this.#inputs.gamepads.connect(document.defaultView);
  }

  override disconnect(): void {
    const document = this.domElement?.ownerDocument;
    document?.removeEventListener('keydown', this.#onKeyDown);
    document?.removeEventListener('keyup', this.#onKeyUp);
    document?.removeEventListener('visibilitychange', this.#letGo);
    document?.defaultView?.removeEventListener('blur', this.#letGo);
    this.#pointer.disconnect();
    this.#inputs.gamepads.disconnect();
    this.#inputs.clear();
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
   * As if a key of that action went down: for a button on the screen. `release` lets it go; of `jump` and `view` only the
   * press counts.
   */
  press(action: ButtonAction): void {
    if (this.enabled) this.#inputs.screen.press(action);
  }

  /** See `press`. */
  release(action: ButtonAction): void {
    this.#inputs.screen.release(action);
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
    const inputs = this.#inputs;
    inputs.read();
    this.#turn(
      (inputs.gamepads.lookX * this.stickSensitivity - inputs.turn * this.turnSpeed) * delta,
      inputs.gamepads.lookY * this.stickSensitivity * delta,
    );
    const idle = inputs.x === 0 && inputs.z === 0;
    _wish.set(inputs.x, 0, inputs.z).multiplyScalar(inputs.run ? this.runSpeed : this.walkSpeed);
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
    if (inputs.taken('jump')) this.character.jump();
    if (inputs.taken('view')) this.view = this.view === 'first' ? 'third' : 'first';
    this.#crouch(inputs.held('crouch'));
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
    const avatar = character.avatar ?? null;
    if (avatar !== this.#ignored) {
      this.#ignored = avatar;
      if (avatar !== null) this.boom?.ignore?.(avatar);
    }
    const distance = this.view === 'third' ? this.distance : 0;
    rig.place(this.object, character, distance, this.eyeHeight, this.yaw, this.pitch, delta);
    if (avatar !== null) rig.pose(avatar, character, this.#velocity, this.yaw, delta);
  }

  /** Turns the view to the right and down, radians. */
  #turn(right: number, down: number): void {
    this.yaw -= right;
    const pitch = this.pitch - (this.invertY ? -down : down);
    this.pitch = Math.max(-this.maxPitch, Math.min(this.maxPitch, pitch));
  }

  #zoom(ratio: number): boolean {
    if (this.view !== 'third') return false;
    const distance = this.distance * ratio;
    this.distance = Math.max(this.minDistance, Math.min(this.maxDistance, distance));
    return true;
  }

  /** Stands still, once: a character that others walk is left alone. */
  #stop(): void {
    this.#inputs.clear();
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
    if (!locked) this.#inputs.clear();
    this.dispatchEvent({ type: locked ? 'lock' : 'unlock' });
  }

  readonly #onKeyDown = (event: KeyboardEvent): void => {
    if (this.enabled) this.#inputs.keyboard.press(event);
  };

  readonly #onKeyUp = (event: KeyboardEvent): void => this.#inputs.keyboard.release(event);

  readonly #letGo = (): void => this.#inputs.clear();
}
