import type { QualityMode } from './Quality.js';

/** What the page's address asks for: `?view=third&response=axis&helper=1`. */
export interface Parameters {
  /** Address of the level. */
  level: string;
  /** Where the walk begins. */
  place: 'start' | 'hall';
  /** three's renderer; 'fallback' is the second on WebGL 2. */
  renderer: 'webgl' | 'webgpu' | 'fallback';
  /** Null: what the user likes. */
  view: 'first' | 'third' | null;
  /** Texels per face edge. */
  resolution: number;
  output: 'axis' | 'surface';
  /** What becomes of contacts: 'axis' is the paper's way, and all there is for the output of that name. */
  response: 'slide' | 'axis';
  /** Shows what the collider sees. */
  helper: boolean;
  /** False hides everything but the picture. */
  ui: boolean;
  pixelRatio: number;
  /** Draws less where the GPU is slow; not if the address says how many pixels. */
  adaptive: boolean;
  /** Null: what the user likes. 'low' is without shadows, and coarse. */
  quality: QualityMode | null;
}

export const DEFAULT_LEVEL = `${import.meta.env.BASE_URL}level.glb`;

const QUALITIES = ['auto', 'high', 'low'] as const;
const VIEWS = ['first', 'third'] as const;
const RENDERERS = ['webgl', 'webgpu', 'fallback'] as const;

export const RESOLUTIONS = [8, 16, 32, 64];

/** Takes what it understands and leaves the rest at what it is without. */
export function readParameters(search: string): Parameters {
  const query = new URLSearchParams(search);
  const resolution = Number(query.get('resolution'));
  const output = query.get('output') === 'axis' ? 'axis' : 'surface';
  return {
    level: query.get('level') ?? DEFAULT_LEVEL,
    place: query.get('place') === 'hall' ? 'hall' : 'start',
    renderer: RENDERERS.find((name) => name === query.get('renderer')) ?? 'webgl',
    view: VIEWS.find((name) => name === query.get('view')) ?? null,
    resolution: RESOLUTIONS.includes(resolution) ? resolution : 32,
    output,
    response: output === 'axis' || query.get('response') === 'axis' ? 'axis' : 'slide',
    helper: query.get('helper') === '1',
    ui: query.get('ui') !== '0',
    quality: QUALITIES.find((name) => name === query.get('quality')) ?? null,
    adaptive: !query.has('dpr') && query.get('ui') !== '0',
    pixelRatio: Number(query.get('dpr')) || Math.min(window.devicePixelRatio, 2),
  };
}
