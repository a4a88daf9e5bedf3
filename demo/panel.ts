import { GUI } from 'three/addons/libs/lil-gui.module.min.js';
import { RESOLUTIONS } from './parameters.js';

/** What the panel sets. */
export interface Settings {
  view: 'first' | 'third';
  output: 'axis' | 'surface';
  resolution: number;
  readback: 'async' | 'sync';
  /** Reach of surfaces, metres. */
  far: number;
  helper: boolean;
}

export interface Panel {
  /** Shows what was changed elsewhere, by a key. */
  refresh(): void;
}

/** @param changed called after `settings` were; `collider` if a new collider is needed for it */
export function createPanel(
  settings: Settings,
  changed: (what: 'view' | 'helper' | 'collider') => void,
): Panel {
  const gui = new GUI({ title: 'Collider' });
  gui.domElement.setAttribute('role', 'group');
  gui.domElement.setAttribute('aria-label', 'Settings');
  gui
    .add(settings, 'view', { 'first person': 'first', 'third person': 'third' })
    .onChange(() => changed('view'));
  gui.add(settings, 'output', { 'axis (paper)': 'axis', surface: 'surface' }).onChange(() => {
    showFitting();
    changed('collider');
  });
  gui.add(settings, 'resolution', RESOLUTIONS).onChange(() => changed('collider'));
  const surfaceOnly = [
    gui
      .add(settings, 'readback', ['async', 'sync'])
      .name('read-back')
      .onChange(() => changed('collider')),
    gui
      .add(settings, 'far', 0.8, 4, 0.1)
      .name('reach (m)')
      .onFinishChange(() => changed('collider')),
  ];
  gui
    .add(settings, 'helper')
    .name('collider view')
    .onChange(() => changed('helper'));

  const showFitting = () => {
    for (const controller of surfaceOnly) controller.show(settings.output === 'surface');
  };
  showFitting();
  if (window.innerWidth <= 560) gui.close();
  return { refresh: () => gui.controllersRecursive().forEach((each) => each.updateDisplay()) };
}
