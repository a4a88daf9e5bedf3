import './race.css';
import type { CharacterControls } from 'three-cube-collider';
import { type ContestantId, OURS, RIVALS } from './contestants.js';
import { CONTESTANTS, type Race, type Result } from './Race.js';

const ALL = { cube: OURS, ...RIVALS };

const COLUMNS = [
  [
    'build',
    'ms',
    'Milliseconds that the page is kept until it is built; ours: until its programs are compiled',
  ],
  ['keeps', 'MB', 'Memory that it keeps: ours on the GPU too, Octree by a count of its objects'],
  ['a frame', 'ms', 'Of the main thread: median and worst of the last two seconds'],
  [
    'inside',
    'mm',
    'How deep its body is in what is drawn now, by exact distances; the fence’s planks left out',
  ],
] as const;

const HTML = `
<button type="button" class="toggle" aria-expanded="false" aria-controls="race-body">
  <span>Race</span><b></b><kbd title="Switches to the next one">R</kbd>
</button>
<div id="race-body" hidden>
  <table>
    <thead><tr><th scope="col"><span class="unseen">Collider</span></th></tr></thead>
    <tbody></tbody>
  </table>
  <p class="cannot"></p>
  <p class="told" role="status"></p>
</div>`;

/** Who walks, at whose cost: a row each. */
export class RacePanel {
  readonly #race: Race;
  readonly #element = document.createElement('section');
  readonly #toggle: HTMLButtonElement;
  readonly #buttons = new Map<ContestantId, HTMLButtonElement>();
  readonly #cells = new Map<ContestantId, HTMLElement[]>();

  /** @param canvas has the focus back once one was chosen by a pointer, so that keys walk */
  constructor(race: Race, controls: CharacterControls, canvas: HTMLElement) {
    this.#race = race;
    this.#element.id = 'race';
    this.#element.setAttribute('aria-label', 'Race beside other colliders');
    this.#element.innerHTML = HTML;
    this.#toggle = this.#find('.toggle');
    const head = this.#find('thead tr');
    for (const [name, unit, title] of COLUMNS) {
      const cell = document.createElement('th');
      cell.scope = 'col';
      cell.title = title;
      cell.innerHTML = `${name} <small>${unit}</small>`;
      head.append(cell);
    }
    for (const id of CONTESTANTS) this.#addRow(id, canvas);
    this.#toggle.addEventListener('click', () => this.#open(!race.watched));
    window.addEventListener('keydown', (event) => {
      const { code, repeat, ctrlKey, altKey, metaKey, target } = event;
      if (code !== 'KeyR' || !controls.enabled || repeat || ctrlKey || altKey || metaKey) return;
      if (target instanceof HTMLInputElement || target instanceof HTMLSelectElement) return;
      void race.next();
    });
    document.body.append(this.#element);
    race.onChange = () => this.#refresh();
    this.#refresh();
  }

  #addRow(id: ContestantId, canvas: HTMLElement): void {
    const row = document.createElement('tr');
    const head = document.createElement('th');
    const button = document.createElement('button');
    head.scope = 'row';
    button.type = 'button';
    button.textContent = ALL[id].name;
    button.addEventListener('click', ({ detail }) => {
      void this.#race.choose(id);
      if (detail > 0) canvas.focus({ preventScroll: true });
    });
    head.append(button);
    const cells = COLUMNS.map(() => document.createElement('td'));
    row.append(head, ...cells);
    this.#find('tbody').append(row);
    this.#buttons.set(id, button);
    this.#cells.set(id, cells);
  }

  #open(open: boolean): void {
    this.#race.watched = open;
    this.#toggle.setAttribute('aria-expanded', String(open));
    this.#find('#race-body').hidden = !open;
    if (open) this.#race.look();
  }

  #refresh(): void {
    const { current, results, status } = this.#race;
    this.#find('.toggle b').textContent = ALL[current].name;
    for (const id of CONTESTANTS) {
      this.#buttons.get(id)!.setAttribute('aria-pressed', String(id === current));
      const texts = textsOf(results[id]);
      this.#cells.get(id)!.forEach((cell, i) => (cell.textContent = texts[i]!));
    }
    this.#find('.cannot').textContent = ALL[current].cannot;
    const told = this.#find('.told');
    if (told.textContent !== status) told.textContent = status;
    // What is said must be seen.
    if (status !== '' && !this.#race.watched) this.#open(true);
  }

  #find<E extends HTMLElement>(selector: string): E {
    return this.#element.querySelector<E>(selector)!;
  }
}

function textsOf({ build, bytes, frames, inside }: Result): string[] {
  const times = frames.summary();
  return [
    rounded(build, 0),
    rounded(bytes / 1e6, 1),
    times ? `${rounded(times.median, 1)} · ${rounded(times.worst, 1)}` : '–',
    Number.isNaN(inside) ? '–' : rounded(Math.max(0, 1000 * inside), 0),
  ];
}

/** What rounds to nothing, but is something, says so: browsers' clocks are coarse. */
function rounded(value: number, digits: number): string {
  if (Number.isNaN(value)) return '–';
  const least = 10 ** -digits;
  return digits > 0 && value < least / 2 ? `<${least}` : value.toFixed(digits);
}
