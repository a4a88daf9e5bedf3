import { readFileSync } from 'node:fs';
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
  expect(shown.get('maxAge')).toBe(quoted(collider.maxAge));
  // The longest step taken at once is no option.
  const { slopeLimit } = character;
  for (const [key, value] of Object.entries(character)) {
    if (key === 'maxDelta' || key === 'slopeLimit') continue;
    expect(shown.get(key), key).toBe(quoted(value));
  }
  expect(shown.get('slopeLimit')).toBe(`${Math.round((slopeLimit * 180) / Math.PI)}°, in radians`);
  expect(readme).toContain(`\`cXZ\` ${axis.cXZ}, \`cY\` ${axis.cY}, \`hMax\` ${axis.hMax}`);
});
