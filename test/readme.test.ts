import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { DEFAULTS } from 'three-cube-collider';

const readme = readFileSync('README.md', 'utf8');

it('the defaults in README should be the package’s', () => {
  const shown = new Map(
    [...readme.matchAll(/^\| `(\w+)`\s*\| (.+?)\s*\|/gm)].map(([, name, value]) => [name!, value!]),
  );
  const { collider, character, axis } = DEFAULTS;
  const quoted = (value: string | number) =>
    `\`${typeof value === 'string' ? `'${value}'` : value}\``;
  for (const key of [
    'output',
    'resolution',
    'far',
    'readback',
    'sides',
    'format',
    'rMax',
  ] as const) {
    expect(shown.get(key), key).toBe(quoted(collider[key]));
  }
  expect(shown.get('near')).toBe(`${collider.nearRatio} \`far\``);
  expect(shown.get('slack')).toBe(`${collider.slackRatio} \`far\``);
  expect(shown.get('rMin')).toBe(`${collider.rMinRatio} \`rMax\``);
  for (const key of ['radius', 'height', 'gravity', 'jumpHeight', 'terminalSpeed'] as const) {
    expect(shown.get(key), key).toBe(quoted(character[key]));
  }
  expect(readme).toContain(`\`cXZ\` ${axis.cXZ}, \`cY\` ${axis.cY}, \`hMax\` ${axis.hMax}`);
});
