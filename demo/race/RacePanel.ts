import './race.css';
import type { CharacterControls } from 'three-cube-collider';
import { onePopup } from '../hud/onePopup.js';
import { notify } from '../page.js';
import { type ContestantId, OURS, RIVALS } from './contestants.js';
import { CONTESTANTS, type Race, type Result } from './Race.js';

const ALL = { cube: OURS, ...RIVALS };

const COLUMNS = [
  [
    'before the first step',
    'ms',
    'How long the page stands still until it has taken its first step: to build a tree or a world; ours: to ask for its shaders, which are compiled in the background, and to draw its first cubemap',
  ],
  ['memory', 'MB', 'What it keeps: ours on the GPU too, Octree by a count of its objects'],
  [
    'usual / worst frame',
    'ms',
    'What it takes of the main thread in a frame, picture left out: median and worst of the last two seconds',
  ],
  [
    'inside of things',
    'mm',
    'How deep its body is in what is drawn now, walls, floors and all, by exact distances; the fence’s planks left out',
  ],
] as const;

const HTML = `
<button type="button" class="toggle" aria-expanded="false" aria-controls="race-body">
  <span>Compare</span><b></b><kbd>R</kbd>
</button>
<div id="race-body" hidden>
  <p class="about">The same character, moved by another library. Choose one, and walk.</p>
  <p class="software" hidden>No GPU here: the processor draws, and the cube collider’s times are far above those on one.</p>
  <table>
    <thead><tr><th scope="col"><span class="unseen">Collider</span></th></tr></thead>
    <tbody></tbody>
  </table>
  <p class="cannot"></p>
  <p class="missed"></p>
  <p class="told" role="status"></p>
</div>`;

/** Who walks, at whose cost: a row each. */
export class RacePanel {
  readonly #race: Race;
  readonly #element = document.createElement('section');
  readonly #toggle: HTMLButtonElement;
  readonly #buttons = new Map<ContestantId, HTMLButtonElement>();
  readonly #cells = new Map<ContestantId, HTMLElement[]>();
  readonly #opened = onePopup(() => this.#open(false));

  /**
   * @param canvas has the focus back once one was chosen by a pointer, so that keys walk
   * @param software whether the processor draws what a GPU should
   * @param freeMouse lets go of the mouse without a pause, for the rows to be pointed at
   */
  constructor(
    race: Race,
    controls: CharacterControls,
    canvas: HTMLElement,
    software: boolean,
    freeMouse: () => void,
  ) {
    this.#race = race;
    this.#element.id = 'race';
    this.#element.setAttribute('aria-label', 'Compare with other libraries');
    this.#element.innerHTML = HTML;
    this.#find('.software').hidden = !software;
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
      if (race.watched) {
        void race.next();
        return;
      }
      freeMouse();
      this.#open(true);
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
    button.title = ALL[id].cannot;
    button.addEventListener('click', () => void this.#race.choose(id));
    head.append(button);
    const cells = COLUMNS.map(() => document.createElement('td'));
    row.append(head, ...cells);
    // Anywhere in the row; its button is there for the keyboard.
    row.addEventListener('click', ({ target, detail }) => {
      if (!button.contains(target as Node)) button.click();
      if (detail > 0) canvas.focus({ preventScroll: true });
    });
    this.#find('tbody').append(row);
    this.#buttons.set(id, button);
    this.#cells.set(id, cells);
  }

  #open(open: boolean): void {
    this.#race.watched = open;
    this.#toggle.setAttribute('aria-expanded', String(open));
    this.#toggle.querySelector('kbd')!.textContent = open ? 'R: the next' : 'R';
    this.#find('#race-body').hidden = !open;
    if (!open) return;
    this.#opened();
    this.#race.look();
  }

  #refresh(): void {
    const { current, results, status, missed, watched } = this.#race;
    this.#find('.toggle b').textContent = ALL[current].name;
    for (const id of CONTESTANTS) {
      const button = this.#buttons.get(id)!;
      button.setAttribute('aria-pressed', String(id === current));
      button.closest('tr')!.classList.toggle('walks', id === current);
      const texts = textsOf(results[id]);
      this.#cells.get(id)!.forEach((cell, i) => (cell.textContent = texts[i]!));
    }
    this.#find('.cannot').textContent = ALL[current].cannot;
    if (this.#tell('.missed', missed) && missed !== '' && !watched) notify(missed);
    // What is said must be seen.
    if (this.#tell('.told', status) && status !== '' && !watched) this.#open(true);
  }

  /** @returns whether that is new */
  #tell(selector: string, text: string): boolean {
    const told = this.#find(selector);
    const isNew = told.textContent !== text;
    if (isNew) told.textContent = text;
    return isNew;
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
    times ? `${rounded(times.median, 1)} / ${rounded(times.worst, 1)}` : '–',
    Number.isNaN(inside) ? '–' : rounded(Math.max(0, 1000 * inside), 0),
  ];
}

/** What rounds to nothing, but is something, says so: browsers' clocks are coarse. */
function rounded(value: number, digits: number): string {
  if (Number.isNaN(value)) return '–';
  const least = 10 ** -digits;
  return digits > 0 && value < least / 2 ? `<${least}` : value.toFixed(digits);
}
