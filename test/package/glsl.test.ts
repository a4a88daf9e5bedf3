import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { minifyGlsl, shaderTexts } from '../../scripts/build/glsl.mjs';

/** What a compiler sees: tokens, and the lines of directives. */
function tokens(glsl: string): string[] {
  const bare = glsl.replace(/\/\*[\s\S]*?\*\//g, ' ').replace(/\/\/.*$/gm, '');
  return bare.split('\n').flatMap((line) => {
    // Blanks decide between a macro's parameters and its body.
    if (/^\s*#/.test(line)) return [line.trim().replace(/\s+/g, ' ')];
    return line.match(/[\w.]+|<<=|>>=|[-+*/%&|^<>=!]=|<<|>>|&&|\|\||\^\^|\+\+|--|[^\s\w]/g) ?? [];
  });
}

describe('shaders in the built package', () => {
  const modules = readdirSync('src', { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts'))
    .map((name) => [name, readFileSync(join('src', name), 'utf8')] as const)
    .filter(([, code]) => code.includes('/* glsl */'));

  it('should be found', () => {
    expect(modules.length).toBeGreaterThan(5);
  });

  it.each(modules)('should mean the same to a compiler: %s', (_, code) => {
    const texts = shaderTexts(code);
    for (const { start, end, open, goesOn } of texts) {
      const text = code.slice(start, end);
      const short = minifyGlsl(text, open, goesOn);
      expect(tokens(short)).toEqual(tokens(text));
      // What is interpolated in the same line must not become part of another word.
      if (goesOn) expect(/\w $/.test(text)).toBe(/\w $/.test(short));
      if (open) expect(/^ \w/.test(text)).toBe(/^ \w/.test(short));
    }
  });

  it('should keep signs apart, and macros', () => {
    expect(minifyGlsl('a = b - - c; // why')).toBe('a=b - - c;');
    expect(minifyGlsl('  #define f (x)\n  int  a ;')).toBe('#define f (x)\nint a;');
  });
});
