import type { Object3D, WebGLRenderer } from 'three';
import type { CharacterController, CubeCollider, CubeColliderStats } from 'three-cube-collider';

/** Seconds between two looks at the numbers: they are to be read. */
const INTERVAL = 0.25;

const ROWS = [
  'frame',
  'of it ours',
  '· select',
  '· submit',
  '· read back',
  '· decode',
  '· look, move',
  'latency',
  'cubemaps',
  'picture',
  'position',
  'ground',
  'held',
] as const;

/** Milliseconds of each stage, or counts, all together. */
type Totals = Record<'draws' | 'selecting' | 'submitting' | 'blocked' | 'decoding', number>;

/** The small table of numbers: what a frame costs, what of it is the collider's and the character's, and why. */
export class Numbers {
  readonly element = document.createElement('section');
  readonly #cells = new Map<string, HTMLElement>();
  #seconds = 0;
  #frames = 0;
  /** Milliseconds in `character.update`, without what the collider counts of them. */
  #moving = 0;
  #began = 0;
  #stagesBefore = 0;
  readonly #last: Totals = { draws: 0, selecting: 0, submitting: 0, blocked: 0, decoding: 0 };
  #collider: CubeCollider | null = null;

  constructor() {
    this.element.className = 'numbers';
    this.element.setAttribute('aria-label', 'Numbers');
    const list = document.createElement('dl');
    for (const name of ROWS) {
      const term = document.createElement('dt');
      const value = document.createElement('dd');
      term.textContent = name;
      value.textContent = '–';
      list.append(term, value);
      this.#cells.set(name, value);
    }
    const link = document.createElement('a');
    link.href = './bench.html';
    link.textContent = 'Measure it on this machine';
    this.element.append(list, link);
  }

  /** Right before `character.update`. */
  before({ stats }: CubeCollider): void {
    this.#stagesBefore = stagesOf(stats);
    this.#began = performance.now();
  }

  /** Right after it. */
  after({ stats }: CubeCollider): void {
    const counted = stagesOf(stats) - this.#stagesBefore;
    this.#moving += performance.now() - this.#began - counted;
  }

  /** Once a frame, after the picture was drawn: what it took is known until the next begins. */
  update(
    delta: number,
    character: CharacterController,
    collider: CubeCollider,
    renderer: WebGLRenderer,
  ): void {
    this.#seconds += delta;
    this.#frames++;
    if (collider !== this.#collider) {
      this.#collider = collider;
      Object.assign(this.#last, totalsOf(collider.stats));
    }
    if (this.#seconds < INTERVAL) return;
    this.#tell(character, collider, renderer);
    Object.assign(this.#last, totalsOf(collider.stats));
    this.#seconds = this.#frames = this.#moving = 0;
  }

  #tell(character: CharacterController, collider: CubeCollider, renderer: WebGLRenderer): void {
    const { stats } = collider;
    const frames = this.#frames;
    const spent = (name: keyof Totals) => (stats[name] - this.#last[name]) / frames;
    const stages = {
      '· select': spent('selecting'),
      '· submit': spent('submitting'),
      '· read back': spent('blocked'),
      '· decode': spent('decoding'),
      '· look, move': this.#moving / frames,
    } as const;
    this.#show(
      'frame',
      `${((1000 * this.#seconds) / frames).toFixed(1)} ms · ${Math.round(frames / this.#seconds)} fps`,
    );
    let ours = 0;
    for (const [name, time] of Object.entries(stages)) {
      ours += time;
      this.#show(name, `${time.toFixed(2)} ms`);
    }
    this.#show('of it ours', `${ours.toFixed(2)} ms`);
    // From the draw to the character's next step, or, in the paper's mode, to the page.
    const latency = 1000 * character.latency || stats.latency;
    this.#show('latency', `${latency.toFixed(0)} ms · forced ${stats.forced}`);
    this.#show('cubemaps', `${spent('draws').toFixed(2)} a frame · ${stats.objects} meshes`);
    const { calls, drawCalls, triangles } = renderer.info.render as {
      calls: number;
      drawCalls?: number;
      triangles: number;
    };
    this.#show('picture', `${short(triangles)} triangles · ${drawCalls ?? calls} calls`);
    const { x, y, z } = character.position;
    this.#show('position', [x, y, z].map((value) => signed(value)).join(' '));
    this.#show('ground', standing(character));
    const { held, slowed } = character.stats;
    this.#show('held', `${held} · slowed ${slowed}`);
  }

  #show(name: string, text: string): void {
    this.#cells.get(name)!.textContent = text;
  }
}

function totalsOf({ draws, selecting, submitting, blocked, decoding }: CubeColliderStats): Totals {
  return { draws, selecting, submitting, blocked, decoding };
}

function stagesOf({ selecting, submitting, blocked, decoding }: CubeColliderStats): number {
  return selecting + submitting + blocked + decoding;
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

function short(count: number): string {
  if (count < 10_000) return String(count);
  return count < 1e6 ? `${Math.round(count / 1000)}k` : `${(count / 1e6).toFixed(1)}M`;
}

/** Two digits after the point, with a sign as wide as a digit. */
function signed(value: number): string {
  return `${value < -0.005 ? '−' : '\u2007'}${Math.abs(value).toFixed(2)}`;
}
