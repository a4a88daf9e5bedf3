import type { Object3D, Scene, WebGLRenderer } from 'three';
import type { CharacterController, CharacterControls, CubeCollider } from 'three-cube-collider';
import {
  CharacterHelper,
  ContactsHelper,
  FreeSpaceHelper,
  ReadbackTimeline,
  SurfelsHelper,
} from 'three-cube-collider/helpers';
import type { Change, Settings } from '../hud/panel.js';
import { OVERLAYS, type OverlayName } from './kinds.js';
import { Numbers } from './Numbers.js';
import { OverlayList } from './OverlayList.js';
import { RestingStrip } from './RestingStrip.js';
import { StepBehind } from './StepBehind.js';

export interface OverlaysOptions {
  renderer: WebGLRenderer;
  scene: Scene;
  character: CharacterController<never, never> | CharacterController;
  collider: CubeCollider;
  /** Whether there is a list of them on the page. */
  ui: boolean;
  /** Keys count while they do. */
  controls: CharacterControls;
  /** They know of the view and of the unfolded cubemap, too. */
  settings: Settings;
  /** Called after `settings` were changed. */
  apply: (what: Change) => void;
  /** The view that the user has chosen last. */
  preferredView: () => Settings['view'];
}

/** A helper that stands in the scene. */
type Helper = Object3D & { update(): void };

/** All that shows what the collider sees: made once it is asked for, and asleep when it is not. */
export class Overlays {
  readonly #options: OverlaysOptions;
  readonly #on = new Set<OverlayName>();
  readonly #numbers = new Numbers();
  readonly #list: OverlayList | null;
  readonly #strip = new RestingStrip();
  readonly #behind: StepBehind;
  /** Whether another library walks, of which there is nothing to show. */
  #resting = false;
  #character: CharacterController;
  #collider: CubeCollider;
  #contacts: ContactsHelper | null = null;
  #body: CharacterHelper | null = null;
  #surfels: SurfelsHelper | null = null;
  #free: FreeSpaceHelper | null = null;
  #timeline: ReadbackTimeline | null = null;

  constructor(options: OverlaysOptions) {
    this.#options = options;
    this.#character = options.character as CharacterController;
    this.#collider = options.collider;
    this.#behind = new StepBehind(options.settings, options.apply, options.preferredView);
    this.#list = options.ui ? new OverlayList((name) => this.#toggle(name)) : null;
    const column = document.createElement('div');
    column.className = 'overlays';
    if (this.#list !== null) column.append(this.#list.element);
    column.append(this.#numbers.element);
    document.body.append(column, this.#strip.element);
    const first = new URLSearchParams(location.search).get('show')?.split(',') ?? [];
    for (const { name } of OVERLAYS) if (name !== 'cubemap') this.set(name, first.includes(name));
    window.addEventListener('keydown', (event) => this.#press(event));
    this.refresh();
  }

  has(name: OverlayName): boolean {
    return name === 'cubemap' ? this.#options.settings.helper : this.#on.has(name);
  }

  /** Shows or hides one. */
  set(name: OverlayName, on: boolean): void {
    if (name === 'cubemap') {
      this.#options.settings.helper = on;
      this.#options.apply('helper');
      return;
    }
    if (on) this.#on.add(name);
    else this.#on.delete(name);
    this.#make(name);
    this.refresh();
  }

  /** As a user asks for it. */
  #toggle(name: OverlayName): void {
    this.set(name, !this.has(name));
    this.#behind.changed(name, (each) => this.has(each));
  }

  /** Others, from now on. */
  show(
    character: CharacterController<never, never> | CharacterController,
    collider: CubeCollider,
  ): void {
    this.#character = character as CharacterController;
    this.#collider = collider;
    for (const helper of [this.#contacts, this.#body]) {
      if (helper !== null) helper.character = this.#character;
    }
    for (const helper of [this.#surfels, this.#free, this.#timeline]) {
      if (helper !== null) helper.collider = collider;
    }
    if (this.#timeline !== null) this.#timeline.character = this.#character;
  }

  /** Hides all of them while another library walks. */
  rest(resting: boolean): void {
    if (this.#resting === resting) return;
    this.#resting = resting;
    this.refresh();
  }

  /** Right before `character.update`. */
  before(): void {
    this.#numbers.before(this.#collider);
  }

  /** Right after it. */
  after(): void {
    this.#numbers.after(this.#collider);
  }

  /** Once a frame, before the picture is drawn. */
  update(): void {
    this.#contacts?.update();
    this.#body?.update();
    this.#surfels?.update();
    this.#free?.update();
    this.#timeline?.update();
    this.#strip.update(this.#collider.stats.draws);
  }

  /** Once a frame, after the picture was drawn. */
  tell(delta: number): void {
    const { renderer } = this.#options;
    if (this.#resting || !this.#on.has('numbers')) this.#numbers.rest();
    else this.#numbers.update(delta, this.#character, this.#collider, renderer);
  }

  /** Tells the page what is shown. */
  refresh(): void {
    for (const { name } of OVERLAYS) this.#list?.show(name, this.has(name));
    const shown = (name: OverlayName) => !this.#resting && this.#on.has(name);
    for (const [helper, name] of [
      [this.#contacts, 'contacts'],
      [this.#body, 'body'],
      [this.#surfels, 'surfels'],
      [this.#free, 'free'],
      [this.#timeline, 'timeline'],
    ] as const) {
      if (helper !== null) helper.visible = shown(name);
    }
    this.#numbers.element.hidden = !shown('numbers');
    this.#strip.element.hidden = !shown('timeline');
  }

  #press({ code, repeat, ctrlKey, altKey, metaKey, target }: KeyboardEvent): void {
    if (!this.#options.controls.enabled || repeat || ctrlKey || altKey || metaKey) return;
    if (target instanceof HTMLInputElement || target instanceof HTMLSelectElement) return;
    const kind = OVERLAYS.find((each) => each.code === code);
    // That one's key is among those which the page lets a user choose.
    if (kind !== undefined && kind.name !== 'cubemap') this.#toggle(kind.name);
  }

  /** Makes what is on and was not there yet. */
  #make(name: OverlayName): void {
    if (!this.#on.has(name)) return;
    const character = this.#character;
    const collider = this.#collider;
    if (name === 'contacts') this.#contacts ??= this.#add(new ContactsHelper(character));
    if (name === 'body') this.#body ??= this.#add(new CharacterHelper(character));
    if (name === 'surfels') this.#surfels ??= this.#add(new SurfelsHelper(collider));
    if (name === 'free') this.#free ??= this.#add(new FreeSpaceHelper(collider));
    if (name === 'timeline') {
      this.#timeline ??= new ReadbackTimeline(collider, this.#strip.canvas, { character });
    }
  }

  #add<T extends Helper>(helper: T): T {
    this.#options.scene.add(helper);
    return helper;
  }
}
