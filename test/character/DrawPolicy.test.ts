import { Vector3 } from 'three';
import { beforeEach, describe, expect, it } from 'vitest';
import { DrawPolicy } from '../../src/character/DrawPolicy.js';

const STILL = { moved: false, changed: false, deforms: false, sensors: [] };
const ROOM = 1;
const DT = 1 / 60;

describe('DrawPolicy', () => {
  let policy: DrawPolicy;
  const middle = new Vector3();
  const velocity = new Vector3();
  const center = new Vector3();

  /** Walks on at `velocity` until a draw is due. @returns metres made by then */
  function walkToDue(latency = 0): number {
    const from = middle.clone();
    for (let frame = 0; frame < 600; frame++) {
      middle.addScaledVector(velocity, DT);
      const due = policy.due(STILL, false, middle, velocity, ROOM, false, true, true, false, latency, DT);
      if (due) return middle.distanceTo(from);
    }
    return Infinity;
  } // prettier-ignore

  /** Draws where it says. */
  function draw(latency = 0): void {
    policy.predict(middle, velocity, ROOM, latency, center);
    policy.drawn(center, middle);
  }

  beforeEach(() => {
    policy = new DrawPolicy();
    middle.set(0, 0, 0);
    velocity.set(3, 0, 0);
  });

  it('should ask for the first at once, ahead of the body', () => {
    expect(walkToDue()).toBeLessThan(0.06);
    draw();
    expect(center.x - middle.x).toBeCloseTo(0.275, 3);
  });

  it('should ask again after 0.55 m, and on edges after 0.33 m', () => {
    draw();
    expect(walkToDue()).toBeGreaterThan(0.549);
    draw();
    expect(walkToDue()).toBeLessThan(0.61);
    policy.edged = true;
    draw();
    const made = walkToDue();
    expect(made).toBeGreaterThan(0.329);
    expect(made).toBeLessThan(0.39);
  });

  it('should ask sooner where fields come too late to be drawn ahead', () => {
    velocity.set(5, 0, 0);
    draw(0.03);
    expect(walkToDue(0.03)).toBeGreaterThan(0.549);
    draw(0.15);
    expect(walkToDue(0.15)).toBeLessThan(0.42);
  });

  it('should ask at once where the body has turned away from what was drawn', () => {
    draw();
    velocity.set(-3, 0, 0);
    const made = walkToDue();
    expect(made).toBeGreaterThan(0.169);
    expect(made).toBeLessThan(0.23);
  });
});
