import { fileURLToPath } from 'node:url';
import { defineConfig, type Alias } from 'vite';
import { alias } from '../vite.config.js';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const port = process.env.E2E_PORT ? Number(process.env.E2E_PORT) : undefined;

const { THREE_VERSION, THREE_FOLDER } = process.env;

/** The part of drei that needs no three. */
const DREI = '@react-three/drei/web';

/**
 * `THREE_VERSION=oldest`: `three` and `three/…` mean the oldest three that package.json allows; `THREE_FOLDER`: the three
 * that lies there (scripts/three.mjs).
 */
const otherThree: Alias[] = THREE_FOLDER
  ? [
      { find: /^three$/, replacement: `${THREE_FOLDER}/build/three.module.js` },
      { find: /^three\/(webgpu|tsl)$/, replacement: `${THREE_FOLDER}/build/three.$1.js` },
      { find: /^three\/addons\//, replacement: `${THREE_FOLDER}/examples/jsm/` },
    ]
  : THREE_VERSION === 'oldest'
    ? [{ find: /^three(?=$|\/)/, replacement: 'three-oldest' }]
    : [];

/** The server of the browser tests: the whole repository, as it is on disk, nothing bundled. */
export default defineConfig({
  root: here('..'),
  publicDir: here('../public'),
  appType: 'mpa', // a missing page is an error, not the index page
  resolve: {
    alias: [
      ...Object.entries(alias).map(([find, replacement]) => ({ find, replacement })),
      ...otherThree,
      // One file, without the maps of sources that it does not bring.
      { find: /^iwer$/, replacement: 'iwer/build/iwer.module.js' },
    ],
  },
  // Pre-bundling could find one more dependency in mid-test and reload the page: it is done for those named alone, for
  // React is CommonJS. three and its addons are ES modules; served as they are, there is one copy, whoever imports it.
  cacheDir: here('../.cache/vite'),
  optimizeDeps: {
    noDiscovery: true,
    include: ['react', 'react-dom/client', '@react-three/fiber', `${DREI}/KeyboardControls`],
    exclude: ['three'],
  },
  server: { port, strictPort: true, hmr: false, watch: null },
});
