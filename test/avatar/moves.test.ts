import { describe, expect, it, vi } from 'vitest';
import { createAvatar } from '../../demo/avatar/createAvatar.js';
import { type ClipName, Moves } from '../../demo/avatar/Moves.js';
import { loadFigure, slide } from './figure.js';

const NAMES: ClipName[] = ['idle', 'walk', 'run', 'jump', 'fall', 'land', 'crouch', 'sneak'];

interface Motion {
  speed?: number;
  grounded?: boolean;
  crouched?: boolean;
  rise?: number;
}

async function makeMoves() {
  const figure = await loadFigure();
  const moves = new Moves(figure.root, figure.clips);
  const go = (
    seconds: number,
    { speed = 0, grounded = true, crouched = false, rise = 0 }: Motion,
  ) => {
    for (let time = 0; time < seconds - 1e-6; time += 1 / 60) {
      moves.update(1 / 60, speed, grounded, crouched, rise);
      const sum = NAMES.reduce((sum, name) => sum + moves.weight(name), 0);
      expect(sum).toBeCloseTo(1, 6);
    }
    moves.pose();
  };
  const most = () => NAMES.reduce((a, b) => (moves.weight(a) >= moves.weight(b) ? a : b));
  return { figure, moves, go, most };
}

describe('Moves', () => {
  it('should stand, walk, run, leap, fall, land and stand again', async () => {
    const { go, most, moves } = await makeMoves();
    const seen: string[] = [];
    const all: [number, Motion][] = [
      [0.5, {}],
      [0.6, { speed: 3 }],
      [0.6, { speed: 6 }],
      [0.6, {}],
      [0.2, { grounded: false, rise: 5 }],
      [0.4, { grounded: false, rise: -6 }],
      [0.12, {}],
      [1, {}],
    ];
    for (const [seconds, motion] of all) {
      go(seconds, motion);
      seen.push(most());
    }
    expect(seen).toEqual(['idle', 'walk', 'run', 'idle', 'jump', 'fall', 'land', 'idle']);
    expect(moves.weight('idle')).toBeCloseTo(1, 6);
  });

  it('should walk off an edge without a leap, and off a kerb without a landing', async () => {
    const { go, most, moves } = await makeMoves();
    go(0.3, { speed: 3 });
    go(0.1, { speed: 3, grounded: false, rise: -1 });
    expect(moves.weight('jump')).toBe(0);
    expect(moves.weight('fall')).toBeGreaterThan(0.3);
    go(0.1, { speed: 3 });
    expect(moves.weight('land')).toBe(0);
    expect(most()).toBe('walk');
  });

  it('should crouch, and sneak when crouched it walks', async () => {
    const { go, most } = await makeMoves();
    go(0.4, { crouched: true });
    expect(most()).toBe('crouch');
    go(0.4, { crouched: true, speed: 3 });
    expect(most()).toBe('sneak');
    go(0.4, {});
    expect(most()).toBe('idle');
  });

  it.each([
    [3, 0.1],
    [6, 0.1],
    [4.5, 0.3],
    [2, 0.2],
  ])('should keep its feet where they are put at %s m/s', async (speed, most) => {
    const { figure, moves, go } = await makeMoves();
    go(1, { speed });
    let last = 0;
    const pose = (time: number) => {
      moves.update(time - last, speed, true, false, 0);
      moves.pose();
      last = time;
    };
    expect(slide(figure.root, pose, speed, 0.6).worst).toBeLessThan(most);
  });

  it('should give a little when it leaps and lands, unless less motion is asked for', async () => {
    for (const enabled of [true, false]) {
      const { figure, moves, go } = await makeMoves();
      moves.squash.enabled = enabled;
      const heights: number[] = [];
      for (const [seconds, motion] of [
        [0.05, { grounded: false, rise: 5 }],
        [0.4, { grounded: false, rise: -6 }],
        [0.05, {}],
        [1, {}],
      ] as [number, Motion][]) {
        go(seconds, motion);
        heights.push(figure.root.scale.y);
      }
      const [leapt, , landed, after] = heights;
      expect(leapt! > 1.01).toBe(enabled);
      expect(landed! < 0.99).toBe(enabled);
      expect(after).toBeCloseTo(1, 2);
    }
  });
});

describe('createAvatar', () => {
  it('should walk unseen and say so once without its file', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const avatar = createAvatar('/no-such-avatar.glb');
    await avatar.ready;
    avatar.animate(1 / 60, 3, true, false, 0);
    expect(avatar.object.children).toHaveLength(0);
    expect(warn).toHaveBeenCalledOnce();
    expect(warn.mock.lastCall![0]).toContain('npm run build:avatar');
    warn.mockRestore();
  });
});
