import type { Object3D, Scene, WebGLRenderer } from 'three';
import { CharacterController, type CubeCollider } from 'three-cube-collider';
import { createCollider, createResponse } from './createCollider.js';
import type { Settings } from './hud/panel.js';
import { notify } from './page.js';
import type { Rendering } from './rendering.js';
import type { World } from './World.js';

/** The character, on the collider that the settings ask for. */
export class Player {
  collider: CubeCollider;
  character: CharacterController<WebGLRenderer, Scene>;
  readonly #settings: Settings;
  readonly #rendering: Rendering;
  readonly #world: World;
  readonly #avatar: Object3D;

  constructor(settings: Settings, rendering: Rendering, world: World, avatar: Object3D) {
    this.#settings = settings;
    this.#rendering = rendering;
    this.#world = world;
    this.#avatar = avatar;
    this.collider = createCollider(settings, rendering);
    this.character = this.#createCharacter();
  }

  /** The response that the settings ask for. */
  respond(): void {
    this.character.response = createResponse(this.#settings);
  }

  /**
   * A new collider for new settings; the character goes on where it is.
   *
   * @param follow lets go of the old ones, which then are freed
   */
  exchange(follow: () => void): void {
    const { collider, character } = this;
    character.dispose();
    this.collider = createCollider(this.#settings, this.#rendering);
    this.character = this.#createCharacter();
    this.character.teleport(character.position);
    follow();
    collider.dispose();
  }

  #createCharacter(): CharacterController<WebGLRenderer, Scene> {
    const made = new CharacterController<WebGLRenderer, Scene>(this.collider, {
      avatar: this.#avatar,
      respawnBelow: this.#world.level?.abyss ?? null,
      response: createResponse(this.#settings),
    });
    // It went back to its last teleport, which a change of settings makes too: the start is meant.
    made.addEventListener('respawn', () => {
      made.teleport(this.#world.spawn);
      notify('Back at the start');
    });
    return made;
  }
}
