import { Quaternion, Vector3 } from 'three';
import { DEFAULTS } from '../defaults.js';
import type { Capsule } from '../field/Capsule.js';
import { FieldMemory } from '../field/FieldMemory.js';
import type { SlideLimits, SlideResponse } from '../response/SlideResponse.js';
import type { Warnings } from '../Warnings.js';
import { clip, steer } from './airborne.js';
import type { CharacterCollider } from './CharacterCollider.js';
import type { CharacterEvent } from './characterEvents.js';
import type { CharacterState } from './CharacterState.js';
import { ContactList } from './ContactList.js';
import { ClimbWatch } from './ClimbWatch.js';
import { InsideWatch } from './InsideWatch.js';
import type { Motion } from './Motion.js';
import { Platforms } from './Platforms.js';
import { Probe } from './Probe.js';

/** Seconds of one step. */
export const STEP = 1 / 60;
/** Steps in a row without vouching surfaces after which it says so. */
const PATIENCE = 60;
/** A step that moves the body less than this has not moved it, metres. */
const STILL = 1e-7;
/** A fall this much slower than it should be is wedged in a funnel, m/s. */
const WEDGED = 0.05;
/** What has not moved for so long stands, seconds. */
const RIDE_GAP = 2.5 / 60;
/** Least time that a ride is taken to last, seconds: of a frame of none it would be endlessly fast. */
const LEAST_TIME = 1 / 1000;
/** After standing on an edge the ground counts as edged for so long, seconds. */
const EDGED = 0.5;
/** The body overlaps with what squeezes it by more than this, metres. */
const SQUEEZE = 0.001;

const Y = /* @__PURE__ */ new Vector3(0, 1, 0);

/** What has been done for want of a field; counts of steps. */
export interface CharacterStats {
  /** Steps of 1/60 s made, held ones included. */
  steps: number;
  /** Steps in which it stood still because no field vouched for its place. */
  held: number;
  /** Steps whose way was cut at the border of what fields have seen. */
  slowed: number;
  /** Cubemaps asked for. */
  draws: number;
}

/**
 * Moves an upright capsule over surfels in steps of 1/60 s, whatever the frame rate: walking, stepping, falling, sliding,
 * riding.
 *
 * Everything but the state is in the body's frame, whose Y is the character's up.
 */
export class SlideMotion<R, S> implements Motion<R, S> {
  readonly stats: CharacterStats;
  readonly list: ContactList;
  squeezed = false;

  readonly #state: CharacterState;
  readonly #collider: CharacterCollider<R, S>;
  readonly #response: SlideResponse;
  readonly #warnings: Warnings;
  readonly #toBody: Quaternion;
  readonly #toWorld: Quaternion;
  readonly #memory: FieldMemory;
  readonly #platforms: Platforms;
  readonly #probe: Probe<R, S>;
  readonly #climb = new ClimbWatch();
  readonly #watch = new InsideWatch();
  readonly #body: Capsule;
  readonly #limits: SlideLimits = { skin: 0, slope: 0, stepHeight: 0 };
  /** Foot before the last step, body's frame. */
  readonly #before = new Vector3();
  /** m/s, body's frame; y is the speed of falling. */
  readonly #velocity = new Vector3();
  /** Velocity of what it stood on when it left it; walking in the air is relative to that. */
  readonly #base = new Vector3();
  readonly #wish = new Vector3();
  readonly #push = new Vector3();
  #walking = false;
  #wedged = 0;
  #airTime = Infinity;
  #jumpWish = Infinity;
  #remainder = 0;
  /** When the scenery was last found changed: what was drawn until then shows what may not be there any more. */
  #changedAt = -Infinity;
  /** Seconds since what it stands on moved last. */
  #sinceRide = 0;
  /** Seconds since it stood on an edge. */
  #sinceEdge = Infinity;
  /** Told of once the frame is done: who hears of it may put the character elsewhere. */
  readonly #news: CharacterEvent[] = [];
  #unvouched = 0;
  /** Whether the next step would lead where no field can see. */
  #blind = false;
  #waiting = true;
  #clock = 0;
  /** What the last step knew and wanted, if it came to nothing; else NaN. */
  #stillRevision = NaN;
  #stillX = 0;
  #stillZ = 0;

  constructor(
    state: CharacterState,
    collider: CharacterCollider<R, S>,
    response: SlideResponse,
    list: ContactList,
    stats: CharacterStats,
    warnings: Warnings,
  ) {
    this.#warnings = warnings;
    this.#state = state;
    this.#collider = collider;
    this.#response = response;
    this.list = list;
    this.stats = stats;
    this.#toBody = new Quaternion().setFromUnitVectors(state.up, Y);
    this.#toWorld = this.#toBody.clone().invert();
    this.#memory = new FieldMemory(this.#toBody);
    this.#platforms = new Platforms(this.#memory, this.#toBody);
    this.#body = { x: 0, y: 0, z: 0, radius: state.radius, height: state.height };
    this.#probe = new Probe(collider, this.#memory, this.#body);
    this.#place();
  }

  get ready(): boolean {
    this.#take();
    return this.#probe.covers;
  }

  get inside(): boolean {
    return this.#watch.inside;
  }

  get latency(): number {
    return this.#probe.latency;
  }

  get grounded(): boolean {
    return this.#walking || this.#airTime <= this.#state.settings.coyoteTime;
  }

  reset(): void {
    this.#place();
    this.#velocity.set(0, 0, 0);
    this.#base.set(0, 0, 0);
    this.#state.velocity.set(0, 0, 0);
    this.#state.move.set(0, 0, 0);
    this.#memory.forget();
    this.#probe.reset();
    this.#platforms.reset();
    this.list.clear();
    if (this.#watch.inside) this.#news.push({ type: 'inside', inside: false });
    this.#watch.reset();
    this.#walking = false;
    this.#airTime = this.#jumpWish = Infinity;
    this.#remainder = 0;
    this.#wedged = 0;
    this.#stillRevision = NaN;
    this.#climb.reset();
    this.#response.contacts.count = 0;
    this.#response.waited = false;
    this.#response.slack = 0;
    this.#limits.skin = this.#state.settings.skin;
    this.#noteSqueeze();
    this.#waiting = true;
  }

  jump(): boolean {
    this.#jumpWish = 0;
    return this.#mayJump() && this.ready;
  }

  step(delta: number): void {
    this.#take();
    this.#simulate(Math.min(delta, DEFAULTS.character.maxDelta), delta, true);
    this.#report();
  }

  update(renderer: R, scene: S, delta: number): void {
    const dt = Math.min(delta, DEFAULTS.character.maxDelta);
    const sync = this.#collider.readback === 'sync';
    const survey = this.#collider.survey(scene);
    if (survey.moved || survey.changed || survey.deforms) this.#changedAt = this.#clock;
    this.#take();
    if (sync && !this.#probe.covers) {
      this.#draw(renderer, scene, false);
      this.#take();
    }
    this.#simulate(dt, delta, false, sync ? renderer : undefined, scene);
    this.list.findSensors(survey.sensors, this.#state);
    this.#report();
    const hurry = this.#platforms.bends || this.#watch.unsure;
    const pressing = this.#wish.x !== 0 || this.#wish.z !== 0;
    const edged = this.#sinceEdge < EDGED;
    const waiting = this.#waiting;
    const velocity = this.#velocity;
    if (this.#probe.isDue(survey, hurry, velocity, waiting, pressing, edged, dt, this.#clock)) {
      this.#draw(renderer, scene, !waiting);
    }
  }

  #report(): void {
    const { events } = this.#state;
    for (let i = 0; i < this.#news.length; i++) events.dispatchEvent(this.#news[i]!);
    this.#news.length = 0;
    this.list.report(events);
  }

  /** Takes over the collider's newest field, if it is new. */
  #take(): void {
    if (this.#probe.take(this.#clock)) {
      this.#platforms.newField();
      this.#noteInside(this.#watch.take(this.#collider.field!, this.#state.up, this.#body));
    } else if (this.#memory.newest === null) this.#platforms.forget();
    this.#memory.forgetBefore(this.#changedAt);
  }

  /** Inside a solid now, or out of it again: back to where it was free. */
  #noteInside(changed: boolean): void {
    const { inside } = this.#watch;
    if (changed) this.#news.push({ type: 'inside', inside });
    if (!inside || !this.#watch.rescue(this.#body)) return;
    this.#before.set(this.#body.x, this.#body.y, this.#body.z);
    this.#velocity.set(0, 0, 0);
    this.#base.set(0, 0, 0);
    this.#platforms.reset();
    this.#stillRevision = NaN;
  }

  #draw(renderer: R, scene: S, ahead: boolean): void {
    if (this.#probe.draw(renderer, scene, this.#velocity, ahead, this.#clock)) this.stats.draws++;
  }

  /** Carries, then steps, then finds the place to draw the character at. */
  #simulate(dt: number, delta: number, refresh: boolean, renderer?: R, scene?: S): void {
    const { settings } = this.#state;
    const limits = this.#limits;
    const slope = Math.cos(settings.slopeLimit);
    const same =
      limits.skin === settings.skin &&
      limits.slope === slope &&
      limits.stepHeight === settings.stepHeight;
    if (!same) this.#stillRevision = NaN;
    limits.skin = settings.skin;
    limits.slope = slope;
    limits.stepHeight = settings.stepHeight;
    this.#clock += dt;
    if (this.#probe.covers) this.#carry(delta, refresh);
    this.#remainder += dt;
    // A step is begun as soon as its time begins and shown by parts: at the step's own rate nothing is late.
    while (this.#remainder > 1e-6) {
      this.#remainder -= STEP;
      this.#before.set(this.#body.x, this.#body.y, this.#body.z);
      this.#lookAround(renderer, scene);
      this.#fixedStep();
    }
    this.#settle();
  }

  /** Lets what moved since the last frame take its rider along and push. */
  #carry(delta: number, refresh: boolean): void {
    const body = this.#body;
    const ground = this.#walking ? this.list.ground : null;
    this.#sinceRide += delta;
    if (!this.#platforms.carry(body, ground, refresh, this.#clock)) {
      // What moves only every few frames, as physics do, has not stopped in between.
      if (this.#walking && this.#sinceRide > RIDE_GAP) this.#base.set(0, 0, 0);
      return;
    }
    const { ride, push } = this.#platforms;
    const { x, y, z } = body;
    body.x += ride.x + push.x;
    body.y += ride.y + push.y;
    body.z += ride.z + push.z;
    // Nothing takes it where no field has looked: through a wall, or out of the world.
    if (!this.#response.isKnown(this.#memory, body)) {
      body.x = x;
      body.y = y;
      body.z = z;
    }
    if (this.#walking && ride.lengthSq() > 0) {
      this.#base.copy(ride).divideScalar(Math.max(this.#sinceRide, LEAST_TIME));
      this.#sinceRide = 0;
    } else if (this.#walking && this.#sinceRide > RIDE_GAP) {
      this.#base.set(0, 0, 0);
    }
    if (this.#walking) this.#response.walk(this.#memory, body, 0, 0, this.#limits);
    else this.#response.fly(this.#memory, body, 0, 0, 0, this.#limits);
    this.#before.x += body.x - x;
    this.#before.y += body.y - y;
    this.#before.z += body.z - z;
    this.#noteSqueeze();
  }

  #fixedStep(): void {
    this.stats.steps++;
    this.#jumpWish += STEP;
    if (!this.#probe.covers) {
      this.stats.held++;
      if (this.#collider.field !== null && ++this.#unvouched === PATIENCE) {
        this.#warnings.once(
          'the collider has surfaces, but none that vouch for the body, so it never moves: give the collider more ' +
            'reach ("far") or "resolution" for this radius, and no moved parent.',
        );
      }
      this.#waiting = true;
      this.#state.move.set(0, 0, 0);
      return;
    }
    this.#unvouched = 0;
    this.#waiting = this.#blind;
    if (this.#blind) {
      this.stats.held++;
      this.#state.move.set(0, 0, 0);
      return;
    }
    this.#crouch();
    const { settings, walk, move } = this.#state;
    this.#wish.copy(walk).applyQuaternion(this.#toBody).setY(0);
    this.#push.copy(move).applyQuaternion(this.#toBody);
    move.set(0, 0, 0);
    if (this.#jumpWish <= settings.jumpBuffer + STEP && this.#mayJump()) this.#jump();
    if (this.#walking && settings.gravity === 0) this.#leave();
    if (this.#isStill()) return;
    const { x, y, z } = this.#body;
    if (this.#walking) this.#walk();
    else this.#fly();
    if (this.#response.waited) {
      this.#waiting = true;
      this.stats.slowed++;
    }
    this.#noteSqueeze();
    this.list.fill(this.#response, this.#memory, this.#limits, this.#toWorld, this.#walking);
    this.#sinceEdge = this.list.edged ? 0 : this.#sinceEdge + STEP;
    const moved =
      Math.abs(this.#body.x - x) + Math.abs(this.#body.y - y) + Math.abs(this.#body.z - z);
    const still = this.#walking && !this.#response.waited && moved < STILL;
    this.#stillRevision = still ? this.#memory.revision : NaN;
    this.#stillX = this.#wish.x;
    this.#stillZ = this.#wish.z;
  }

  /** Would this step be the last one over again, which did not move the body? */
  #isStill(): boolean {
    return (
      this.#walking &&
      this.#stillRevision === this.#memory.revision &&
      this.#wish.x === this.#stillX &&
      this.#wish.z === this.#stillZ &&
      this.#push.lengthSq() === 0 &&
      this.#body.height === this.#state.height
    );
  }

  /**
   * Before the body's side goes where no field can see, another is wanted, drawn around the body itself: at once, if it
   * can be had. If not, it waits for it.
   */
  #lookAround(renderer?: R, scene?: S): void {
    this.#blind = !this.#probe.seesAhead(this.#velocity, STEP);
    if (!this.#blind || renderer === undefined || scene === undefined) return;
    this.#draw(renderer, scene, false);
    this.#take();
    this.#blind = false;
  }

  #mayJump(): boolean {
    return this.grounded || this.#wedged > 2;
  }

  #jump(): void {
    const { gravity, jumpHeight } = this.#state.settings;
    if (this.#walking) this.#leave();
    this.#airTime = Infinity;
    this.#wedged = 0;
    this.#jumpWish = Infinity;
    this.#velocity.y = Math.max(0, this.#base.y) + Math.sqrt(2 * gravity * jumpHeight);
    this.#news.push({ type: 'jump' });
  }

  /** One step on the ground. */
  #walk(): void {
    const body = this.#body;
    const response = this.#response;
    const { settings } = this.#state;
    const { x, y, z } = body;
    const dx = this.#wish.x * STEP + this.#push.x;
    const dz = this.#wish.z * STEP + this.#push.z;
    response.walk(this.#memory, body, dx, dz, this.#limits);
    const { climbed, waited } = response;
    const slope = body.y - y - climbed;
    if (this.#push.y !== 0) response.fly(this.#memory, body, 0, this.#push.y, 0, this.#limits);
    // A push is no speed: of the way made, what was walked.
    const all = Math.sqrt(dx * dx + dz * dz);
    const walked = STEP * this.#wish.length();
    const share = all > walked ? walked / all / STEP : 1 / STEP;
    this.#velocity.set((body.x - x) * share, slope / STEP, (body.z - z) * share);
    if (this.#push.y > 0) {
      this.#leave();
    } else if (!this.#carried() && climbed === 0 && !waited) {
      const { snapDistance } = settings;
      if (!response.snap(this.#memory, body, snapDistance, this.#limits, dx !== 0 || dz !== 0)) {
        this.#leave();
        this.#velocity.y = Math.min(0, this.#base.y);
      }
    }
    response.waited ||= waited;
    const height = this.#climb.note(y, body.y, response, this.#limits);
    if (height > 0) this.#news.push({ type: 'step', height });
  }

  /** Does anything it touches carry it? */
  #carried(): boolean {
    const { contacts } = this.#response;
    for (let i = 0; i < contacts.count; i++) {
      if (this.#response.carries(contacts, i, this.#limits)) return true;
    }
    return false;
  }

  /** One step in the air. */
  #fly(): void {
    const body = this.#body;
    const velocity = this.#velocity;
    const { gravity, terminalSpeed } = this.#state.settings;
    this.#airTime += STEP;
    this.#steer();
    const { x, y, z } = body;
    const falling = velocity.y;
    velocity.y = Math.max(falling - gravity * STEP, -terminalSpeed);
    const dx = velocity.x * STEP + this.#push.x;
    const dy = 0.5 * (falling + velocity.y) * STEP + this.#push.y;
    const dz = velocity.z * STEP + this.#push.z;
    this.#response.fly(this.#memory, body, dx, dy, dz, this.#limits);
    if (this.#response.waited) {
      // Time waits with it: the fall's speed is neither lost nor gained.
      velocity.y = falling;
      return;
    }
    const landing = -velocity.y;
    const { snapDistance } = this.#state.settings;
    const onward = this.#wish.x !== 0 || this.#wish.z !== 0;
    const onStair =
      onward &&
      velocity.y < 0 &&
      this.#response.isOnStair(this.#memory, body, snapDistance, this.#limits);
    const lands = clip(velocity, this.#response, this.#limits) || onStair;
    const stuck =
      gravity > 0 &&
      velocity.y < 0 &&
      y - body.y < WEDGED * STEP &&
      Math.abs(body.x - x) + Math.abs(body.z - z) < WEDGED * STEP &&
      this.#response.contacts.count > 1;
    this.#wedged = stuck ? this.#wedged + 1 : 0;
    if (stuck) velocity.y = 0;
    if (lands && gravity > 0) {
      this.#walking = true;
      this.#airTime = 0;
      this.#wedged = 0;
      this.#base.set(0, 0, 0);
      velocity.y = 0;
      this.#news.push({ type: 'land', speed: Math.max(0, landing) });
    }
  }

  #steer(): void {
    const velocity = this.#velocity;
    const { airControl, gravity, skin } = this.#state.settings;
    if (gravity === 0) {
      velocity.set(this.#wish.x, 0, this.#wish.z);
      return;
    }
    const x = this.#wish.x + this.#base.x;
    const z = this.#wish.z + this.#base.z;
    steer(velocity, x, z, this.#response.contacts, skin, airControl * STEP);
  }

  #leave(): void {
    this.#walking = false;
    this.#airTime = 0;
    this.#velocity.x += this.#base.x;
    this.#velocity.z += this.#base.z;
    this.#news.push({ type: 'leave' });
  }

  /** Changes the height as asked for, standing up only where there is room. */
  #crouch(): void {
    const { crouch, fullHeight, crouchHeight } = this.#state;
    const body = this.#body;
    const wanted = crouch ? crouchHeight : fullHeight;
    if (body.height === wanted) return;
    const old = body.height;
    body.height = wanted;
    if (wanted > old && !this.#response.fits(this.#memory, body, this.#limits)) body.height = old;
    this.#state.height = body.height;
  }

  #noteSqueeze(): void {
    const squeezed = this.#response.slack > this.#limits.skin + SQUEEZE;
    if (squeezed === this.squeezed) return;
    this.squeezed = squeezed;
    this.#news.push({ type: 'squeeze', squeezed });
  }

  /** The body from the state's foot. */
  #place(): void {
    const at = target.copy(this.#state.foot).applyQuaternion(this.#toBody);
    this.#body.x = at.x;
    this.#body.y = at.y;
    this.#body.z = at.z;
    this.#before.copy(at);
  }

  /** The state from the body. */
  #settle(): void {
    const { foot, position, velocity } = this.#state;
    foot.set(this.#body.x, this.#body.y, this.#body.z);
    const part = Math.min(1, 1 + this.#remainder / STEP);
    position.copy(this.#before).lerp(foot, part).applyQuaternion(this.#toWorld);
    foot.applyQuaternion(this.#toWorld);
    velocity.copy(this.#velocity).applyQuaternion(this.#toWorld);
    if (this.#walking) velocity.add(target.copy(this.#base).applyQuaternion(this.#toWorld));
  }
}

const target = /* @__PURE__ */ new Vector3();
