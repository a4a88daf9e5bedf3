import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { DEFAULTS } from 'three-cube-collider';

const readme = readFileSync('README.md', 'utf8');

/** Every option of a section's tables, by its name, with the default that stands beside it. */
function shown(heading: string): Map<string, string> {
  const [, section] = readme.split(new RegExp(`^### ${heading}$`, 'm'));
  const rows = section!.split(/^#/m)[0]!.matchAll(/^\| (`\w+`(?:, `\w+`)*) +\| (.+?) +\|/gm);
  const pairs = [...rows].flatMap(([, names, values]) => {
    const each = names!.split(', ');
    const theirs = each.length > 1 ? values!.split(', ') : [values!];
    return each.map((name, i) => [name.replaceAll('`', ''), theirs[i]!] as const);
  });
  return new Map(pairs);
}

const quoted = (value: unknown) =>
  `\`${typeof value === 'string' ? `'${value}'` : String(value)}\``;
const degrees = (angle: number) => `${Math.round((angle * 180) / Math.PI)}°, in radians`;

describe('the defaults in README should be the package’s', () => {
  it('of the collider', () => {
    const { nearRatio, rMinRatio, slackRatio, rMax, ...rest } = DEFAULTS.collider;
    expect(Object.fromEntries(shown('`CubeCollider`'))).toEqual({
      ...Object.fromEntries(Object.entries(rest).map(([key, value]) => [key, quoted(value)])),
      near: `${nearRatio} \`far\``,
      slack: `${slackRatio} \`far\``,
      filter: 'none',
    });
    const { cXZ, cY, hMax } = DEFAULTS.axis;
    expect(Object.fromEntries(shown("The paper's mode"))).toEqual({
      rMax: quoted(rMax),
      rMin: `${rMinRatio} \`rMax\``,
      cXZ: quoted(cXZ),
      cY: quoted(cY),
      hMax: quoted(hMax),
    });
  });

  it('of the character', () => {
    // The longest step taken at once is no option.
    const { maxDelta, slopeLimit, ...rest } = DEFAULTS.character;
    expect(maxDelta).toBeGreaterThan(0);
    expect(Object.fromEntries(shown('`CharacterController`'))).toEqual({
      ...Object.fromEntries(Object.entries(rest).map(([key, value]) => [key, quoted(value)])),
      slopeLimit: degrees(slopeLimit),
      up: '+Y',
      respawnBelow: '`null`',
      response: '`new SlideResponse()`',
      avatar: 'none',
    });
  });

  it('of the controls', () => {
    const { maxPitch, ...rest } = DEFAULTS.controls;
    const { keys, buttons, ...table } = Object.fromEntries(shown('`CharacterControls`'));
    expect(table).toEqual({
      ...Object.fromEntries(Object.entries(rest).map(([key, value]) => [key, quoted(value)])),
      maxPitch: degrees(maxPitch),
      boom: 'none',
    });
    expect([keys, buttons]).not.toContain(undefined);
  });
});

it.each([
  ['src/character/characterEvents.ts', 'CharacterEventMap'],
  ['src/controls/controlsOptions.ts', 'CharacterControlsEventMap'],
])('README should tell of every event of %s', (file, name) => {
  const [, body] = new RegExp(`interface ${name} {\n(.*?)\n}`, 's').exec(
    readFileSync(file, 'utf8'),
  )!;
  const events = [...body!.matchAll(/^ {2}(\w+): /gm)].map(([, event]) => event!);
  expect(events.length).toBeGreaterThan(2);
  const [, section] = readme.split('\n## Events');
  const told = section!.split('\n## ')[0]!;
  for (const event of events)
    expect(told, event).toMatch(new RegExp(`[|,] ${event}\\b|\`${event}\``));
});
