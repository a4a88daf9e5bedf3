import { FACE_NAMES } from '../cube/faces.js';
import { type Layout, UNFOLDED } from './unfold.js';

/** What the labels say besides the faces' names. */
export interface LabelTexts {
  title: string;
  detail: string;
  near: string;
  far: string;
}

const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';

/** Draws names, frames and legend over the unfolded cube; all else stays transparent. */
export function drawLabels(
  canvas: HTMLCanvasElement,
  layout: Layout,
  pixelRatio: number,
  texts: LabelTexts,
): void {
  canvas.width = Math.round(layout.width * pixelRatio);
  canvas.height = Math.round(layout.height * pixelRatio);
  const context = canvas.getContext('2d');
  if (context === null) return;
  const { width, height, padding, cell, ramp } = layout;
  const small = Math.max(8, 0.19 * cell);
  const right = width - padding;
  context.scale(canvas.width / width, canvas.height / height);
  context.lineWidth = 1;
  context.textBaseline = 'alphabetic';

  FACE_NAMES.forEach((name, face) => {
    const [column, row] = UNFOLDED[face]!;
    const x = padding + column * cell;
    const y = height - padding - (row + 1) * cell;
    context.strokeStyle = 'rgba(255, 255, 255, 0.28)';
    context.strokeRect(
      Math.round(x) + 0.5,
      Math.round(y) + 0.5,
      Math.round(cell),
      Math.round(cell),
    );
    context.font = `600 ${small}px ${FONT}`;
    context.textAlign = 'left';
    // A dark rim: a label lies on whatever colour its face has.
    context.strokeStyle = 'rgba(8, 11, 16, 0.75)';
    context.lineWidth = 2.5;
    context.lineJoin = 'round';
    const label = name.replace('-', '−');
    context.strokeText(label, x + 4, y + small + 2.5);
    context.lineWidth = 1;
    context.fillStyle = 'rgba(255, 255, 255, 0.92)';
    context.fillText(label, x + 4, y + small + 2.5);
  });

  context.textAlign = 'right';
  context.fillStyle = 'rgba(255, 255, 255, 0.92)';
  context.font = `600 ${Math.max(9, 0.21 * cell)}px ${FONT}`;
  context.fillText(texts.title, right, padding + 0.24 * cell);
  context.fillStyle = 'rgba(255, 255, 255, 0.6)';
  context.font = `${small}px ${FONT}`;
  context.fillText(texts.detail, right, padding + 0.52 * cell);

  const under = height - ramp[1] + small + 3;
  context.fillText(texts.far, right, under);
  context.textAlign = 'left';
  context.fillText(texts.near, ramp[0], under);
}
