import describeMachine, { type Machine } from '../../bench/suites/machine.js';
import { PAGE_SUITES } from '../../bench/suites/pages.mjs';
import type { Entry } from '../../bench/report/results.mjs';
import { devDependencies, version } from '../../package.json';
import { element } from '../page.js';
import { SuiteCard, type SuiteLoader } from './SuiteCard.js';

const modules = import.meta.glob('../../bench/suites/{load,step,gpu,moving,crowd,feel}.ts');
const level = { name: 'level.glb', url: `${import.meta.env.BASE_URL}level.glb` };

const cards = PAGE_SUITES.flatMap((suite) => {
  const load = modules[`../../bench/suites/${suite.name}.ts`] as SuiteLoader | undefined;
  return load ? [new SuiteCard(suite, load)] : [];
});
const runAll = element<HTMLButtonElement>('run-all');
const copy = element<HTMLButtonElement>('copy');
const quick = element<HTMLInputElement>('quick');

let machine: Machine | null = null;
void describeMachine().then((found) => {
  machine = found;
  for (const [id, name] of Object.entries(found)) element(id).textContent = name;
});

/** Runs suites one after the other; none may be started meanwhile. */
async function run(chosen: SuiteCard[]): Promise<void> {
  const buttons = [runAll, copy, ...cards.map(({ button }) => button)];
  for (const button of buttons) button.disabled = true;
  for (const [i, card] of chosen.entries()) {
    if (chosen.length > 1) tell(`${i + 1} of ${chosen.length}: ${card.name}`);
    await card.run({
      quick: quick.checked,
      repeats: quick.checked ? 1 : 5,
      levels: [level],
    });
  }
  tell('');
  for (const button of buttons) button.disabled = false;
  copy.disabled = cards.every(({ rows }) => rows === null);
}

/** What has run so far, in the form that `npm run bench -- --from file` takes. */
function results(): { suites: Record<string, Entry> } {
  const suites: Record<string, Entry> = {};
  for (const { name, rows, options } of cards) {
    if (rows === null || options === null) continue;
    suites[name] = {
      date: new Date().toISOString().slice(0, 10),
      machine: `${navigator.hardwareConcurrency} cores`,
      browser: machine?.browser,
      gpu: `WebGL: ${machine?.webgl}; WebGPU: ${machine?.webgpu}`,
      versions: {
        'three-cube-collider': version,
        three: devDependencies.three,
        'three-mesh-bvh': devDependencies['three-mesh-bvh'],
        '@dimforge/rapier3d-compat': devDependencies['@dimforge/rapier3d-compat'],
      },
      options: {
        quick: options.quick,
        repeats: options.repeats,
        levels: options.levels.map(({ name }) => name),
      },
      rows,
    };
  }
  return { suites };
}

function tell(text: string): void {
  element('told').textContent = text;
}

for (const card of cards) {
  element('suites').append(card.element);
  card.button.addEventListener('click', () => void run([card]));
}
runAll.addEventListener('click', () => void run(cards));
copy.addEventListener('click', async () => {
  const text = JSON.stringify(results());
  try {
    await navigator.clipboard.writeText(text);
    tell('Copied.');
  } catch {
    // Without leave to use the clipboard, or not over https: to be copied by hand.
    console.log(text);
    tell('The browser allows no copying: the JSON is in its console.');
  }
});
