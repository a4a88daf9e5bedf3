import { Vector3 } from 'three';
import { describe, expect, it, vi } from 'vitest';
import type { CharacterControls } from '../src/controls/CharacterControls.js';
import { controlledPage } from './support/controlledPage.js';

/** Long enough for every smoothing to be over. */
function settle(controls: CharacterControls, seconds = 3, rate = 60) {
  for (let i = 0; i < seconds * rate; i++) {
    controls.update(1 / rate);
    controls.follow(1 / rate);
  }
}

describe('CharacterControls: walking', () => {
  it('should walk where the camera looks, at walking speed', () => {
    const { controls, character, key } = controlledPage();
    key('keydown', 'KeyW');
    settle(controls);
    expect(character.walked.toArray()).toEqual([0, 0, -3].map((x) => expect.closeTo(x, 6)));
    controls.yaw = Math.PI / 2; // a quarter to the left: toward -X
    settle(controls);
    expect(character.walked.toArray()).toEqual([-3, 0, 0].map((x) => expect.closeTo(x, 6)));
  });

  it('should be no faster on a diagonal, and faster with Shift', () => {
    const { controls, character, key } = controlledPage();
    key('keydown', 'ArrowUp');
    key('keydown', 'KeyD');
    settle(controls);
    expect(character.walked.length()).toBeCloseTo(3, 6);
    key('keydown', 'ShiftLeft');
    settle(controls);
    expect(character.walked.length()).toBeCloseTo(6, 6);
  });

  it('should stop when every key is up and then leave the character alone', () => {
    const { controls, character, key } = controlledPage();
    key('keydown', 'KeyS');
    settle(controls);
    key('keyup', 'KeyS');
    settle(controls);
    expect(character.walked.length()).toBe(0);
    character.walk.mockClear();
    settle(controls);
    expect(character.walk).not.toHaveBeenCalled();
  });

  it('should take up speed alike at any frame rate', () => {
    const speeds = [10, 60, 240].map((rate) => {
      const { controls, character, key } = controlledPage();
      key('keydown', 'KeyW');
      settle(controls, 0.2, rate);
      return character.walked.length();
    });
    for (const speed of speeds) expect(speed).toBeCloseTo(speeds[0]!, 6);
  });

  it('should jump once for a press, however short', () => {
    const { controls, character, key } = controlledPage();
    key('keydown', 'Space');
    key('keydown', 'Space', { repeat: true });
    key('keyup', 'Space');
    settle(controls);
    expect(character.jump).toHaveBeenCalledTimes(1);
  });

  it('should let go of every key on blur, on a hidden tab and on unlock', async () => {
    const { controls, character, key, send, document, defaultView } = controlledPage();
    await controls.lock();
    for (const lose of [
      () => send(defaultView, 'blur'),
      () => send(document, 'visibilitychange'),
      () => controls.unlock(),
    ]) {
      key('keydown', 'KeyW');
      settle(controls);
      expect(character.walked.length()).toBeCloseTo(3, 6);
      lose();
      settle(controls);
      expect(character.walked.length()).toBe(0);
    }
  });

  it('should leave to the page: Tab, shortcuts, and what is typed into a field', () => {
    const { controls, character, key } = controlledPage();
    expect(key('keydown', 'Tab').defaultPrevented).toBe(false);
    expect(key('keydown', 'KeyW', { ctrlKey: true }).defaultPrevented).toBe(false);
    for (const tagName of ['INPUT', 'SELECT', 'TEXTAREA']) {
      expect(key('keydown', 'KeyW', { from: { tagName } }).defaultPrevented).toBe(false);
    }
    expect(key('keydown', 'Space', { from: { tagName: 'BUTTON' } }).defaultPrevented).toBe(false);
    settle(controls);
    expect(character.walk).not.toHaveBeenCalled();
    expect(character.jump).not.toHaveBeenCalled();
    expect(key('keydown', 'Space').defaultPrevented).toBe(true); // or the page would scroll
  });

  it('should take other keys', () => {
    const { controls, character, key } = controlledPage({ keys: { forward: ['KeyZ'] } });
    key('keydown', 'KeyW');
    settle(controls);
    expect(character.walk).not.toHaveBeenCalled();
    key('keydown', 'KeyZ');
    settle(controls);
    expect(character.walked.z).toBeCloseTo(-3, 6);
  });

  it('should stop the character when disabled, and hear nothing', () => {
    const { controls, character, key } = controlledPage();
    key('keydown', 'KeyW');
    settle(controls);
    controls.enabled = false;
    settle(controls);
    expect(character.walked.length()).toBe(0);
    key('keydown', 'KeyW');
    controls.enabled = true;
    settle(controls);
    expect(character.walked.length()).toBe(0);
  });

  it('should hear nothing after dispose', () => {
    const { controls, character, key, send, element } = controlledPage();
    controls.dispose();
    key('keydown', 'KeyW');
    send(element, 'pointerdown', { pointerId: 1, clientX: 0, clientY: 0 });
    send(element, 'pointermove', { pointerId: 1, clientX: 50, clientY: 0 });
    settle(controls);
    expect(character.walk).not.toHaveBeenCalled();
    expect(controls.yaw).toBe(0);
  });
});

describe('CharacterControls: looking', () => {
  it('should capture the pointer on a click, and say so', async () => {
    const { controls, send, element } = controlledPage();
    const heard: string[] = [];
    controls.addEventListener('lock', () => heard.push('lock'));
    controls.addEventListener('unlock', () => heard.push('unlock'));
    send(element, 'click');
    await Promise.resolve();
    expect(controls.isLocked).toBe(true);
    send(element, 'pointermove', { movementX: 100, movementY: -50 });
    expect(controls.yaw).toBeCloseTo(-0.2, 9);
    expect(controls.pitch).toBeCloseTo(0.1, 9);
    controls.unlock();
    expect(heard).toEqual(['lock', 'unlock']);
  });

  it('should look by dragging where the capture is refused', async () => {
    const { controls, send, element } = controlledPage();
    element.refuses = true;
    await controls.lock();
    send(element, 'pointermove', { pointerId: 1, clientX: 90, clientY: 0 });
    expect(controls.yaw).toBe(0);
    send(element, 'pointerdown', { pointerId: 1, clientX: 100, clientY: 0 });
    send(element, 'pointermove', { pointerId: 1, clientX: 0, clientY: 0 });
    expect(controls.yaw).toBeCloseTo(0.2, 9);
    send(element, 'pointerup', { pointerId: 1 });
    send(element, 'pointermove', { pointerId: 1, clientX: 300, clientY: 0 });
    expect(controls.yaw).toBeCloseTo(0.2, 9);
  });

  it('should tilt no farther than the limits', async () => {
    const { controls, send, element } = controlledPage();
    await controls.lock();
    send(element, 'pointermove', { movementX: 0, movementY: -1e5 });
    expect(controls.pitch).toBeCloseTo((85 * Math.PI) / 180, 9);
    send(element, 'pointermove', { movementX: 0, movementY: 1e6 });
    expect(controls.pitch).toBeCloseTo((-85 * Math.PI) / 180, 9);
  });
});

describe('CharacterControls: camera', () => {
  it('should put the camera at the eyes in first person, the avatar undrawn', () => {
    const { controls, character, camera } = controlledPage();
    character.position.set(1, 2, 3);
    controls.follow(0);
    expect(camera.position.toArray()).toEqual([1, 3.6, 3]);
    expect(character.avatar.visible).toBe(false);
  });

  it('should stand behind and above the head in third person, never under the ground', () => {
    const { controls, character, camera } = controlledPage();
    const changed = vi.fn();
    controls.addEventListener('change', changed);
    controls.view = 'third';
    expect(changed).toHaveBeenCalledTimes(1);
    settle(controls);
    expect(camera.position.z).toBeGreaterThan(3);
    expect(camera.position.y).toBeGreaterThan(1.6);
    expect(character.avatar.visible).toBe(true);
    for (const distance of [1, 4, 7]) {
      controls.distance = distance;
      for (let pitch = -1.48; pitch < 1.48; pitch += 0.1) {
        controls.pitch = pitch;
        settle(controls, 0.5);
        expect(camera.position.y).toBeGreaterThan(0.2);
      }
    }
  });

  it('should zoom with the wheel within limits, in third person only', () => {
    const { controls, send, element } = controlledPage();
    const wheel = (deltaY: number) => send(element, 'wheel', { deltaY, deltaMode: 0 });
    expect(wheel(100).defaultPrevented).toBe(false);
    expect(controls.distance).toBe(4);
    controls.view = 'third';
    expect(wheel(100).defaultPrevented).toBe(true);
    wheel(1e5);
    expect(controls.distance).toBe(7);
    wheel(-1e5);
    expect(controls.distance).toBe(1);
  });

  it('should take a step of the foot gently, a fall and a teleport at once', () => {
    const { controls, character, camera } = controlledPage();
    controls.follow(1 / 60);
    character.position.y = 0.3;
    controls.follow(1 / 60);
    expect(camera.position.y).toBeGreaterThan(1.6);
    expect(camera.position.y).toBeLessThan(1.75);
    settle(controls);
    expect(camera.position.y).toBeCloseTo(1.9, 6);
    character.grounded = false;
    character.position.y = 0;
    controls.follow(1 / 60);
    expect(camera.position.y).toBeCloseTo(1.6, 6);
    character.grounded = true;
    controls.follow(1 / 60);
    character.position.y = 5;
    controls.follow(1 / 60);
    expect(camera.position.y).toBeCloseTo(6.6, 6);
  });

  it('should turn the avatar where it walks, the short way round', () => {
    const { controls, character, key } = controlledPage({ view: 'third' });
    settle(controls);
    key('keydown', 'KeyD'); // toward +X; an avatar looks along its +Z
    settle(controls);
    const forward = new Vector3(0, 0, 1).applyQuaternion(character.avatar.quaternion);
    expect(forward.toArray()).toEqual([1, 0, 0].map((x) => expect.closeTo(x, 4)));
  });

  it('should refuse nonsense and say what it wants', () => {
    expect(() => controlledPage({ walkSpeed: -1 })).toThrow(/CharacterControls: "walkSpeed"/);
    expect(() => controlledPage({ eyeHeight: NaN })).toThrow(RangeError);
    expect(() => controlledPage({ view: 'second' as 'first' })).toThrow(/'first' or 'third'/);
  });
});
