import { PerspectiveCamera, Scene, type WebGLRenderer } from 'three';
import { CameraBoom, CharacterControls } from 'three-cube-collider';
import { createAvatar } from './avatar/createAvatar.js';
import { followWalker } from './avatar/followWalker.js';
import { fade } from './boom/fade.js';
import { fit } from './fit.js';
import { handleOf } from './handle.js';
import { MouseHint } from './hud/MouseHint.js';
import { type Change, createPanel, settingsOf } from './hud/panel.js';
import { showFocus } from './hud/showFocus.js';
import { createLevels } from './level/createLevels.js';
import type { Level } from './level/Level.js';
import { loadLevel } from './level/loadLevel.js';
import { Loop } from './Loop.js';
import { keepForOffline } from './offline/keepForOffline.js';
import { Overlays } from './overlays/Overlays.js';
import { element } from './page.js';
import { readParameters } from './parameters.js';
import { Pause } from './pause/Pause.js';
import { Player } from './Player.js';
import { Quality } from './Quality.js';
import { type OurCharacter, Race } from './race/Race.js';
import { RacePanel } from './race/RacePanel.js';
import { openRendering, type Rendering } from './rendering.js';
import { Choices } from './settings/Choices.js';
import { Opening } from './start/Opening.js';
import { StartScreen } from './start/StartScreen.js';
import { createThumbs } from './touch/createThumbs.js';
import { World } from './World.js';

const parameters = readParameters(location.search);
const { ui } = parameters;
const canvas = element<HTMLCanvasElement>('picture');

/** Puts the page together; `frame` is what it does over and over. */
function start(screen: StartScreen, rendering: Rendering) {
  // What one walks in, and who walks.
  const { renderer } = rendering;
  renderer.setPixelRatio(parameters.pixelRatio);
  const scene = new Scene();
  const camera = new PerspectiveCamera(70, 1, 0.05, 250);
  const avatar = createAvatar();
  scene.add(avatar.object);
  const animate = followWalker(avatar);
  const settings = settingsOf(parameters);
  const world = new World(scene, rendering);
  const player = new Player(settings, rendering, world, avatar.object);
  const boomCollider = rendering.createCollider({ resolution: 16 });
  const boom = new CameraBoom<WebGLRenderer, Scene>(boomCollider);
  const controls = new CharacterControls(player.character, camera, canvas, {
    view: settings.view,
    boom,
  });
  const race = new Race({
    ...{ scene, controls, avatar: avatar.object, world },
    ours: () => player.character as OurCharacter,
    step: (delta) => player.character.update(renderer, scene, delta),
  });

  // What lies over the picture.
  const helper = rendering.createView(player.collider);
  helper.visible = settings.helper;
  const thumbs = ui ? createThumbs(controls) : null;
  const overlays = new Overlays({
    ...{ renderer, scene, controls, settings, apply, ui },
    ...{ character: player.character, collider: player.collider },
    preferredView: () => choices.preferences.view,
  });
  const quality = parameters.adaptive || parameters.quality ? new Quality(renderer, scene) : null;
  const panel = ui ? createPanel(settings, rendering, (what) => choices.chosen(what)) : null;
  const opening = ui ? new Opening(camera, controls, element('words')) : null;
  if (ui) new RacePanel(race, controls, canvas, rendering.software, () => pause.freeMouse());
  const mouse = new MouseHint(controls, canvas, ui);

  /** One turn of the loop. */
  function frame(delta: number): void {
    world.update(delta, player.character.squeezed, race.character.position);
    controls.update(delta);
    overlays.before();
    race.update(delta);
    overlays.after();
    controls.follow(delta);
    boom.update(renderer, scene, delta);
    opening?.update(delta);
    fade(avatar.object, controls.avatarOpacity);
    thumbs?.update();

    world.light(race.character.position);
    animate(race.character, delta);

    overlays.rest(race.current !== 'cube');
    overlays.update();
    renderer.render(scene, camera);
    if (race.current === 'cube') helper.render(renderer);
    overlays.tell(delta);
  }

  const loop = new Loop(renderer, {
    // Another size clears the picture.
    before: (delta) => quality?.update(delta),
    frame,
    async settle() {
      const { collider } = player;
      if (collider.readback === 'async') await collider.updateAsync(renderer, scene);
      if (controls.view === 'third') await boomCollider.updateAsync(renderer, scene);
    },
  });

  /** After `settings` have changed. */
  function apply(what: Change): void {
    if (!opening?.active) controls.view = settings.view;
    helper.visible = settings.helper;
    document.body.classList.toggle('helper', settings.helper);
    if (what === 'collider') exchangeCollider();
    if (what === 'response') player.respond();
    panel?.refresh();
    overlays.refresh();
  }

  function exchangeCollider(): void {
    void race.choose('cube');
    player.exchange(() => {
      controls.character = player.character;
      helper.show(player.collider);
      overlays.show(player.character, player.collider);
    });
  }

  // Levels: the first one, and those that a user brings.
  async function load(): Promise<void> {
    const first = await loadLevel(parameters.level, renderer, (part) => screen.loading(part));
    screen.preparing();
    await avatar.ready;
    await enter(first);
    screen.ready();
  }

  /** Puts a level in the place of the last one. */
  async function enter(level: Level): Promise<void> {
    loop.rest();
    world.take(level, parameters.place);
    quality?.refresh();
    begin();
    await race.timed(() => player.collider.compile(renderer, scene));
    await renderer.compileAsync(scene, camera);
    frame(0);
    loop.run();
  }

  /** Puts the character at the level's start, wherever and however large the level is. */
  function begin(): void {
    const { level } = world;
    if (level === null) return;
    race.reset();
    controls.yaw = world.begin(level, camera);
    controls.pitch = 0;
    player.character.respawnBelow = level.abyss;
    player.character.teleport(world.spawn);
  }

  // Walking, and not.
  const pause = new Pause({
    controls,
    rest: () => loop.rest(),
    goOn(capture) {
      loop.run();
      mouse.begin(capture);
    },
    restart: begin,
  });

  /** @param capture whether this is a user's gesture, in which the mouse may be captured */
  function walk(capture = true): void {
    controls.enabled = true;
    document.body.classList.add('walking');
    choices.walk();
    opening?.end(settings.view);
    // Whoever picked a file left the window.
    if (pause.paused) pause.resume();
    else mouse.begin(capture);
  }

  const choices = new Choices({
    ...{ settings, controls, canvas, parameters, apply },
    prefer(preferences) {
      if (quality) quality.mode = parameters.quality ?? preferences.quality;
      resize();
    },
    togglePanel() {
      if (panel?.toggle()) pause.freeMouse();
      else mouse.begin(true);
    },
  });

  function resize(): void {
    const { innerWidth: width, innerHeight: height } = window;
    renderer.setSize(width, height, false);
    fit(camera, width / height, choices.preferences.fieldOfView);
    // Nothing else draws then.
    if (pause.paused) frame(0);
  }
  window.addEventListener('resize', resize);
  choices.begin();
  controls.enabled = !ui;
  if (!ui) screen.hide();

  const ready = load().catch((error: unknown) => screen.failLevel(error, parameters.level));
  const levels = createLevels({
    ...{ renderer, ready, enter, begin },
    get level() {
      return world.level;
    },
    keepStart() {
      const position = player.character.position.clone();
      if (world.level !== null) world.level.start = { position, yaw: controls.yaw };
      begin();
    },
    walk() {
      screen.hide();
      walk(false);
    },
  });

  const parts = {
    ...{ renderer, scene, camera, avatar, controls, boom, helper, overlays, settings },
    ...{ levels, race, pause, walk, apply, spawn: world.spawn, preferences: choices.preferences },
    /** Resolved once one can walk, or the page has said why not. */
    ready,
    run: () => loop.run(),
    step: (frames: number, delta?: number) => loop.step(frames, delta),
  };
  return handleOf(parts, player, world);
}

declare global {
  interface Window {
    /** For the console and for tests. */
    demo: ReturnType<typeof start>;
  }
}

keepForOffline();
showFocus();
const screen = new StartScreen(() => window.demo.walk());
openRendering(
  canvas,
  parameters,
  (rendering) => (window.demo = start(screen, rendering)),
  (error) => screen.fail(error, 'This page needs WebGL 2: is hardware acceleration switched off?'),
);
