import type { Object3D, WebGLRenderer } from 'three';
import type { CharacterController, CubeCollider, CubeColliderStats } from 'three-cube-collider';

/** Seconds between two looks at the numbers: they are to be read. */
const INTERVAL = 0.25;

/** What each row is called, and what it means, for who points at it. */
const ROWS = [
  ['a frame', 'From one picture to the next, and how many of them a second'],
  [
    'of it, for colliding',
    'How long collider and character keep the page busy a frame; its parts:',
  ],
  ['· find what is near', 'Meshes and triangles within reach of the character'],
  ['· draw the cubemap', 'What it takes to tell the GPU to draw it'],
  ['· wait for the GPU', 'How long the page stands still for what comes back'],
  ['· make surfaces of it', 'Distances and normals, out of the pixels that came back'],
  ['· move the character', 'Contacts, steps, slopes; and whether a new cubemap is due'],
  ['age of what it sees', 'From when a cubemap was drawn to the step that walks by it'],
  [
    'cubemaps',
    'How many are drawn, and how many meshes were in the last one; none while it stands',
  ],
  ['the whole picture', 'What the page draws for you to see, in a frame'],
  ['where it is', 'Its foot: x, y, z in metres'],
  ['stands on', 'The mesh below its foot, by its name in the level'],
  [
    'waited',
    'Steps so far that it stood for want of a cubemap, and steps that it took slower for it',
  ],
] as const;
type Row = (typeof ROWS)[number][0];

/** Milliseconds of each stage, or counts, all together. */
type Totals = Record<'draws' | 'selecting' | 'submitting' | 'blocked' | 'decoding', number>;

/** The small table of numbers: what a frame costs, what of it is the collider's and the character's, and why. */
export class Numbers {
  readonly element = document.createElement('section');
  readonly #cells = new Map<Row, HTMLElement>();
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
    for (const [name, meaning] of ROWS) {
      const term = document.createElement('dt');
      const value = document.createElement('dd');
      term.textContent = name;
      term.title = value.title = meaning;
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
    // A frame of which the beginning was not seen does not count.
    if (collider !== this.#collider) {
      this.rest();
      this.#collider = collider;
      Object.assign(this.#last, totalsOf(collider.stats));
      return;
    }
    this.#seconds += delta;
    this.#frames++;
    if (this.#seconds < INTERVAL) return;
    this.#tell(character, collider, renderer);
    Object.assign(this.#last, totalsOf(collider.stats));
    this.#seconds = this.#frames = this.#moving = 0;
  }

  /** Nobody looks: what goes on meanwhile is no part of what is told next. */
  rest(): void {
    this.#collider = null;
    this.#seconds = this.#frames = this.#moving = 0;
  }

  #tell(character: CharacterController, collider: CubeCollider, renderer: WebGLRenderer): void {
    const { stats } = collider;
    const frames = this.#frames;
    const spent = (name: keyof Totals) => (stats[name] - this.#last[name]) / frames;
    const stages = {
      '· find what is near': spent('selecting'),
      '· draw the cubemap': spent('submitting'),
      '· wait for the GPU': spent('blocked'),
      '· make surfaces of it': spent('decoding'),
      '· move the character': this.#moving / frames,
    } as const;
    this.#show(
      'a frame',
      `${((1000 * this.#seconds) / frames).toFixed(1)} ms, ${Math.round(frames / this.#seconds)} a second`,
    );
    let ours = 0;
    for (const [name, time] of Object.entries(stages)) {
      ours += time;
      this.#show(name as Row, `${time.toFixed(2)} ms`);
    }
    this.#show('of it, for colliding', `${ours.toFixed(2)} ms`);
    // From the draw to the character's next step, or, in the paper's mode, to the page.
    const latency = 1000 * character.latency || stats.latency;
    this.#show('age of what it sees', `${latency.toFixed(0)} ms`);
    const perSecond = (stats.draws - this.#last.draws) / this.#seconds;
    this.#show('cubemaps', `${perSecond.toFixed(0)} a second, ${stats.objects} meshes`);
    const { calls, drawCalls, triangles } = renderer.info.render as {
      calls: number;
      drawCalls?: number;
      triangles: number;
    };
    this.#show('the whole picture', `${short(triangles)} triangles, ${drawCalls ?? calls} calls`);
    const { x, y, z } = character.position;
    this.#show('where it is', [x, y, z].map((value) => signed(value)).join(' '));
    this.#show('stands on', standing(character));
    const { held, slowed } = character.stats;
    this.#show('waited', `${held} steps, slowed ${slowed}`);
  }

  #show(name: Row, text: string): void {
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
