import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, expect, it } from 'vitest';

const files = ['.', 'docs', 'docs/guides', '.github']
  .filter((folder) => existsSync(folder))
  .flatMap((folder) => readdirSync(folder).map((name) => join(folder, name)))
  .filter((name) => name.endsWith('.md'));

/** Markdown without its code, in which nothing is a link. */
const prose = (text: string) => text.replace(/^(```+)[\s\S]*?^\1/gm, '').replace(/`[^`\n]*`/g, '`');

/** The anchors of a file, as GitHub makes them of its headings. */
function anchors(file: string): Set<string> {
  const found = new Set<string>();
  const text = readFileSync(file, 'utf8').replace(/^(```+)[\s\S]*?^\1/gm, '');
  for (const [, heading] of text.matchAll(/^#{1,6} +(.+?) *$/gm)) {
    const bare = heading!.replace(/\[([^\]]*)\]\([^)]*\)/g, '$1').toLowerCase();
    const slug = bare.replace(/[^\p{L}\p{N}_ -]/gu, '').replaceAll(' ', '-');
    let name = slug;
    for (let i = 1; found.has(name); i++) name = `${slug}-${i}`;
    found.add(name);
  }
  for (const [, name] of text.matchAll(/<a (?:id|name)="([^"]+)"/g)) found.add(name!);
  return found;
}

describe('every page of the docs', () => {
  it('should be looked at', () => {
    expect(files).toContain('README.md');
    expect(files.length).toBeGreaterThan(8);
  });

  it.each(files)('should link to what exists, and leave nothing to fill in: %s', (file) => {
    const text = readFileSync(file, 'utf8');
    const links = [
      ...prose(text).matchAll(/\]\(<?([^)>\s]+)>?(?: "[^"]*")?\)|^\[[^\]]+\]: (\S+)/gm),
    ]
      .map(([, inline, reference]) => inline ?? reference!)
      .filter((link) => !/^(https?|mailto):/.test(link));
    for (const link of links) {
      const [path, anchor] = link.split('#') as [string, string?];
      const target = path === '' ? file : join(dirname(file), path);
      expect(existsSync(target), link).toBe(true);
      if (anchor !== undefined) expect([...anchors(target)], link).toContain(anchor);
    }
    for (const [, path] of text.matchAll(
      /`((?:src|e2e|test|bench|scripts|consumers|examples)\/[\w./-]+\.\w+)`/g,
    )) {
      expect(existsSync(path!), path).toBe(true);
    }
    expect(text).not.toMatch(/<!-- \w+ table -->|\b[A-Z]+_URL\b|TODO/);
  });

  it('should tell of npm scripts that exist', () => {
    const { scripts } = JSON.parse(readFileSync('package.json', 'utf8'));
    scripts.dev = 'of the app that the quick start is pasted in';
    const builtIn = new Set([
      'install',
      'create',
      'start',
      'test',
      'version',
      'audit',
      'pack',
      'ci',
    ]);
    for (const file of files) {
      const text = readFileSync(file, 'utf8');
      for (const [command, run, name] of text.matchAll(/\bnpm (run )?([a-z][\w:-]*)/g)) {
        if (run === undefined && builtIn.has(name!)) continue;
        if (run !== undefined) expect(Object.keys(scripts), `${file}: ${command}`).toContain(name);
      }
    }
  });
});
