import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { AnimationMixer } from 'three';
import { DEFAULTS } from 'three-cube-collider';
import { describe, expect, it } from 'vitest';
import { loadFigure, slide, verticesOf } from './figure.js';

const figure = await loadFigure();
const mixer = new AnimationMixer(figure.root);

/** Shows a clip alone. */
function poser(name: string): (time: number) => void {
  mixer.stopAllAction();
  const action = mixer.clipAction(figure.clip(name)).play();
  return (time) => {
    action.time = time;
    mixer.update(0);
  };
}

describe('the avatar', () => {
  it('should be what npm run build:avatar makes, byte for byte', async () => {
    const folder = await mkdtemp(join(tmpdir(), 'avatar-'));
    try {
      const file = join(folder, 'avatar.glb');
      await promisify(execFile)(process.execPath, ['scripts/avatar/build.mjs', file]);
      const [made, kept] = await Promise.all([readFile(file), readFile('public/avatar.glb')]);
      expect(made.equals(kept)).toBe(true);
      expect(kept.length).toBeLessThan(150e3);
    } finally {
      await rm(folder, { recursive: true });
    }
  });

  it('should be drawn with few triangles', () => {
    expect(figure.triangles).toBeGreaterThan(500);
    expect(figure.triangles).toBeLessThan(4000);
  });

  it.each(figure.clips.map(({ name }) => name))('should fit its body in the clip %s', (name) => {
    const { height, crouchHeight } = DEFAULTS.character;
    const most = name === 'crouch' || name === 'sneak' ? crouchHeight : height;
    const pose = poser(name);
    const { duration } = figure.clip(name);
    for (let i = 0; i <= 8; i++) {
      pose((duration * i) / 8);
      const heights = verticesOf(figure.root).filter((_, k) => k % 3 === 1);
      expect(Math.max(...heights)).toBeLessThan(most);
      expect(Math.min(...heights)).toBeGreaterThan(-0.005);
    }
  });

  it.each(['idle', 'walk', 'run', 'fall', 'crouch', 'sneak'])(
    'should end the clip %s as it begins',
    (name) => {
      const pose = poser(name);
      pose(0);
      const first = verticesOf(figure.root);
      pose(figure.clip(name).duration);
      const last = verticesOf(figure.root);
      const apart = first.map((value, i) => Math.abs(value - last[i]!));
      expect(Math.max(...apart)).toBeLessThan(1e-3);
    },
  );

  it.each([
    ['walk', DEFAULTS.controls.walkSpeed, 0.75],
    ['run', DEFAULTS.controls.runSpeed, 0.35],
  ])('should not slide on the ground in the clip %s', (name, speed, least) => {
    const { worst, touching } = slide(figure.root, poser(name), speed, figure.clip(name).duration);
    expect(worst).toBeLessThan(0.05);
    expect(touching).toBeGreaterThan(least);
  });
});
