import { fileURLToPath } from 'node:url';
import { defineConfig, type UserConfig } from 'vite';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The package under its public names, so that the demo imports it as a user would. */
export const alias = {
  'three-cube-collider/webgpu': here('src/webgpu/index.ts'),
  'three-cube-collider/helpers': here('src/helpers/index.ts'),
  'three-cube-collider': here('src/index.ts'),
};

/** `vite`, `vite build`: the demo. */
const demo: UserConfig = {
  root: here('demo'),
  publicDir: here('public'),
  base: './',
  appType: 'mpa', // a missing level is an error, not the page itself
  resolve: { alias },
  server: { fs: { allow: [here('.')] } },
  build: { outDir: here('dist-demo'), emptyOutDir: true, chunkSizeWarningLimit: 1200 },
};

/** `vite build --mode lib`: the package, three left to the user. */
const library: UserConfig = {
  publicDir: false,
  build: {
    outDir: here('dist'),
    sourcemap: true,
    minify: false,
    lib: {
      entry: { index: here('src/index.ts'), helpers: here('src/helpers/index.ts') },
      formats: ['es'],
    },
    rolldownOptions: { external: [/^three($|\/)/] },
  },
};

export default defineConfig(({ mode }) => (mode === 'lib' ? library : demo));
