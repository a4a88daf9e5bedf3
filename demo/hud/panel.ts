import { GUI } from 'lil-gui';
import { DEFAULTS } from 'three-cube-collider';
import { element } from '../page.js';
import { type Parameters, RESOLUTIONS } from '../parameters.js';
import type { Rendering } from '../rendering.js';
import { onePopup } from './onePopup.js';

/** What the panel sets. */
export interface Settings {
  view: 'first' | 'third';
  output: 'axis' | 'surface';
  response: 'slide' | 'axis';
  resolution: number;
  supersample: 1 | 2 | 4;
  readback: 'async' | 'sync';
  helper: boolean;
}

/** What one begins with. */
export const settingsOf = ({ output, response, resolution, helper }: Parameters): Settings => ({
  view: 'first',
  ...{ output, response, resolution, helper },
  supersample: DEFAULTS.collider.supersample,
  readback: DEFAULTS.collider.readback,
});

/** What a change of the settings asks for: another response, or another collider. */
export type Change = 'view' | 'helper' | 'response' | 'collider';

export interface Panel {
  /** Shows what was changed elsewhere, by a key. */
  refresh(): void;
  /** Opens or closes it; the keys stay with the walk. @returns whether it is open now */
  toggle(): boolean;
}

/** @param changed called after `settings` were */
export function createPanel(
  settings: Settings,
  { backend, canWait }: Rendering,
  changed: (what: Change) => void,
): Panel {
  // Its styles as a file: a strict policy of content refuses those that a script writes.
  const gui = new GUI({ title: 'Collider', container: element('hud'), injectStyles: false });
  gui.domElement.setAttribute('role', 'group');
  gui.domElement.setAttribute('aria-label', 'Collider');
  gui.close();
  const opened = onePopup(() => gui.close());
  gui.onOpenClose(() => {
    if (!gui._closed) opened();
  });
  gui
    .add(settings, 'view', { 'first person': 'first', 'third person': 'third' })
    .onChange(() => changed('view'));
  gui.add(settings, 'output', { surface: 'surface', 'axis (paper)': 'axis' }).onChange(() => {
    showFitting();
    changed('collider');
  });
  const response = gui
    .add(settings, 'response', { slide: 'slide', 'axis (paper)': 'axis' })
    .onChange(() => changed('response'));
  gui.add(settings, 'resolution', RESOLUTIONS).onChange(() => changed('collider'));
  const finer = gui
    .add(settings, 'supersample', { no: 1, twice: 2, '4 times': 4 })
    .name('drawn finer')
    .onChange(() => changed('collider'));
  const readback = gui
    .add(settings, 'readback', ['async', 'sync'])
    .name('read-back')
    .onChange(() => changed('collider'));
  gui
    .add(settings, 'helper')
    .name('collider view')
    .onChange(() => changed('helper'));

  gui.add({ backend }, 'backend').name('drawn by').disable();

  const showFitting = () => {
    const surface = settings.output === 'surface';
    response.show(surface);
    finer.show(surface);
    readback.show(surface && canWait);
  };
  showFitting();
  return {
    refresh: () => gui.controllersRecursive().forEach((each) => each.updateDisplay()),
    toggle() {
      gui.open(gui._closed);
      return !gui._closed;
    },
  };
}
