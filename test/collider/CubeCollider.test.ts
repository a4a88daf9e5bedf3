import { Group, Scene } from 'three';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { CubeCollider } from 'three-cube-collider';
import { box } from '../support/meshes.js';

describe('a collider’s survey', () => {
  afterEach(() => vi.restoreAllMocks());

  it('should call everything changed while there is no draw, and list the sensors', () => {
    const collider = new CubeCollider();
    const coin = box();
    coin.userData.sensor = true;
    coin.position.x = 5;
    const scene = new Scene().add(coin);
    const report = collider.survey(scene);
    expect(report).toEqual({ moved: false, changed: true, deforms: false, sensors: [] });
    collider.position.x = 5;
    expect(collider.survey(scene)).toBe(report);
    expect(report.sensors).toEqual([coin]);
    collider.invalidate();
    expect(collider.survey(scene).changed).toBe(true);
  });

  it('should warn once of what cannot be surveyed, and never throw', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const collider = new CubeCollider();
    const nothing = { moved: false, changed: false, deforms: false, sensors: [] };
    const broken = new Scene().add(box());
    broken.children[0]!.matrixWorld = null as never;
    for (let i = 0; i < 3; i++) {
      expect(collider.survey(undefined as never)).toEqual(nothing);
      expect(collider.survey({} as never)).toEqual(nothing);
      expect(collider.survey(broken)).toEqual(nothing);
    }
    expect(warn).toHaveBeenCalledTimes(2);
    collider.dispose();
    expect(collider.survey(new Scene())).toEqual(nothing);
    expect(collider.survey(new Scene())).toEqual(nothing);
    expect(warn).toHaveBeenCalledTimes(3);
    for (const [message] of warn.mock.calls) expect(message).toMatch(/^CubeCollider: /);
  });
});

describe('a sensor without a geometry', () => {
  afterEach(() => vi.restoreAllMocks());

  it('should be warned of once, wherever it is and whatever it holds but sensors', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const group = (name: string, ...children: Parameters<Group['add']>) => {
      const made = new Group();
      if (children.length > 0) made.add(...children);
      made.name = name;
      made.userData.sensor = true;
      return made;
    };
    const coin = box();
    coin.userData.sensor = true;
    const far = group('far');
    far.position.x = 1000;
    const scene = new Scene().add(
      group('goal'),
      far,
      group('of walls', box()),
      group('of coins', new Group().add(coin)),
      box(),
    );
    const collider = new CubeCollider();
    for (let i = 0; i < 20; i++) expect(collider.survey(scene).sensors).toEqual([coin]);
    const said = (name: string) =>
      `CubeCollider: the sensor Group "${name}" has no geometry, so nobody is ever in it; set userData.sensor = true on a mesh.`;
    expect(warn.mock.calls).toEqual([[said('goal')], [said('far')], [said('of walls')]]);
    const late = group('late');
    scene.add(late);
    collider.survey(scene);
    expect(warn.mock.calls.slice(3)).toEqual([[said('late')]]);
    // A camera's collider sees the same scene, and so do those of a crowd.
    new CubeCollider().survey(scene);
    expect(warn).toHaveBeenCalledTimes(4);
  });
});

describe('the reach', () => {
  it('should be settable at any time, and checked as the option is', () => {
    const collider = new CubeCollider({ near: 0.1 });
    expect(collider.autoFar).toBe(true);
    collider.far = 2.5;
    expect(collider.far).toBe(2.5);
    expect(collider.near).toBe(0.1);
    for (const far of [0.1, 0.05, 0, -1, NaN, Infinity, '3' as never]) {
      expect(() => (collider.far = far)).toThrow(RangeError);
      expect(() => (collider.far = far)).toThrow(/^CubeCollider: "far" must be/);
    }
    expect(collider.far).toBe(2.5);
  });

  it('should be a character’s to set only where the user did not, for surfaces', () => {
    expect(new CubeCollider({ far: 1.8 }).autoFar).toBe(false);
    const axis = new CubeCollider({ output: 'axis' });
    expect(axis.autoFar).toBe(false);
    expect(() => (axis.far = axis.rMax / 2)).toThrow(/"far" must be at least "rMax"/);
  });
});
