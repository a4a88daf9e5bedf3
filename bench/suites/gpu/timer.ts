import { later } from '../pace.js';

/** What `EXT_disjoint_timer_query_webgl2` defines. */
interface TimerQueries {
  TIME_ELAPSED_EXT: number;
  GPU_DISJOINT_EXT: number;
}

/** Longest that an answer is waited for, tasks. */
const PATIENCE = 1000;

/** Asks the GPU itself how long it was at something; null where it does not say. */
export function createTimer(gl: WebGL2RenderingContext) {
  const queries = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerQueries | null;
  if (queries === null) return null;
  /** @returns milliseconds; null where other work came between */
  return async (work: () => void): Promise<number | null> => {
    const query = gl.createQuery();
    gl.beginQuery(queries.TIME_ELAPSED_EXT, query);
    work();
    gl.endQuery(queries.TIME_ELAPSED_EXT);
    for (let i = 0; i < PATIENCE; i++) {
      await later(1);
      if (gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) break;
    }
    const known = gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) as boolean;
    const disjoint = gl.getParameter(queries.GPU_DISJOINT_EXT) as boolean;
    const nanoseconds = known ? (gl.getQueryParameter(query, gl.QUERY_RESULT) as number) : NaN;
    gl.deleteQuery(query);
    return known && !disjoint ? nanoseconds / 1e6 : null;
  };
}
