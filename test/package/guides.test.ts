import { readdirSync, readFileSync } from 'node:fs';
import sharp from 'sharp';
import { describe, expect, it } from 'vitest';

const guides = readFileSync('docs/guides/README.md', 'utf8');
const names = readdirSync('examples')
  .filter((name) => name.endsWith('.html'))
  .map((name) => name.replace('.html', ''));

describe('the guides', () => {
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
