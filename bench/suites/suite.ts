/**
 * What the suites of a page share: `bench/suites/<name>.ts` exports one by default. It runs in a web page, be it the
 * one that `npm run bench` opens or the demo's `/bench`, makes its own renderers and disposes of them, and rotates the
 * order of contestants within its repeats.
 */
export type Suite = (options: SuiteOptions, tell: (line: string) => void) => Promise<SuiteRow[]>;

export interface SuiteOptions {
  /** Fewer and smaller cases, to see that all runs. */
  quick: boolean;
  /** How often each figure is taken, after a warm-up. */
  repeats: number;
  /** Real levels, as glTF. */
  levels: { name: string; url: string }[];
}

/** One figure of one contestant in one case. */
export interface SuiteRow {
  /** '100k triangles', 'level.glb' */
  case: string;
  /** 'three-cube-collider, WebGL2', 'Octree', 'three-mesh-bvh' */
  contestant: string;
  /** With its unit: 'blocking, ms', 'heap, bytes a triangle'. */
  figure: string;
  /** Raw repeats; none where it cannot take part. */
  samples: number[];
  /** 'cannot', 'extrapolated from 100k' */
  note?: string;
}
