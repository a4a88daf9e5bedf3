import { describe, expect, it, vi } from 'vitest';
import type { CharacterControls } from '../../src/controls/CharacterControls.js';
import { bytesEach } from '../support/bytesEach.js';
import { controlledPage } from '../support/controlledPage.js';

function run(controls: CharacterControls, seconds = 3) {
  for (let i = 0; i < 60 * seconds; i++) {
    controls.update(1 / 60);
    controls.follow(1 / 60);
  }
}

/** A finger on a page 400 pixels wide. */
function finger(page: ReturnType<typeof controlledPage>, pointerId: number) {
  return (type: 'pointerdown' | 'pointermove' | 'pointerup', clientX = 0, clientY = 0) =>
    page.pointer(type, clientX, { pointerId, clientY, pointerType: 'touch' });
}

describe('CharacterControls: fingers', () => {
  it('should walk by a stick under the thumb, as fast as it is pushed', () => {
    const page = controlledPage();
    const { controls, character } = page;
    const thumb = finger(page, 7);
    thumb('pointerdown', 80, 200);
    expect(controls.stick).toMatchObject({ active: true, originX: 80, originY: 200, x: 0, y: 0 });
    thumb('pointermove', 80, 200 - 0.575 * controls.stick.radius); // half-way, past the rest zone
    run(controls);
    expect(character.walked.z).toBeCloseTo(-1.5, 6);
    thumb('pointermove', 80 + controls.stick.radius, 200);
    run(controls);
    expect(character.walked.toArray()).toEqual([3, 0, 0].map((x) => expect.closeTo(x, 6)));
    thumb('pointermove', 80 + 1.5 * controls.stick.radius, 200);
    run(controls);
    expect(character.walked.x).toBeCloseTo(6, 6);
    thumb('pointerup');
    run(controls);
    expect(character.walked.length()).toBe(0);
    expect(controls.stick.active).toBe(false);
    expect(controls.yaw).toBe(0);
  });

  it('should stand still under a resting thumb, and turn round at once where it went far', () => {
    const page = controlledPage();
    const { controls, character } = page;
    const thumb = finger(page, 1);
    thumb('pointerdown', 100, 100);
    thumb('pointermove', 105, 100);
    run(controls);
    expect(character.walk).not.toHaveBeenCalled();
    thumb('pointermove', 250, 100);
    thumb('pointermove', 100, 100); // as far back as it went forth
    run(controls);
    expect(character.walked.x).toBeLessThan(0);
  });

  it('should look with a finger in the right half, while the thumb walks', () => {
    const page = controlledPage();
    const { controls, character } = page;
    const [thumb, other] = [finger(page, 1), finger(page, 2)];
    thumb('pointerdown', 50, 200);
    thumb('pointermove', 50, 140);
    other('pointerdown', 300, 100);
    other('pointermove', 350, 80);
    expect(controls.yaw).toBeCloseTo(-0.3, 9);
    expect(controls.pitch).toBeCloseTo(0.12, 9);
    run(controls);
    expect(character.walked.length()).toBeCloseTo(3, 6);
    other('pointerup');
    other('pointermove', 200, 80);
    expect(controls.yaw).toBeCloseTo(-0.3, 9);
  });

  it('should zoom by two fingers, and not turn meanwhile', () => {
    const page = controlledPage({ view: 'third' });
    const { controls } = page;
    const [a, b] = [finger(page, 1), finger(page, 2)];
    a('pointerdown', 250, 100);
    b('pointerdown', 350, 100);
    b('pointermove', 300, 100);
    expect(controls.distance).toBeCloseTo(7, 9); // half as far apart: twice as far away, which is more than 7
    b('pointermove', 390, 100);
    expect(controls.distance).toBeCloseTo((7 * 50) / 140, 9);
    expect(controls.yaw).toBe(0);
    a('pointerup');
    b('pointermove', 290, 100);
    expect(controls.yaw).toBeCloseTo(0.6, 9);
  });

  it('should look everywhere where no stick is wanted', () => {
    const page = controlledPage({ touchStick: false, touchSensitivity: 0.01 });
    const any = finger(page, 1);
    any('pointerdown', 20, 0);
    any('pointermove', 30, 0);
    expect(page.controls.yaw).toBeCloseTo(-0.1, 9);
    expect(page.controls.stick.active).toBe(false);
  });

  it('should leave gestures to nobody else while it listens', () => {
    const { controls, element } = controlledPage();
    expect(element.style.touchAction).toBe('none');
    controls.dispose();
    expect(element.style.touchAction).toBe('');
  });
});

/** A gamepad of the standard mapping at rest. */
function gamepad() {
  return {
    mapping: 'standard',
    axes: [0, 0, 0, 0],
    buttons: Array.from({ length: 17 }, () => ({ pressed: false })),
  };
}

function withGamepad(options = {}) {
  const page = controlledPage(options);
  const pad = gamepad();
  page.defaultView.navigator.pads = [null, pad];
  page.send(page.defaultView, 'gamepadconnected');
  run(page.controls, 0.1);
  const press = (button: number, pressed = true) => (pad.buttons[button]!.pressed = pressed);
  return { ...page, pad, press };
}

describe('CharacterControls: gamepads', () => {
  it('should walk by the left stick, as fast as it is tilted, from the dead zone on', () => {
    const { controls, character, pad } = withGamepad();
    pad.axes = [0.1, -0.1, 0, 0];
    run(controls);
    expect(character.walk).not.toHaveBeenCalled();
    pad.axes = [0, -0.575, 0, 0];
    run(controls);
    expect(character.walked.z).toBeCloseTo(-1.5, 6);
    pad.axes = [0.9, 0.9, 0, 0]; // corners are no faster
    run(controls);
    expect(character.walked.length()).toBeCloseTo(3, 6);
  });

  it('should look by the right stick, so many radians a second', () => {
    const { controls, pad } = withGamepad();
    pad.axes = [0, 0, 1, 0];
    run(controls, 0.5);
    expect(controls.yaw).toBeCloseTo(-1.5, 6);
    pad.axes = [0, 0, 0, -1];
    run(controls, 0.25);
    expect(controls.pitch).toBeCloseTo(0.75, 6);
    pad.axes = [0, 0, 0.575, 0]; // half-way: a quarter as fast
    run(controls, 1);
    expect(controls.yaw).toBeCloseTo(-2.25, 6);
  });

  it('should jump, crouch, run and switch the view by its buttons, each press once', () => {
    const { controls, character, pad, press } = withGamepad();
    const changed = vi.fn();
    controls.addEventListener('change', changed);
    press(0);
    press(3);
    run(controls, 0.2);
    expect(character.jump).toHaveBeenCalledTimes(1);
    expect(controls.view).toBe('third');
    expect(changed).toHaveBeenCalledTimes(1);
    press(4);
    pad.axes = [0, -1, 0, 0];
    run(controls);
    expect(character.walked.length()).toBeCloseTo(6, 6);
    press(1);
    run(controls, 0.1);
    expect(character.crouched).toBe(true);
    press(1, false);
    run(controls, 0.1);
    expect(character.crouched).toBe(false);
  });

  it('should walk by its cross, and take other buttons', () => {
    const { controls, character, press } = withGamepad({ buttons: { jump: [2] } });
    press(14);
    press(0);
    run(controls);
    expect(character.walked.x).toBeCloseTo(-3, 6);
    expect(character.jump).not.toHaveBeenCalled();
    press(2);
    run(controls, 0.1);
    expect(character.jump).toHaveBeenCalledTimes(1);
  });

  it('should forget what was held when the focus was lost, until it was let go', () => {
    const { controls, character, defaultView, pad, press, send } = withGamepad();
    pad.axes = [0, -1, 0, 0];
    press(0);
    run(controls);
    send(defaultView, 'blur');
    run(controls);
    expect(character.walked.length()).toBe(0);
    expect(character.jump).toHaveBeenCalledTimes(1);
    pad.axes = [0, 0, 0, 0];
    press(0, false);
    run(controls, 0.1);
    pad.axes = [0, -1, 0, 0];
    press(0);
    run(controls);
    expect(character.walked.length()).toBeCloseTo(3, 6);
    expect(character.jump).toHaveBeenCalledTimes(2);
  });

  it('should stop when it is pulled out, and not mind one of another mapping', () => {
    const { controls, character, defaultView, pad, send } = withGamepad();
    pad.axes = [0, -1, 0, 0];
    run(controls);
    defaultView.navigator.pads = [null, null];
    send(defaultView, 'gamepaddisconnected');
    run(controls);
    expect(character.walked.length()).toBe(0);
    defaultView.navigator.pads = [{ ...gamepad(), mapping: '', axes: [1] }];
    send(defaultView, 'gamepadconnected');
    run(controls);
    expect(character.walked.length()).toBe(0);
  });
});

describe('CharacterControls: keys and buttons of the page', () => {
  it('should turn by the arrows if asked to, so that they alone suffice', () => {
    const { controls, character, key } = controlledPage({ turnKeys: true });
    key('keydown', 'ArrowLeft');
    run(controls, 0.5);
    expect(controls.yaw).toBeCloseTo(1, 6);
    expect(character.walk).not.toHaveBeenCalled();
    key('keyup', 'ArrowLeft');
    key('keydown', 'ArrowUp');
    key('keydown', 'KeyD'); // goes aside as ever
    run(controls);
    expect(controls.yaw).toBeCloseTo(1, 6);
    expect(character.walked.length()).toBeCloseTo(3, 6);
    controls.turnKeys = false;
    key('keyup', 'KeyD');
    key('keyup', 'ArrowUp');
    key('keydown', 'ArrowLeft');
    controls.yaw = 0;
    run(controls);
    expect(character.walked.x).toBeCloseTo(-3, 6);
    expect(controls.yaw).toBe(0);
  });

  it('should run on and off by a press if asked to', () => {
    const { controls, character, key } = controlledPage({ toggleRun: true });
    key('keydown', 'KeyW');
    for (const speed of [6, 3, 6]) {
      key('keydown', 'ShiftLeft');
      key('keyup', 'ShiftLeft');
      run(controls);
      expect(character.walked.length()).toBeCloseTo(speed, 6);
    }
  });

  it('should look the other way round up and down if asked to', () => {
    const { controls, pointer } = controlledPage({ invertY: true });
    pointer('pointerdown', 0);
    pointer('pointermove', 10, { clientY: 100 });
    expect(controls.pitch).toBeCloseTo(0.2, 9);
    expect(controls.yaw).toBeCloseTo(-0.02, 9);
  });

  it('should take presses from the page', () => {
    const { controls, character } = controlledPage();
    controls.press('jump');
    controls.press('crouch');
    run(controls, 0.1);
    expect(character.jump).toHaveBeenCalledTimes(1);
    expect(character.crouched).toBe(true);
    controls.release('crouch');
    controls.press('view');
    run(controls, 0.1);
    expect(character.crouched).toBe(false);
    expect(controls.view).toBe('third');
    controls.enabled = false;
    controls.press('jump');
    controls.enabled = true;
    run(controls, 0.1);
    expect(character.jump).toHaveBeenCalledTimes(1);
  });

  it('should let go of thumb, finger and buttons with the focus', () => {
    const page = controlledPage();
    const { controls, character, defaultView, send } = page;
    const [thumb, other] = [finger(page, 1), finger(page, 2)];
    thumb('pointerdown', 50, 200);
    thumb('pointermove', 50, 100);
    other('pointerdown', 300, 100);
    controls.press('crouch');
    run(controls);
    send(defaultView, 'blur');
    run(controls);
    expect(character.walked.length()).toBe(0);
    expect(character.crouched).toBe(false);
    thumb('pointermove', 50, 90);
    other('pointermove', 390, 100);
    run(controls);
    expect(character.walked.length()).toBe(0);
    expect(controls.yaw).toBe(0);
  });

  it('should say what it wants of a boom and a dead zone', () => {
    expect(() => controlledPage({ boom: {} as never })).toThrow(/CharacterControls: "boom"/);
    expect(() => controlledPage({ deadZone: 1 })).toThrow(RangeError);
  });

  it('should make no object in a frame', () => {
    const { controls, character, key, pad } = withGamepad({ view: 'third' });
    character.walk = (() => {}) as never;
    key('keydown', 'KeyW');
    pad.axes = [0.5, 0.5, 0.3, 0.3];
    const each = bytesEach(5_000, () => {
      controls.update(1 / 60);
      controls.follow(1 / 60);
    });
    // Numbers that V8 wraps, 16 bytes each; a Vector3 is 48 and more.
    expect(each).toBeLessThan(200);
  });
});
