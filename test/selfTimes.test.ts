import { expect, test } from 'vitest';
import { selfTimes } from '../bench/suites/selfTimes.mjs';

const frame = (functionName: string, url = '') => ({ functionName, url });

/** As the browser tells it: a step that decodes, sorts and reads, beside three, garbage and the bench. */
const profile = {
  nodes: [
    { id: 1, callFrame: frame('(root)'), children: [2, 8, 9] },
    { id: 2, callFrame: frame('walk', 'http://x/bench/suites/profile.ts'), children: [3, 6] },
    { id: 3, callFrame: frame('step', 'http://x/src/field/Surfels.ts?t=1'), children: [4, 5] },
    { id: 4, callFrame: frame('sort') },
    { id: 5, callFrame: frame('readPixels') },
    { id: 6, callFrame: frame('render', 'http://x/node_modules/three/build/three.module.js'), children: [7] },
    { id: 7, callFrame: frame('step', 'http://x/src/field/Surfels.ts') },
    { id: 8, callFrame: frame('(garbage collector)') },
    { id: 9, callFrame: frame('(idle)') },
  ],
  samples: [2, 3, 4, 5, 6, 7, 8, 9],
  timeDeltas: [1000, 1000, 2000, 4000, 8000, 16000, 32000, 64000],
}; // prettier-ignore

test('time should go to folders of src, three, the GPU and garbage, and what is built in to its caller', () => {
  expect(selfTimes(profile, new Set(['readPixels']))).toEqual([
    { group: 'three-cube-collider, src/field', name: 'step, src/field/Surfels.ts', time: 19 },
    { group: "calls of the GPU's interface", name: 'readPixels', time: 4 },
    { group: 'three', name: 'render, three', time: 8 },
    { group: 'collecting garbage', name: 'collecting garbage', time: 32 },
  ]);
});
