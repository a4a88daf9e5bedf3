import { describe, expect, it } from 'vitest';
import { SurfaceField } from 'three-cube-collider';
import { emptyStats } from '../../src/collider/CubeColliderStats.js';
import {
  DRAWN,
  FORCED,
  HELD,
  ReadbackHistory,
  SLOWED,
  type TimedCollider,
} from '../../src/helpers/ReadbackHistory.js';

function scene() {
  const field = new SurfaceField(4, 1);
  const collider = { field: null as SurfaceField | null, maxima: null, stats: emptyStats() };
  const character = { steps: 0, held: 0, slowed: 0, draws: 0 };
  const history = new ReadbackHistory();
  return {
    collider,
    character,
    history,
    look: (now: number) => history.look(now, collider as TimedCollider, character),
    come(time: number, latency: number) {
      field.time = time;
      collider.field = field;
      collider.stats.reads++;
      collider.stats.latency = latency;
    },
  };
}

describe('the history of read-backs', () => {
  it('should tell when each was drawn and came, and how old the newest is', () => {
    const { collider, history, look, come } = scene();
    look(0);
    collider.stats.draws++;
    look(16);
    come(10, 12);
    look(32);
    look(48);
    expect([...history.flags.subarray(0, 4)]).toEqual([0, DRAWN, 0, 0]);
    expect([...history.age.subarray(0, 4)]).toEqual([NaN, NaN, 22, 38]);
    expect(history.reads).toBe(1);
    expect([history.from[0], history.to[0], history.forced[0]]).toEqual([10, 22, 0]);
  });

  it('should tell reads that were waited for, and frames without a field', () => {
    const { collider, character, history, look, come } = scene();
    look(0);
    Object.assign(collider.stats, { draws: 1, forced: 1 });
    come(20, 5);
    character.held++;
    look(30);
    character.slowed++;
    look(46);
    expect([...history.flags.subarray(0, 3)]).toEqual([0, DRAWN | FORCED | HELD, SLOWED]);
    expect(history.forced[0]).toBe(1);
  });

  it('should begin anew with another collider', () => {
    const { character, history, look } = scene();
    look(0);
    const stats = { ...emptyStats(), draws: 70, reads: 60, forced: 50 };
    const other = { field: new SurfaceField(4, 1), maxima: null, stats };
    history.look(16, other as unknown as TimedCollider, character);
    expect(history.flags[1]).toBe(0);
    expect(history.reads).toBe(0);
    // Nobody knows yet when its field was drawn.
    expect(history.age[1]).toBeNaN();
  });

  it('should go on for ever in the room it has', () => {
    const { collider, history, look, come } = scene();
    for (let i = 0; i < 3 * history.size; i++) {
      come(i, 1);
      collider.stats.draws++;
      look(i + 1);
    }
    const last = (history.looks - 1) % history.size;
    expect(history.time[last]).toBe(3 * history.size);
    expect(history.to[(history.reads - 1) % history.size]).toBe(3 * history.size);
    expect(history.time).toHaveLength(history.size);
  });
});
