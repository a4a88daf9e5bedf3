import type { PageSuite } from '../../bench/suites/pages.mjs';
import type { Suite, SuiteOptions, SuiteRow } from '../../bench/suites/suite.js';
import { barsOf, create } from './bars.js';

/** Loads a suite with all that it compares. */
export type SuiteLoader = () => Promise<{ default: Suite }>;

/** A suite on the page: what it measures, its button, how far it is, its bars. */
export class SuiteCard {
  readonly element = create('section', 'suite');
  readonly name: string;
  readonly button = create('button', 'plain', 'Run');
  /** What it gave, once it has run. */
  rows: SuiteRow[] | null = null;
  /** What it ran with. */
  options: SuiteOptions | null = null;
  readonly #load: SuiteLoader;
  readonly #status = create('p', 'status');
  readonly #bars = create('div');

  constructor({ name, title, about }: PageSuite, load: SuiteLoader) {
    this.name = name;
    this.#load = load;
    this.button.type = 'button';
    const header = create('header');
    header.append(create('h2', '', title), this.button);
    // Markdown's marks, which a page has no use for.
    const text = about.replace(/[`_]/g, '').replace(/\s+/g, ' ');
    this.element.append(header, create('p', 'about', text), this.#status, this.#bars);
  }

  /** Runs the suite; what goes wrong is told in the card. */
  async run(options: SuiteOptions): Promise<void> {
    this.#tell('running', 'Loading…');
    const begin = performance.now();
    try {
      const { default: suite } = await this.#load();
      this.#tell('running', 'Running…');
      await painted();
      const rows = await suite(options, (line) => this.#tell('running', line));
      this.rows = rows;
      this.options = options;
      this.#bars.replaceChildren(...barsOf(rows));
      this.#tell('done', `Done in ${Math.round((performance.now() - begin) / 1000)} s.`);
    } catch (error) {
      this.#tell('failed', error instanceof Error ? error.message : String(error));
    }
  }

  #tell(state: 'running' | 'done' | 'failed', text: string): void {
    this.element.dataset.state = state;
    this.#status.textContent = text;
  }
}

/** Until what was told can be seen: the suite may hold the page up at once. */
const painted = () =>
  new Promise<void>((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
