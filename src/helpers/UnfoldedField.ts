import type { CubeCollider } from '../collider/CubeCollider.js';
import { drawLabels } from './drawLabels.js';
import { layOut, UNFOLDED, UNFOLDED_COLUMNS, UNFOLDED_ROWS } from './unfold.js';
import { viridis } from './viridis.js';

/** What it reads of a collider. */
export type UnfoldableCollider = Pick<
  CubeCollider,
  'field' | 'maxima' | 'output' | 'resolution' | 'rMin' | 'rMax'
>;

/** Options of an `UnfoldedField`. */
export interface UnfoldedFieldOptions {
  /** Width of the picture, CSS pixels; its height follows. @default 220 */
  size?: number;
}

/** Shades of the strip from near to far. */
const STRIP = 64;
const PANEL = 'rgba(11, 15, 21, 0.86)';

/**
 * What `CubeColliderHelper` shows, with any renderer: the newest field, unfolded into a cross, bright where something is
 * near. It is drawn by the processor into a canvas of yours, once a field; so it shows what has come back, not what was
 * drawn last.
 *
 * ```js
 * const unfolded = new UnfoldedField( collider, canvas );
 *
 * unfolded.update(); // each frame
 * ```
 *
 * In the paper's mode, of which no more comes back, it shows six rings: each face's maximum, where it was found.
 */
export class UnfoldedField {
  /** Whether `update` draws. @default true */
  visible = true;
  /** Width of the picture, CSS pixels. */
  size: number;

  readonly #canvas: HTMLCanvasElement;
  /** The six faces, a pixel a texel. */
  readonly #faces = document.createElement('canvas');
  readonly #labels = document.createElement('canvas');
  #image: ImageData | null = null;
  #labelKey = '';
  /** What is shown. */
  #shown: unknown = null;
  #serial = -1;
  #time = NaN;

  /** @param collider what to show; may be exchanged at any time */
  constructor(
    public collider: UnfoldableCollider,
    canvas: HTMLCanvasElement,
    { size = 220 }: UnfoldedFieldOptions = {},
  ) {
    this.#canvas = canvas;
    this.size = size;
  }

  /** Draws if there is anything new; call it once a frame. */
  update(): void {
    const { field, maxima, output } = this.collider;
    const newest = output === 'axis' ? maxima : field;
    if (!this.visible || newest === null) return;
    if (field !== null) {
      if (newest === this.#shown && field.serial === this.#serial && field.time === this.#time)
        return;
      this.#serial = field.serial;
      this.#time = field.time;
    }
    this.#shown = newest;
    const context = this.#prepare();
    if (context === null) return;
    this.#clearFaces();
    if (field !== null) this.#paintField(field);
    const layout = layOut(this.size);
    const { padding, cell, height } = layout;
    context.imageSmoothingEnabled = false;
    const top = height - padding - UNFOLDED_ROWS * cell;
    context.drawImage(this.#faces, padding, top, UNFOLDED_COLUMNS * cell, UNFOLDED_ROWS * cell);
    if (maxima !== null && output === 'axis') this.#paintMaxima(context, layout);
    context.drawImage(this.#labels, 0, 0, layout.width, layout.height);
  }

  /** The panel, with labels and sizes as they are to be. */
  #prepare(): CanvasRenderingContext2D | null {
    const { output, resolution, rMin, rMax, field } = this.collider;
    const layout = layOut(this.size);
    const ratio = window.devicePixelRatio;
    const ends = (output === 'axis' ? [rMin, rMax] : [0, field!.far]).map(
      (end) => Math.round(100 * end) / 100,
    );
    const key = [output, resolution, ...ends, this.size, ratio].join(' ');
    if (key !== this.#labelKey) {
      this.#labelKey = key;
      drawLabels(this.#labels, layout, ratio, {
        title: output === 'axis' ? 'Six maxima' : 'Cubemap',
        detail: `6 × ${resolution}² texels`,
        near: `near ${ends[0]}`,
        far: `far ${ends[1]} m`,
      });
      this.#canvas.width = Math.round(layout.width * ratio);
      this.#canvas.height = Math.round(layout.height * ratio);
      this.#faces.width = UNFOLDED_COLUMNS * resolution;
      this.#faces.height = UNFOLDED_ROWS * resolution;
      this.#image = null;
    }
    const context = this.#canvas.getContext('2d');
    if (context === null) return null;
    const { width, height, ramp } = layout;
    context.setTransform(this.#canvas.width / width, 0, 0, this.#canvas.height / height, 0, 0);
    context.clearRect(0, 0, width, height);
    context.fillStyle = PANEL;
    context.beginPath();
    context.roundRect(0, 0, width, height, 8);
    context.fill();
    for (let i = 0; i < STRIP; i++) {
      context.fillStyle = shade(1 - (i + 0.5) / STRIP);
      const step = ramp[2] / STRIP;
      context.fillRect(ramp[0] + i * step, height - ramp[1] - ramp[3], step + 0.5, ramp[3]);
    }
    return context;
  }

  #clearFaces(): void {
    const context = this.#faces.getContext('2d')!;
    const { width, height } = this.#faces;
    context.clearRect(0, 0, width, height);
    context.fillStyle = '#05070a';
    const edge = this.collider.resolution;
    for (const [column, row] of UNFOLDED) {
      context.fillRect(column * edge, height - (row + 1) * edge, edge, edge);
    }
    this.#image ??= context.getImageData(0, 0, width, height);
  }

  #paintField({
    count,
    resolution,
    distance,
    far,
  }: NonNullable<UnfoldableCollider['field']>): void {
    const { data, width, height } = this.#image!;
    for (let texel = 0; texel < count; texel++) {
      const [column, row] = UNFOLDED[Math.floor(texel / resolution ** 2)]!;
      const x = column * resolution + (texel % resolution);
      // Rows of texels count upward.
      const y = height - 1 - row * resolution - (Math.floor(texel / resolution) % resolution);
      const near = 1 - distance[texel]! / far;
      const to = 4 * (y * width + x);
      const seen = near >= 0;
      data[to] = seen ? 255 * viridis(near, 0) : 5;
      data[to + 1] = seen ? 255 * viridis(near, 1) : 7;
      data[to + 2] = seen ? 255 * viridis(near, 2) : 10;
      data[to + 3] = 255;
    }
    this.#faces.getContext('2d')!.putImageData(this.#image!, 0, 0);
  }

  #paintMaxima(
    context: CanvasRenderingContext2D,
    { padding, cell, height }: ReturnType<typeof layOut>,
  ): void {
    const { maxima, resolution } = this.collider;
    UNFOLDED.forEach(([column, row], face) => {
      if (maxima!.red[face]! <= 0) return;
      const x = padding + cell * (column + (maxima!.texel[2 * face]! + 0.5) / resolution);
      const y = padding + cell * (row + (maxima!.texel[2 * face + 1]! + 0.5) / resolution);
      context.beginPath();
      context.arc(x, height - y, 0.085 * cell, 0, 2 * Math.PI);
      context.lineWidth = 2.5;
      context.strokeStyle = '#ffffff';
      context.stroke();
      context.fillStyle = shade(maxima!.red[face]!);
      context.fill();
    });
  }
}

function shade(t: number): string {
  const [r, g, b] = ([0, 1, 2] as const).map((channel) => Math.round(255 * viridis(t, channel)));
  return `rgb(${r}, ${g}, ${b})`;
}
