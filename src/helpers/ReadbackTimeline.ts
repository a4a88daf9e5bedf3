import type { CharacterController } from '../character/CharacterController.js';
import {
  DRAWN,
  FORCED,
  HELD,
  ReadbackHistory,
  SLOWED,
  type TimedCollider,
} from './ReadbackHistory.js';

/** Options of a `ReadbackTimeline`. */
export interface ReadbackTimelineOptions {
  /** Who walks by it; with it, steps that were held or cut short are shown too. */
  character?: Pick<CharacterController, 'stats'>;
  /** How much time the strip shows, seconds, up to 10 at 60 Hz. @default 5 */
  seconds?: number;
}

const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';
const PANEL = 'rgba(13, 18, 24, 0.78)';
const INK = 'rgba(238, 242, 245, 0.92)';
const SOFT = '#a9b4bf';
const LINE = 'rgba(255, 255, 255, 0.14)';
const DRAW = '#f0e442';
const READ = '#56b4e9';
const WAIT = '#ff7a2f';
const HOLD = '#cc79a7';
/** Heights of the rows, and of all with the space around, as parts of one. */
const ROWS = [
  { name: 'cubemap drawn', color: DRAW, top: 0.2, height: 1 },
  { name: 'on its way back', color: READ, top: 1.3, height: 1 },
  { name: 'age of the field', color: INK, top: 2.4, height: 2 },
  { name: 'held, slowed', color: HOLD, top: 4.5, height: 1 },
] as const;
const HEIGHT = 5.7;
/** Ages shown, milliseconds, on a logarithmic scale; of older ones the curve stays at its top. */
const [YOUNGEST, OLDEST] = [4, 1000];
const AGES = [
  { age: 10, name: '10 ms' },
  { age: 100, name: '100 ms' },
] as const;
/** Width of the names, as a part of a row's height, and at most of the strip's. */
const NAMES = [6, 0.3] as const;

/**
 * A strip of the last seconds, scrolling: when cubemaps were drawn (ticks), from when to when each was on its way back
 * (bars; orange where the page stood and waited for it), how old the newest field was (curve, up to a second on
 * a logarithmic scale), and in which frames a character was held or slowed for want of one.
 *
 * It is drawn into a canvas of yours, as large as its style makes it, and asks nothing but public counters:
 *
 * ```js
 * const timeline = new ReadbackTimeline( collider, canvas, { character } );
 *
 * timeline.update(); // each frame, after character.update( … )
 * ```
 */
export class ReadbackTimeline {
  /** Whether `update` draws; it goes on looking all the same. @default true */
  visible = true;
  /** Who walks by it; null for nobody. */
  character: Pick<CharacterController, 'stats'> | null;
  /** How much time the strip shows, seconds. */
  seconds: number;

  readonly #canvas: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D | null;
  readonly #history = new ReadbackHistory();
  #left = 0;
  #width = 0;
  #now = 0;

  /** @param collider whose cubemaps to follow; may be exchanged at any time */
  constructor(
    public collider: TimedCollider,
    canvas: HTMLCanvasElement,
    { character, seconds = 5 }: ReadbackTimelineOptions = {},
  ) {
    this.#canvas = canvas;
    this.#context = canvas.getContext('2d');
    this.character = character ?? null;
    this.seconds = seconds;
  }

  /** Looks at the counters and draws the strip; call it once a frame. */
  update(): void {
    this.#now = performance.now();
    this.#history.look(this.#now, this.collider, this.character?.stats ?? null);
    if (this.visible && this.#context !== null) this.#draw(this.#context);
  }

  #draw(context: CanvasRenderingContext2D): void {
    const canvas = this.#canvas;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0 || height === 0) return;
    const ratio = window.devicePixelRatio;
    // A canvas that is given a size loses all it had.
    if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
    if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    context.setTransform(canvas.width / width, 0, 0, canvas.height / height, 0, 0);
    context.clearRect(0, 0, width, height);
    context.fillStyle = PANEL;
    context.fillRect(0, 0, width, height);
    const row = height / HEIGHT;
    this.#left = Math.min(NAMES[0] * row, NAMES[1] * width);
    this.#width = width - this.#left - 6;
    this.#names(context, row);
    context.save();
    context.beginPath();
    context.rect(this.#left, 0, this.#width, height);
    context.clip();
    this.#reads(context, row);
    this.#looks(context, row);
    this.#ages(context, row);
    context.restore();
  }

  #x(time: number): number {
    return this.#left + this.#width * (1 - (this.#now - time) / (1000 * this.seconds));
  }

  #names(context: CanvasRenderingContext2D, row: number): void {
    context.font = fontOf(0, Math.min(12, 0.62 * row));
    context.textBaseline = 'middle';
    context.textAlign = 'left';
    for (const { name, color, top, height } of ROWS) {
      context.fillStyle = color;
      context.fillText(name, 8, (top + 0.5 * height) * row, this.#left - 12);
    }
    context.fillStyle = LINE;
    for (let second = 0; second <= this.seconds; second++) {
      context.fillRect(Math.round(this.#x(this.#now - 1000 * second)), 4, 1, (HEIGHT - 0.4) * row);
    }
    for (const { age, name } of AGES) {
      const y = Math.round(yOf(age, row));
      context.fillStyle = LINE;
      context.fillRect(this.#left, y, this.#width, 1);
      context.fillStyle = SOFT;
      context.font = fontOf(1, Math.min(10, 0.55 * row));
      context.fillText(name, this.#left + 4, y - 0.3 * row);
    }
  }

  #reads(context: CanvasRenderingContext2D, row: number): void {
    const { from, to, forced, reads, size } = this.#history;
    for (let i = reads - 1; i >= Math.max(0, reads - size); i--) {
      const place = i % size;
      if (this.#x(to[place]!) < this.#left) break;
      const x = this.#x(from[place]!);
      context.fillStyle = forced[place] === 1 ? WAIT : READ;
      // One above the other, in turn: two may be on their way at a time.
      const y = (ROWS[1].top + 0.1 + (i % 2) * 0.42) * row;
      context.fillRect(x, y, Math.max(2, this.#x(to[place]!) - x), 0.36 * row);
    }
  }

  #looks(context: CanvasRenderingContext2D, row: number): void {
    const { time, flags, looks, size } = this.#history;
    for (let i = looks - 1; i >= Math.max(0, looks - size); i--) {
      const place = i % size;
      const x = this.#x(time[place]!);
      if (x < this.#left) break;
      const happened = flags[place]!;
      if ((happened & DRAWN) !== 0) {
        context.fillStyle = (happened & FORCED) !== 0 ? WAIT : DRAW;
        context.fillRect(x - 1, (ROWS[0].top + 0.15) * row, 2, 0.7 * row);
      }
      if ((happened & (HELD | SLOWED)) === 0) continue;
      context.fillStyle = HOLD;
      const high = (happened & HELD) !== 0 ? 0.8 : 0.4;
      context.fillRect(x - 1.5, (ROWS[3].top + 0.9 - high) * row, 3, high * row);
    }
  }

  #ages(context: CanvasRenderingContext2D, row: number): void {
    const { time, age, looks, size } = this.#history;
    context.strokeStyle = INK;
    context.lineWidth = 1.25;
    context.beginPath();
    let drawing = false;
    for (let i = looks - 1; i >= Math.max(0, looks - size); i--) {
      const place = i % size;
      const x = this.#x(time[place]!);
      if (Number.isNaN(age[place]!)) {
        drawing = false;
      } else {
        const y = yOf(age[place]!, row);
        if (drawing) context.lineTo(x, y);
        else context.moveTo(x, y);
        drawing = true;
      }
      if (x < this.#left) break;
    }
    context.stroke();
  }
}

/** Where an age stands in its row. */
function yOf(age: number, row: number): number {
  const shown = Math.min(OLDEST, Math.max(YOUNGEST, age));
  const part = Math.log(shown / YOUNGEST) / Math.log(OLDEST / YOUNGEST);
  const { top, height } = ROWS[2];
  return (top + height * (0.95 - 0.9 * part)) * row;
}

const sizes = [0, 0];
const fonts = ['', ''];

/** The same string for the same size. @param use of two sizes, so that neither makes the other anew */
function fontOf(use: 0 | 1, size: number): string {
  if (size !== sizes[use]) {
    sizes[use] = size;
    fonts[use] = `${size}px ${FONT}`;
  }
  return fonts[use]!;
}
