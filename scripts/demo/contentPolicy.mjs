// @ts-check
// A plugin of Vite: the built pages load nothing but their own, and run no script that is not a file of theirs.

const POLICY = [
  "default-src 'self'",
  // Decoders of levels, and Rapier on the page that measures, are WebAssembly.
  "script-src 'self' 'wasm-unsafe-eval'",
  // Those decoders work beside the page, by code that three puts together.
  "worker-src 'self' blob:",
  // The pictures and buffers in a level, and levels dropped on the page.
  "img-src 'self' blob: data:",
  "connect-src 'self' blob: data:",
  // The panel's few icons, in lil-gui's own styles.
  "font-src 'self' data:",
  "object-src 'none'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/**
 * Only what is built: Vite's own server puts styles into the page by script.
 *
 * @returns {import('vite').Plugin}
 */
export function contentPolicy() {
  return {
    name: 'content-policy',
    apply: 'build',
    transformIndexHtml: () => [
      {
        tag: 'meta',
        attrs: { 'http-equiv': 'Content-Security-Policy', content: POLICY },
        injectTo: 'head-prepend',
      },
    ],
  };
}
