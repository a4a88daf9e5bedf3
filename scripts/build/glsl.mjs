// @ts-check
import MagicString from 'magic-string';

/** A template literal marked as a shader. */
const MARK = /\/\* glsl \*\/ `/g;

/**
 * Takes comments, indentation and needless blanks out of GLSL. Lines stay lines: directives and three's `#include`
 * want their own.
 *
 * @param {string} text
 * @param {boolean} [open] whether something comes right before it in its line
 * @param {boolean} [goesOn] whether something comes right after it in its line
 */
export function minifyGlsl(text, open = false, goesOn = false) {
  const lines = text.replace(/\/\*[\s\S]*?\*\//g, ' ').split('\n');
  const kept = lines.map((line, i) => {
    let bare = line.replace(/\/\/.*$/, '').replace(/[ \t]+/g, ' ');
    // A blank more or less changes what a macro is: `#define f (x)`.
    if (!/^\s*#/.test(bare)) bare = bare.replace(/ ?([(){}[\],;=*/<>?:&|]) ?/g, '$1');
    if (i > 0 || !open) bare = bare.trimStart();
    if (i < lines.length - 1 || !goesOn) bare = bare.trimEnd();
    return bare;
  });
  return kept.filter((line, i) => line !== '' || i === 0 || i === kept.length - 1).join('\n');
}

/**
 * The literal parts of a module's shaders, those inside another's interpolation too.
 *
 * @param {string} code
 * @returns {{ start: number, end: number, open: boolean, goesOn: boolean }[]} `open` and `goesOn` as for `minifyGlsl`
 */
export function shaderTexts(code) {
  const texts = [];
  for (const { index, 0: mark } of code.matchAll(MARK)) {
    let start = index + mark.length;
    for (let open = false; ; open = true) {
      const end = endOfText(code, start);
      const goesOn = code[end] === '$';
      if (end > start) texts.push({ start, end, open, goesOn });
      if (!goesOn) break;
      start = endOfInterpolation(code, end);
    }
  }
  return texts;
}

/** Where a template's text ends: at its last mark, or at what is interpolated. @param {string} code @param {number} at */
function endOfText(code, at) {
  for (let i = at; i < code.length; i++) {
    if (code[i] === '\\') i++;
    else if (code[i] === '`' || (code[i] === '$' && code[i + 1] === '{')) return i;
  }
  throw new Error('A shader without an end.');
}

/** Behind the brace that closes what is interpolated from `at` on. @param {string} code @param {number} at */
function endOfInterpolation(code, at) {
  let depth = 0;
  for (let i = at + 1; i < code.length; i++) {
    if (code[i] === '{') depth++;
    else if (code[i] === '}' && --depth === 0) return i + 1;
    else if (code[i] === "'") i = code.indexOf("'", i + 1);
    else if (code[i] === '`') {
      let end = endOfText(code, i + 1);
      while (code[end] === '$') end = endOfText(code, endOfInterpolation(code, end));
      i = end;
    }
  }
  throw new Error('An interpolation without an end.');
}

/** For the library's build: shaders as short as they may be. @returns {import('vite').Plugin} */
export function shortShaders() {
  return {
    name: 'short-shaders',
    enforce: 'pre',
    transform(code, id) {
      if (!id.endsWith('.ts') || !code.includes('/* glsl */')) return null;
      const short = new MagicString(code);
      for (const { start, end, open, goesOn } of shaderTexts(code)) {
        short.update(start, end, minifyGlsl(code.slice(start, end), open, goesOn));
      }
      return { code: short.toString(), map: short.generateMap({ hires: true }) };
    },
  };
}
