import { fileURLToPath } from 'node:url';
import { defineConfig, type UserConfig } from 'vite';
import { contentPolicy } from './scripts/demo/contentPolicy.mjs';
import { decoders } from './scripts/demo/decoders.mjs';
import { leaveOut } from './scripts/demo/leaveOut.mjs';
import { offline } from './scripts/demo/offline.mjs';
import { rapierWasm } from './scripts/demo/rapierWasm.mjs';
import { shortShaders } from './scripts/build/glsl.mjs';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The package under its public names, so that the demo imports it as a user would. */
export const alias = {
  'three-cube-collider/webgpu': here('src/webgpu/index.ts'),
  'three-cube-collider/helpers': here('src/helpers/index.ts'),
  'three-cube-collider/react': here('src/react/index.ts'),
  'three-cube-collider': here('src/index.ts'),
};

/** `vite`, `vite build`: the demo, and its page that measures; what they share is one file. */
const demo: UserConfig = {
  root: here('demo'),
  publicDir: here('public'),
  base: './',
  appType: 'mpa', // a missing level is an error, not the page itself
  resolve: { alias },
  server: { fs: { allow: [here('.')] } },
  // The tiles are of examples/tiles.html alone.
  plugins: [contentPolicy(), decoders(), rapierWasm(), offline(), leaveOut('examples/tiles')],
  build: {
    outDir: here('dist-demo'),
    emptyOutDir: true,
    chunkSizeWarningLimit: 1000, // three
    rolldownOptions: {
      input: [here('demo/index.html'), here('demo/bench.html')],
      output: {
        codeSplitting: {
          groups: [
            // The highest first: a group takes along what its modules import.
            { name: 'three', test: /three\/build\/three\.(core|module)/, priority: 1 },
            { name: 'three.webgpu', test: /three\/build\/three\.(webgpu|tsl)/ },
            { name: 'rapier', test: /rapier3d-compat/ },
            { name: 'three-mesh-bvh', test: /three-mesh-bvh/ },
          ],
        },
      },
    },
  },
};

/** `vite build --mode lib`: the package, three and React left to the user. */
const library: UserConfig = {
  publicDir: false,
  plugins: [shortShaders()],
  build: {
    outDir: here('dist'),
    sourcemap: true,
    minify: false,
    lib: {
      entry: {
        index: here('src/index.ts'),
        helpers: here('src/helpers/index.ts'),
        react: here('src/react/index.ts'),
      },
      formats: ['es'],
    },
    rolldownOptions: { external: [/^three($|\/)/, /^react($|\/)/, '@react-three/fiber'] },
  },
};

/**
 * `vite build --mode lib-webgpu`: the entry for `WebGPURenderer`, with all it needs, and with three's core from
 * `three/webgpu`, so that no page has to load `WebGLRenderer` for it.
 */
const webgpu: UserConfig = {
  ...library,
  plugins: [
    shortShaders(),
    {
      name: 'core-from-three-webgpu',
      enforce: 'pre',
      resolveId: (id) => (id === 'three' ? { id: 'three/webgpu', external: true } : null),
    },
  ],
  build: {
    ...library.build,
    emptyOutDir: false,
    lib: { entry: { webgpu: here('src/webgpu/index.ts') }, formats: ['es'] },
    rolldownOptions: { external: [/^three\//] },
  },
};

const MODES: Record<string, UserConfig> = { lib: library, 'lib-webgpu': webgpu };

export default defineConfig(({ mode }) => MODES[mode] ?? demo);
