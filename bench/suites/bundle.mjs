// @ts-check
import { buildPackage, ship, shipFile } from '../bundle/ship.mjs';

/** @typedef {import('./suite.js').SuiteRow} SuiteRow */

const RAPIER = 'node_modules/@dimforge/rapier3d-compat/dist';
const FIGURE = 'shipped, kB';

/** @type {Record<string, string>} what a page imports of a rival to do the same */
const RIVALS = {
  'Octree and Capsule': `export { Octree } from 'three/addons/math/Octree.js';
    export { Capsule } from 'three/addons/math/Capsule.js';`,
  'three-mesh-bvh: MeshBVH, StaticGeometryGenerator': `export { MeshBVH, StaticGeometryGenerator } from 'three-mesh-bvh';`,
  'Rapier, compat (WASM within)': `import rapier from '@dimforge/rapier3d-compat'; export default rapier;`,
};

/** @type {import('./list.mjs').NodeSuite} */
export const bundle = {
  name: 'bundle',
  title: 'What a page ships',
  about: `Built by Vite, minified, then compressed by gzip; three, which all need, apart. Octree and three-mesh-bvh find contacts
and leave the character to the page; ours and Rapier's bring one. Rapier's WebAssembly stands alone in the last line: the
other Rapier package loads it as a file beside a little JavaScript.`,
  needsBrowser: false,
  async run() {
    const root = await buildPackage('lib');
    const webgpu = await buildPackage('lib-webgpu');
    /** @param {'index' | 'webgpu'} entry @param {string} [names] */
    const ours = (entry, names = '*') =>
      ship(
        names === '*'
          ? `export * from './${entry}.js'`
          : `export { ${names} } from './${entry}.js'`,
        entry === 'index' ? root : webgpu,
      );
    const core = 'CubeCollider, CharacterController';
    /** @type {Record<string, { minified: number, gzipped: number }>} */
    const shipped = {
      'three-cube-collider: CubeCollider, CharacterController': await ours('index', core),
      'three-cube-collider: CubeCollider': await ours('index', 'CubeCollider'),
      'three-cube-collider: all of it': await ours('index'),
      'three-cube-collider/webgpu: CubeCollider, CharacterController': await ours('webgpu', core),
      'three-cube-collider/webgpu: all of it': await ours('webgpu'),
    };
    for (const [name, code] of Object.entries(RIVALS)) shipped[name] = await ship(code);
    shipped['Rapier, its WASM alone'] = shipFile(`${RAPIER}/rapier_wasm3d_bg.wasm`);
    /** @type {SuiteRow[]} */
    const rows = [];
    for (const [contestant, bytes] of Object.entries(shipped)) {
      for (const [name, count] of Object.entries(bytes)) {
        rows.push({ case: name, contestant, figure: FIGURE, samples: [count / 1000] });
      }
    }
    return { rows };
  },
};
