import { PerspectiveCamera, Scene, Timer, Vector3, type WebGLRenderer } from 'three';
import {
  CameraBoom,
  CharacterController,
  CharacterControls,
  type CubeCollider,
  DEFAULTS,
} from 'three-cube-collider';
import { createAvatar } from './avatar/createAvatar.js';
import { fade } from './boom/fade.js';
import { createCollider, createResponse } from './createCollider.js';
import { fit } from './fit.js';
import { GroundSpeed } from './GroundSpeed.js';
import { createHall, type Hall } from './hall/createHall.js';
import { type Change, createPanel, type Settings } from './hud/panel.js';
import { createLevels } from './level/createLevels.js';
import { disposeOf } from './level/dispose.js';
import type { Level } from './level/Level.js';
import { loadLevel } from './level/loadLevel.js';
import { addLighting, type Lighting } from './lighting.js';
import { createMovers, type Movers } from './movers.js';
import { keepForOffline } from './offline/keepForOffline.js';
import { Overlays } from './overlays/Overlays.js';
import { announce, element, hasMouse, notify, onReducedMotion } from './page.js';
import { DEFAULT_LEVEL, readParameters } from './parameters.js';
import { Pause } from './pause/Pause.js';
import { Quality } from './Quality.js';
import { Race } from './race/Race.js';
import { RacePanel } from './race/RacePanel.js';
import { createWebGLRendering, type Rendering } from './rendering.js';
import { followPreferences, SWITCHES } from './settings/followPreferences.js';
import { keysToChoose, PAGE_KEYS } from './settings/keys.js';
import { onKeys } from './settings/onKeys.js';
import {
  defaultPreferences,
  loadPreferences,
  savePreferences,
  storageOf,
} from './settings/preferences.js';
import { SettingsDialog } from './settings/SettingsDialog.js';
import { showKeys } from './settings/showKeys.js';
import { Opening } from './start/Opening.js';
import { StartScreen } from './start/StartScreen.js';
import { createThumbs } from './touch/createThumbs.js';

const parameters = readParameters(location.search);

const canvas = element<HTMLCanvasElement>('picture');
const antialias = parameters.quality !== 'low';

function start(screen: StartScreen, rendering: Rendering) {
  const { renderer } = rendering;
  renderer.setPixelRatio(parameters.pixelRatio);
  const scene = new Scene();
  const camera = new PerspectiveCamera(70, 1, 0.05, 250);
  const avatar = createAvatar();
  scene.add(avatar.object);

  const settings: Settings = {
    view: 'first',
    output: parameters.output,
    response: parameters.response,
    resolution: parameters.resolution,
    supersample: DEFAULTS.collider.supersample,
    readback: DEFAULTS.collider.readback,
    helper: parameters.helper,
  };
  let level: Level | null = null;
  let collider = createCollider(settings, rendering);
  let character = createCharacter();
  const boomCollider = rendering.createCollider({ resolution: 16 });
  const boom = new CameraBoom<WebGLRenderer, Scene>(boomCollider);
  const controls = new CharacterControls(character, camera, canvas, { view: settings.view, boom });
  const thumbs = parameters.ui ? createThumbs(controls) : null;
  const helper = rendering.createView(collider);
  helper.visible = settings.helper;
  const timer = new Timer();
  timer.connect(document);
  const spawn = new Vector3();
  const groundSpeed = new GroundSpeed();
  let lighting: Lighting | null = null;
  let movers: Movers | null = null;
  let hall: Hall | null = null;

  const race = new Race({
    ...{ scene, controls, spawn, avatar: avatar.object },
    get abyss() {
      return level?.abyss ?? -Infinity;
    },
    ours: () => character as CharacterController & { collider: CubeCollider },
    step: (delta) => character.update(renderer, scene, delta),
    hall: () => hall,
    movers: () => movers?.root ?? null,
  });

  function createCharacter(): CharacterController<WebGLRenderer, Scene> {
    const made = new CharacterController<WebGLRenderer, Scene>(collider, {
      avatar: avatar.object,
      respawnBelow: level?.abyss ?? null,
      response: createResponse(settings),
    });
    // It went back to its last teleport, which a change of settings makes too: the start is meant.
    made.addEventListener('respawn', () => {
      made.teleport(spawn);
      notify('Back at the start');
    });
    return made;
  }

  /** One turn of the loop. */
  function frame(delta: number): void {
    level?.update(delta);
    movers?.update(delta, character.squeezed);
    hall?.update(delta, race.character.position);
    controls.update(delta);
    overlays.before();
    race.update(delta);
    overlays.after();
    controls.follow(delta);
    boom.update(renderer, scene, delta);
    opening?.update(delta);
    fade(avatar.object, controls.avatarOpacity);
    thumbs?.update();

    const walker = race.character;
    lighting?.update(walker.position);
    avatar.animate(
      delta,
      groundSpeed.update(walker, delta),
      // While it waits for surfaces it stands still, whatever is below.
      walker.grounded || !walker.ready,
      walker.crouched,
      walker.velocity.y,
    );

    overlays.update();
    renderer.render(scene, camera);
    if (race.current === 'cube') helper.render(renderer);
    overlays.tell(delta);
  }

  function run(): void {
    timer.reset();
    renderer.setAnimationLoop((time) => {
      timer.update(time);
      // The first time may lie before the reset.
      const delta = Math.max(0, timer.getDelta());
      // Before the frame: another size clears the picture.
      quality?.update(delta);
      frame(delta);
    });
  }

  /** A new collider for new settings; the character goes on where it is. */
  function exchangeCollider(): void {
    void race.choose('cube');
    const old = { collider, character };
    old.character.dispose();
    collider = createCollider(settings, rendering);
    character = createCharacter();
    character.teleport(old.character.position);
    controls.character = character;
    helper.show(collider);
    overlays.show(character, collider);
    old.collider.dispose();
  }

  function apply(what: Change): void {
    if (!opening?.active) controls.view = settings.view;
    helper.visible = settings.helper;
    document.body.classList.toggle('helper', settings.helper);
    if (what === 'collider') exchangeCollider();
    if (what === 'response') character.response = createResponse(settings);
    panel?.refresh();
    overlays.refresh();
  }

  /** Follows the user's preferences; called after any of them changed. */
  function prefer(): void {
    const { motion } = preferences;
    const still = motion === 'system' ? stillSystem : motion === 'reduced';
    followPreferences(controls, preferences);
    controls.smoothing = still ? Infinity : 1;
    document.documentElement.classList.toggle('still', still);
    if (quality) quality.mode = parameters.quality ?? preferences.quality;
    settings.view = preferences.view;
    apply('view');
    resize();
    showKeys(preferences.keys);
  }

  async function load(): Promise<void> {
    const first = await loadLevel(parameters.level, renderer, (part) => screen.loading(part));
    screen.preparing();
    await avatar.ready;
    await enter(first);
    screen.ready();
  }

  /** Puts a level in the place of the last one. */
  async function enter(next: Level): Promise<void> {
    renderer.setAnimationLoop(null);
    level?.dispose();
    for (const gone of [movers, hall]) if (gone !== null) disposeOf(gone.root);
    movers = hall = null;
    level = next;
    lighting ??= addLighting(scene, renderer);
    if (level.own) {
      movers = createMovers(level.root);
      hall = createHall(level.root);
      scene.add(movers.root, hall.root);
      if (parameters.place === 'hall') level.start = { position: hall.entry, yaw: Math.PI };
    }
    rendering.translate(scene);
    scene.add(level.root);
    quality?.refresh();
    begin();
    await race.timed(() => collider.compile(renderer, scene));
    await renderer.compileAsync(scene, camera);
    frame(0);
    run();
  }

  /** Puts the character at the level's start, wherever and however large the level is. */
  function begin(): void {
    if (level === null) return;
    race.reset();
    spawn.copy(level.start.position);
    lighting?.fit(camera, level.own ? 0 : level.width);
    character.respawnBelow = level.abyss;
    character.teleport(spawn);
    controls.yaw = level.start.yaw;
    controls.pitch = 0;
  }

  // What lies over the picture.
  const overlays = new Overlays({
    renderer,
    scene,
    character,
    collider,
    ui: parameters.ui,
    listening: () => controls.enabled,
    cubemap: {
      get: () => settings.helper,
      set(on) {
        settings.helper = on;
        apply('helper');
      },
    },
    view: {
      get: () => settings.view,
      set(view) {
        settings.view = view;
        apply('view');
      },
    },
  });
  const quality = parameters.adaptive || parameters.quality ? new Quality(renderer, scene) : null;
  const panel = parameters.ui ? createPanel(settings, rendering, chosen) : null;
  const opening = parameters.ui ? new Opening(camera, controls, element('words')) : null;
  if (parameters.ui) new RacePanel(race, controls, canvas, () => pause.freeMouse());
  const hint = element('hint');

  // What the user prefers.
  const storage = parameters.ui ? storageOf(window) : null;
  const defaults = defaultPreferences({ ...keysToChoose(controls.keys), ...PAGE_KEYS });
  const preferences = loadPreferences(storage, defaults);
  preferences.view = parameters.view ?? preferences.view;
  const dialog = new SettingsDialog(preferences, defaults, () => {
    prefer();
    savePreferences(storage, preferences);
  });
  for (const name of SWITCHES) if (!(name in controls)) dialog.leaveOut(name);
  let stillSystem = false;

  // Walking, and not.
  const pause = new Pause({
    controls,
    rest: () => renderer.setAnimationLoop(null),
    goOn(capture) {
      run();
      if (capture) takeMouse();
      else showHint();
    },
    restart: begin,
  });

  /** @param capture whether this is a user's gesture, in which the mouse may be captured */
  function walk(capture = true): void {
    controls.enabled = true;
    document.body.classList.add('walking');
    opening?.end(settings.view);
    // Whoever picked a file left the window.
    if (pause.paused) pause.resume();
    else if (capture) takeMouse();
    else showHint();
  }

  /** In a user's gesture: a browser may still refuse, as in the second after Escape; dragging looks then. */
  function takeMouse(): void {
    showHint();
    if (!hasMouse()) return;
    canvas.focus({ preventScroll: true });
    void controls.lock();
  }

  function showHint(): void {
    hint.hidden = !parameters.ui || controls.isLocked;
    hint.textContent = hasMouse()
      ? 'Click to look with the mouse, or drag'
      : 'Left thumb walks, right thumb looks';
  }

  /** A choice in the panel or by a key, which lasts. */
  function chosen(what: Change): void {
    if (what === 'view') {
      preferences.view = settings.view;
      savePreferences(storage, preferences);
      announce(settings.view === 'first' ? 'First person' : 'Third person');
    }
    apply(what);
    // A choice in the panel leaves the keys to the walk again.
    if (document.activeElement instanceof HTMLSelectElement) canvas.focus({ preventScroll: true });
  }

  onKeys(preferences, () => controls.enabled, {
    switchView() {
      settings.view = settings.view === 'first' ? 'third' : 'first';
      chosen('view');
    },
    colliderView() {
      settings.helper = !settings.helper;
      announce(
        settings.helper ? 'Showing what the collider sees' : 'Hiding what the collider sees',
      );
      chosen('helper');
    },
    panel() {
      if (panel?.toggle()) pause.freeMouse();
      else takeMouse();
    },
  });
  for (const type of ['lock', 'unlock'] as const) {
    controls.addEventListener(type, () => {
      document.body.classList.toggle('captured', controls.isLocked);
      showHint();
    });
  }
  canvas.addEventListener('pointermove', ({ buttons }) => {
    if (buttons !== 0) hint.hidden = true;
  });
  // By a gamepad; the panel and the key go the other way round.
  controls.addEventListener('change', ({ view }) => {
    if (view === settings.view) return;
    settings.view = view;
    chosen('view');
  });
  function resize(): void {
    const { innerWidth: width, innerHeight: height } = window;
    renderer.setSize(width, height, false);
    fit(camera, width / height, preferences.fieldOfView);
    // Nothing else draws then.
    if (pause.paused) frame(0);
  }
  window.addEventListener('resize', resize);
  onReducedMotion((reduced) => {
    stillSystem = reduced;
    prefer();
  });
  controls.enabled = !parameters.ui;
  if (!parameters.ui) screen.hide();

  const ready = load().catch((error: unknown) => {
    console.error(error);
    screen.fail(
      error,
      parameters.level === DEFAULT_LEVEL
        ? 'Make it with “npm run build:level”, then try again.'
        : 'Is the address after “?level=” right, and is it a GLB or glTF file?',
    );
  });

  const levels = createLevels({
    renderer,
    ready,
    enter,
    begin,
    get level() {
      return level;
    },
    keepStart() {
      if (level !== null) level.start = { position: character.position.clone(), yaw: controls.yaw };
      begin();
    },
    walk() {
      screen.hide();
      walk(false);
    },
  });

  return {
    renderer,
    scene,
    levels,
    camera,
    avatar,
    controls,
    boom,
    helper,
    overlays,
    settings,
    spawn,
    race,
    /** Resolved once one can walk, or the page has said why not. */
    ready,
    walk,
    apply,
    get collider() {
      return collider;
    },
    get character() {
      return character;
    },
    get level() {
      return level;
    },
    get movers() {
      return movers;
    },
    get hall() {
      return hall;
    },
    /** Stops the loop and goes on by hand: `frames` of `delta` seconds each, alike on every machine. */
    async step(frames: number, delta = 1 / 60): Promise<void> {
      renderer.setAnimationLoop(null);
      for (let i = 0; i < frames; i++) {
        frame(delta);
        if (collider.readback === 'async') await collider.updateAsync(renderer, scene);
        if (controls.view === 'third') await boomCollider.updateAsync(renderer, scene);
      }
    },
    run,
    pause,
    preferences,
  };
}

declare global {
  interface Window {
    /** For the console and for tests. */
    demo: ReturnType<typeof start>;
  }
}

keepForOffline();
const screen = new StartScreen(() => window.demo.walk());
const fail = (error: unknown) => {
  console.error(error);
  screen.fail(error, 'This page needs WebGL 2: is hardware acceleration switched off?');
};
try {
  if (parameters.renderer === 'webgl')
    window.demo = start(screen, createWebGLRendering(canvas, antialias));
  else void startWebGPU().catch(fail);
} catch (error) {
  fail(error);
}

/** Loaded only where it is asked for: a second renderer is as large as the first. */
async function startWebGPU(): Promise<void> {
  const { createWebGPURendering } = await import('./webgpu/createWebGPURendering.js');
  const rendering = await createWebGPURendering(
    canvas,
    antialias,
    parameters.renderer === 'fallback',
  );
  window.demo = start(screen, rendering);
}
