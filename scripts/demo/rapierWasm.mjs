// @ts-check
// A plugin of Vite: Rapier's WebAssembly as a file of its own.

/** Where Rapier's package hands its WebAssembly, in text, to what compiles it. */
const INLINED = /\{module_or_path:\w+\.toByteArray\("[A-Za-z0-9+/=]+"\)\.buffer\}/;

/** The same bytes lie beside it in the package. */
const FETCH = `
import rapierUrl from './rapier_wasm3d_bg.wasm?url';
async function fetchRapier() {
  const response = await fetch(rapierUrl);
  if (!response.ok) throw new Error(\`Rapier: \${response.status} for \${rapierUrl}\`);
  return response.arrayBuffer();
}
`;

/**
 * `rapier3d-compat` holds its WebAssembly as text in its script, which weighs 0.4 MB more, compressed, and has to be
 * parsed and decoded first. In a build it is fetched instead, when `RAPIER.init()` asks for it.
 *
 * @returns {import('vite').Plugin}
 */
export function rapierWasm() {
  return {
    name: 'rapier-wasm',
    apply: 'build',
    transform: {
      filter: { id: /rapier3d-compat\/dist\/rapier\.mjs$/ },
      handler(code) {
        if (!INLINED.test(code)) throw new Error('rapierWasm: this Rapier loads in another way.');
        return {
          code: FETCH + code.replace(INLINED, '{module_or_path:yield fetchRapier()}'),
          map: null,
        };
      },
    },
  };
}
