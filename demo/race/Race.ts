import { type BufferGeometry, type Object3D, type Scene, Vector3 } from 'three';
import type { CharacterController, CharacterControls, CubeCollider } from 'three-cube-collider';
import { endOfChains, watchTasks } from '../../bench/suites/watchTasks.js';
import { notify } from '../page.js';
import type { World } from '../World.js';
import { type ContestantId, OURS, ourBytes, type RivalId, RIVALS } from './contestants.js';
import { FrameTimes } from './FrameTimes.js';
import { missed } from './missed.js';
import { type RaceCharacter, RivalCharacter } from './RivalCharacter.js';
import type { Penetration, Scenery } from './Scenery.js';

/** Seconds between two judgements. */
const INTERVAL = 0.25;
/** So deep in what moves nobody is who knows of it, metres. */
const MISSED = 0.1;
const STILL = new Vector3();

export const CONTESTANTS = ['cube', 'octree', 'bvh', 'rapier'] as const;

/** What is known of a contestant; NaN until it is. */
export interface Result {
  /** Milliseconds that the page stood still for it, until its first step was done. */
  build: number;
  /** That it keeps. */
  bytes: number;
  readonly frames: FrameTimes;
  /** How deep it was in what is drawn when it was last judged, metres; negative is a gap. */
  inside: number;
}

/** Ours; its collider may be exchanged. */
export type OurCharacter = CharacterController & { readonly collider: CubeCollider };

/** The demo, as the race needs it. */
export interface Track {
  readonly scene: Scene;
  readonly controls: CharacterControls;
  readonly avatar: Object3D;
  /** Where one goes who falls below its abyss; and what moves in it. */
  readonly world: Pick<World, 'spawn' | 'abyss' | 'hall' | 'movers'>;
  ours(): OurCharacter;
  /** Moves ours on. */
  step(delta: number): void;
}

/** The same walk on one collider or another, switched while one walks. */
export class Race {
  /** Who walks. */
  current: ContestantId = 'cube';
  readonly results: Readonly<Record<ContestantId, Result>> = {
    cube: noResult(),
    octree: noResult(),
    bvh: noResult(),
    rapier: noResult(),
  };
  /** Whether anybody looks: ours is not judged else. */
  watched = false;
  /** What it is about, or what went wrong. */
  status = '';
  /** What a rival misses where it is, in a sentence. */
  missed = '';
  /** Called when something of this has changed. */
  onChange: () => void = () => undefined;

  readonly #track: Track;
  readonly #rivals = new Map<RivalId, Promise<RivalCharacter>>();
  #geometry: BufferGeometry | null = null;
  #rival: RivalCharacter | null = null;
  #scenery: Promise<Scenery> | null = null;
  #judge: Scenery | null = null;
  #wanted: ContestantId = 'cube';
  /** Who has not taken a step since it was built. */
  readonly #fresh = new Set<ContestantId>();
  #seconds = 0;

  constructor(track: Track) {
    this.#track = track;
  }

  /** Who walks, as the demo sees them. */
  get character(): RaceCharacter {
    return this.#rival ?? this.#track.ours();
  }

  /**
   * How long ours keeps the page from going on while it compiles: by `watchTasks`, as `npm run bench -- load` clocks
   * it. While the GPU's compiler works the page goes on.
   */
  async timed(compile: () => Promise<void>): Promise<void> {
    let blocking = 0;
    const note = (milliseconds: number) => (blocking += milliseconds);
    const unwatch = watchTasks(note, { chains: true });
    try {
      const begin = performance.now();
      const compiled = compile();
      await endOfChains();
      note(performance.now() - begin);
      await compiled;
      // What hangs on the last task is told in its own turn.
      await endOfChains();
    } finally {
      unwatch();
    }
    this.results.cube.build = blocking;
    this.#fresh.add('cube');
  }

  /** Once a frame, between the controls' two calls. */
  update(delta: number): void {
    const begin = performance.now();
    if (this.#rival === null) this.#track.step(delta);
    else this.#stepRival(this.#rival, delta);
    const end = performance.now();
    const result = this.results[this.current];
    result.frames.add(end, end - begin);
    if (this.#fresh.delete(this.current)) result.build += end - begin;
    this.#seconds += delta;
    if (this.#seconds < INTERVAL) return;
    this.#seconds = 0;
    if (this.watched || this.#rival !== null) this.look();
  }

  /** Judges who walks. */
  look(): void {
    const { position, body } = this.character;
    void this.#loadScenery().catch(() => undefined);
    const inside = this.#judge?.penetration(position, body?.height);
    if (inside !== undefined) {
      this.results[this.current].inside = inside.depth;
      this.missed = this.#missed(inside);
    }
    this.results.cube.bytes = ourBytes(this.#track.ours().collider);
    this.onChange();
  }

  /** The next one's turn. */
  next(): Promise<void> {
    const i = CONTESTANTS.indexOf(this.#wanted);
    return this.choose(CONTESTANTS[(i + 1) % CONTESTANTS.length]!);
  }

  /** Lets another one walk on from here; a rival is loaded and built first, meanwhile one walks on as before. */
  async choose(id: ContestantId): Promise<void> {
    this.#wanted = id;
    if (id === 'cube') {
      this.#handOver('cube', null);
      return;
    }
    try {
      const rival = await this.#built(id);
      // Another one may have been asked for meanwhile.
      if (this.#wanted === id) this.#handOver(id, rival);
    } catch (error) {
      console.warn(error);
      if (this.#wanted !== id) return;
      this.#wanted = this.current;
      const { name } = this.current === 'cube' ? OURS : RIVALS[this.current];
      this.#tell(`${RIVALS[id].name} could not be loaded: no network? ${name} goes on.`);
    }
  }

  /** Ours goes on, and nothing built so far is used again: for another level, or another collider. */
  reset(): void {
    this.#wanted = 'cube';
    this.#handOver('cube', null);
    this.#rivals.clear();
    this.#geometry = this.#scenery = this.#judge = null;
    for (const id of CONTESTANTS) if (id !== 'cube') Object.assign(this.results[id], noResult());
  }

  #missed({ depth, mesh }: Penetration): string {
    if (this.current === 'cube' || mesh === null || depth < MISSED) return '';
    const { name, of } = RIVALS[this.current];
    const { hall, movers } = this.#track.world;
    return `${name} ${missed(mesh, hall, movers?.root ?? null)} not in its ${of}.`;
  }

  #handOver(id: ContestantId, rival: RivalCharacter | null): void {
    const { controls } = this.#track;
    const ours = this.#track.ours();
    const last = this.#rival;
    if (rival !== last) {
      const foot = this.character.position;
      if (rival !== null) {
        rival.place(foot);
        // It stands where it was left, and does not walk off when it is back.
        ours.walk(STILL);
        ours.crouch(false);
      } else {
        // A rival may have left it inside of what is drawn.
        ours.teleport(this.#judge?.free(foot) ?? foot);
      }
      this.#rival = rival;
      controls.character = this.character;
    }
    this.current = id;
    this.missed = '';
    document.body.classList.toggle('rival', rival !== null);
    this.#tell('');
  }

  #built(id: RivalId): Promise<RivalCharacter> {
    let rival = this.#rivals.get(id);
    if (rival === undefined) {
      rival = this.#build(id);
      this.#rivals.set(id, rival);
      // One that failed is tried again.
      rival.catch(() => this.#rivals.delete(id));
    }
    return rival;
  }

  /** Of what stands still in the scene. */
  async #build(id: RivalId): Promise<RivalCharacter> {
    const { name, build } = RIVALS[id];
    this.#tell(`Loading ${name}…`);
    const scenery = await this.#loadScenery();
    this.#tell(`Building ${name}…`);
    await painted();
    const { walker, bytes } = await build((this.#geometry ??= scenery.geometry()));
    Object.assign(this.results[id], { build: walker.preparation, bytes });
    this.#fresh.add(id);
    return new RivalCharacter(walker, RIVALS[id], this.#track.avatar);
  }

  #stepRival(rival: RivalCharacter, delta: number): void {
    try {
      rival.update(delta);
    } catch (error) {
      console.warn(error);
      void this.choose('cube');
      return;
    }
    const { abyss, spawn } = this.#track.world;
    if (rival.position.y >= abyss) return;
    rival.place(spawn);
    notify('Back at the start');
  }

  #loadScenery(): Promise<Scenery> {
    const { scene, world, avatar } = this.#track;
    return (this.#scenery ??= import('./Scenery.js').then(
      ({ Scenery }) =>
        (this.#judge = new Scenery(scene, world.hall, world.movers?.root ?? null, avatar)),
      (error: unknown) => {
        // To be tried again.
        this.#scenery = null;
        throw error;
      },
    ));
  }

  #tell(text: string): void {
    this.status = text;
    this.onChange();
  }
}

function noResult(): Result {
  return { build: NaN, bytes: NaN, frames: new FrameTimes(), inside: NaN };
}

/** Once what was told is to be seen. */
function painted(): Promise<void> {
  return new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}
