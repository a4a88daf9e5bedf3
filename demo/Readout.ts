import type { Object3D } from 'three';
import type { CharacterController, CubeCollider } from 'three-cube-collider';
import { element } from './page.js';

/** Seconds between two looks at the numbers: they are to be read. */
const INTERVAL = 0.25;

const ROWS = [
  'frame',
  'position',
  'ground',
  'contacts',
  'held',
  'draws',
  'reads',
  'blocked',
  'latency',
] as const;

/** The small table of numbers in the corner. */
export class Readout {
  readonly #list = element('readout');
  readonly #cells = new Map<string, HTMLElement>();
  #seconds = 0;
  #frames = 0;
  /** Totals at the last look. */
  #draws = 0;
  #reads = 0;
  #blocked = 0;
  #collider: CubeCollider | null = null;

  constructor() {
    this.#list.hidden = false;
    for (const name of ROWS) {
      const term = document.createElement('dt');
      const value = document.createElement('dd');
      term.textContent = name;
      value.textContent = '–';
      this.#list.append(term, value);
      this.#cells.set(name, value);
    }
  }

  update(delta: number, character: CharacterController, collider: CubeCollider): void {
    this.#seconds += delta;
    this.#frames++;
    if (this.#seconds < INTERVAL) return;
    const { stats } = collider;
    if (collider !== this.#collider) {
      this.#collider = collider;
      this.#draws = this.#reads = this.#blocked = 0;
    }
    const frames = this.#frames;
    const { x, y, z } = character.position;
    const draws = (stats.draws - this.#draws) / frames;
    const reads = (stats.reads - this.#reads) / frames;
    const blocked = (stats.blocked - this.#blocked) / frames;
    this.#show(
      'frame',
      `${((1000 * this.#seconds) / frames).toFixed(1)} ms · ${Math.round(frames / this.#seconds)} fps`,
    );
    this.#show('position', [x, y, z].map((value) => signed(value)).join(' '));
    this.#show('ground', standing(character));
    this.#show('contacts', String(character.contacts.length));
    const { held, slowed } = character.stats;
    this.#show('held', `${held} · slowed ${slowed}`);
    this.#show('draws', `${draws.toFixed(2)} a frame`);
    this.#show('reads', `${reads.toFixed(2)} a frame`);
    this.#show('blocked', `${blocked.toFixed(1)} ms a frame`);
    // From the draw to the character's next step, or, in the paper's mode, to the page.
    const latency = 1000 * character.latency || stats.latency;
    this.#show('latency', `${latency.toFixed(1)} ms`);
    this.#draws = stats.draws;
    this.#reads = stats.reads;
    this.#blocked = stats.blocked;
    this.#seconds = this.#frames = 0;
  }

  #show(name: (typeof ROWS)[number], text: string): void {
    this.#cells.get(name)!.textContent = text;
  }
}

/** What it stands on, by name, or why it does not. */
function standing({ ready, squeezed, grounded, ground }: CharacterController): string {
  if (!ready) return 'waiting';
  if (squeezed) return 'squeezed';
  if (!grounded) return 'in the air';
  return nameOf(ground?.object ?? null) || 'standing';
}

/** A glTF mesh of several materials comes as a mesh each, named with a number behind. */
function nameOf(object: Object3D | null): string {
  return object?.name.replace(/_\d+$/, '') ?? '';
}

/** Two digits after the point, with a sign as wide as a digit. */
function signed(value: number): string {
  return `${value < -0.005 ? '−' : '\u2007'}${Math.abs(value).toFixed(2)}`;
}
