import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { expect, it } from 'vitest';
import { DEFAULTS } from 'three-cube-collider';

const readme = readFileSync('README.md', 'utf8');

it('the defaults in README should be the package’s', () => {
  const shown = new Map(
    [...readme.matchAll(/^\| `(\w+)`\s*\| (.+?)\s*\|/gm)].map(([, name, value]) => [name!, value!]),
  );
  const { collider, character, axis } = DEFAULTS;
  const quoted = (value: string | number | boolean) =>
    `\`${typeof value === 'string' ? `'${value}'` : value}\``;
  for (const key of [
    'output',
    'resolution',
    'supersample',
    'far',
    'readback',
    'sides',
    'transparent',
    'format',
    'rMax',
  ] as const) {
    expect(shown.get(key), key).toBe(quoted(collider[key]));
  }
  expect(shown.get('near')).toBe(`${collider.nearRatio} \`far\``);
  expect(shown.get('slack')).toBe(`${collider.slackRatio} \`far\``);
  expect(shown.get('rMin')).toBe(`${collider.rMinRatio} \`rMax\``);
  const { controls } = DEFAULTS;
  for (const key of [
    'view',
    'eyeHeight',
    'distance',
    'sensitivity',
    'touchSensitivity',
    'stickSensitivity',
    'deadZone',
    'invertY',
    'toggleRun',
    'touchStick',
  ] as const) {
    expect(shown.get(key), key).toBe(quoted(controls[key]));
  }
  expect(readme).toContain(`\`${controls.turnKeys}\`, \`${controls.turnSpeed}\``);
  expect(readme).toContain(`\`${controls.agility}\`, \`${controls.smoothing}\``);
  expect(readme).toContain(`\`${controls.walkSpeed}\`, \`${controls.runSpeed}\``);
  expect(readme).toContain(`from ${controls.minDistance} to ${controls.maxDistance}`);
  for (const key of ['radius', 'height', 'gravity', 'jumpHeight', 'terminalSpeed'] as const) {
    expect(shown.get(key), key).toBe(quoted(character[key]));
  }
  expect(readme).toContain(`\`cXZ\` ${axis.cXZ}, \`cY\` ${axis.cY}, \`hMax\` ${axis.hMax}`);
});

it.each(['README.md', 'docs/architecture.md', 'docs/benchmarks.md', 'docs/paper.md'])(
  'should link to what exists, and leave nothing to fill in: %s',
  (file) => {
    const text = readFileSync(file, 'utf8');
    for (const [, link] of text.matchAll(/\]\((?!https?:)([^)#]+)/g)) {
      expect(existsSync(join(dirname(file), link!)), link).toBe(true);
    }
    for (const [, path] of text.matchAll(/`((?:src|e2e|test|bench|scripts)\/[\w./-]+\.\w+)`/g)) {
      expect(existsSync(path!), path).toBe(true);
    }
    expect(text).not.toMatch(/<!-- \w+ table -->/);
  },
);
