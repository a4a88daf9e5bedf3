import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { CharacterControls } from '../../src/controls/CharacterControls.js';
import { controlledPage } from '../support/controlledPage.js';

function run(controls: CharacterControls, frames = 180, each: () => void = () => {}) {
  for (let i = 0; i < frames; i++) {
    controls.update(1 / 60);
    controls.follow(1 / 60);
    each();
  }
}

describe('CharacterControls: keys', () => {
  it('should let go of every key with Command, under which macOS tells of none', () => {
    const { controls, character, key } = controlledPage();
    key('keydown', 'KeyW');
    run(controls);
    key('keyup', 'MetaLeft', { key: 'Meta' });
    run(controls);
    expect(character.walked.length()).toBe(0);
  });

  it('should jump once however long the key is held', () => {
    const { controls, character, key } = controlledPage();
    key('keydown', 'Space');
    for (let i = 0; i < 3; i++) {
      run(controls, 2);
      key('keydown', 'Space', { repeat: true });
    }
    run(controls, 2);
    expect(character.jump).toHaveBeenCalledTimes(1);
  });

  it('should leave to the page what is typed into an editable text', () => {
    const { key } = controlledPage();
    const from = { tagName: 'DIV', isContentEditable: true };
    expect(key('keydown', 'KeyW', { from }).defaultPrevented).toBe(false);
    expect(
      key('keydown', 'KeyW', { from: { ...from, isContentEditable: false } }).defaultPrevented,
    ).toBe(true);
  });
});

describe('CharacterControls: pointer', () => {
  it('should take neither the end of a drag nor a finger’s tap for a click', () => {
    const { controls, pointer } = controlledPage();
    pointer('pointerdown', 0);
    pointer('pointermove', 50);
    pointer('pointerup', 50);
    pointer('click', 50);
    expect(controls.isLocked).toBe(false);
    pointer('pointerdown', 0, { pointerType: 'touch' });
    pointer('pointerup');
    pointer('click');
    expect(controls.isLocked).toBe(false);
    pointer('pointerdown', 0, { pointerType: 'mouse' });
    pointer('pointerup');
    pointer('click');
    expect(controls.isLocked).toBe(true);
  });

  it('should drag no more once the pointer was captured', async () => {
    const { controls, pointer } = controlledPage();
    pointer('pointerdown', 0);
    await controls.lock();
    controls.unlock();
    pointer('pointermove', 300);
    expect(controls.yaw).toBe(0);
  });

  it('should capture without raw travel where there is none', async () => {
    const { controls, element } = controlledPage({ unadjustedMovement: true });
    element.noRaw = true;
    await controls.lock();
    expect(controls.isLocked).toBe(true);
  });

  it('should zoom by lines and pages as the browser scrolls them, and leave pinches to it', () => {
    const { controls, element, send } = controlledPage({ view: 'third' });
    for (const [deltaY, deltaMode, pixels] of [
      [60, 0, 60],
      [3, 1, 99],
      [1, 2, 400],
    ] as const) {
      controls.distance = 4;
      send(element, 'wheel', { deltaY, deltaMode });
      expect(controls.distance).toBeCloseTo(4 * Math.exp(0.001 * pixels), 9);
    }
    controls.distance = 4;
    const pinch = send(element, 'wheel', { deltaY: 60, deltaMode: 0, ctrlKey: true });
    expect(pinch.defaultPrevented).toBe(false);
    expect(controls.distance).toBe(4);
  });

  it('should take off every listener that it put on', () => {
    const { controls, document, defaultView, element } = controlledPage();
    const targets = [document, defaultView, element];
    for (const { heard } of targets) expect(heard.size).toBeGreaterThan(0);
    controls.dispose();
    for (const { heard } of targets) expect([...heard.values()]).toEqual([]);
  });
});

describe('CharacterControls: view', () => {
  it('should begin with the camera’s own view, and look where it says', () => {
    const camera = new PerspectiveCamera();
    camera.rotation.set(0.3, 0.5, 0, 'YXZ');
    const before = camera.getWorldDirection(new Vector3());
    const { controls } = controlledPage({}, camera);
    expect(controls.yaw).toBeCloseTo(0.5, 9);
    expect(controls.pitch).toBeCloseTo(0.3, 9);
    controls.follow(0);
    expect(camera.getWorldDirection(new Vector3()).distanceTo(before)).toBeLessThan(1e-9);
    expect(before.y).toBeGreaterThan(0.29); // up is positive
  });

  it('should turn the avatar over its back, not all the way round by its face', () => {
    const { controls, character, key } = controlledPage({ view: 'third' });
    run(controls, 2); // it looks along -Z, at π
    controls.yaw = 0.3; // and is to look along -π + 0.3
    key('keydown', 'KeyW');
    const forward = new Vector3();
    run(controls, 120, () => {
      forward.set(0, 0, 1).applyQuaternion(character.avatar.quaternion);
      expect(forward.z).toBeLessThan(-0.9);
    });
    expect(forward.x).toBeCloseTo(-Math.sin(0.3), 4);
  });
});
