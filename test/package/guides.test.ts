import { readdirSync, readFileSync } from 'node:fs';
import sharp from 'sharp';
import { describe, expect, it } from 'vitest';

const guides = readFileSync('docs/guides/README.md', 'utf8');
const names = readdirSync('examples')
  .filter((name) => name.endsWith('.html'))
  .map((name) => name.replace('.html', ''));

/** Code without comments, blanks, and what the formatter adds where it breaks a line. */
const bare = (code: string) =>
  code
    .replace(/ *\/\/ .*/g, '')
    .replace(/\s+/g, '')
    .replace(/,(?=[)\]}])/g, '');

/** Code that a guide shows of its page, each piece between blank lines and comments of their own. */
const shown = guides.split(/^## /m).flatMap((section) => {
  const name = /\(\.\.\/\.\.\/examples\/([\w-]+)\.html\)/.exec(section)?.[1];
  const blocks = section.matchAll(/<!-- of the page -->\s*```js\n(.*?)```/gs);
  return [...blocks].map(([, code]) => ({ name: name!, pieces: code!.split(/\n\n|^\/\/ .*\n/m) }));
});

describe('the guides', () => {
  it('should show code as it stands in their pages', () => {
    expect(shown.length).toBeGreaterThan(5);
    for (const { name, pieces } of shown) {
      const page = bare(readFileSync(`examples/${name}.html`, 'utf8'));
      for (const piece of pieces)
        expect(page.includes(bare(piece)), `${name}: ${piece}`).toBe(true);
    }
  });

  it('should tell of every example', () => {
    expect(names.length).toBeGreaterThan(10);
    for (const name of names) expect(guides).toContain(`(../../examples/${name}.html)`);
  });

  it.each(names)('should open with a picture of %s, small, of something', async (name) => {
    const grid = guides.slice(0, guides.indexOf('\n## '));
    expect(grid, `npm run build:gallery -- ${name}`).toContain(`(${name}.webp)](#`);
    const picture = sharp(`docs/guides/${name}.webp`);
    const { width, height } = await picture.metadata();
    expect([width, height]).toEqual([480, 270]);
    expect(readFileSync(`docs/guides/${name}.webp`).length).toBeLessThanOrEqual(30_000);
    const { channels } = await picture.stats();
    expect(Math.max(...channels.map(({ stdev }) => stdev))).toBeGreaterThan(20);
  });
});
