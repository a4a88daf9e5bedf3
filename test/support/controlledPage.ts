import { Object3D, PerspectiveCamera, Vector3 } from 'three';
import { vi } from 'vitest';
import { CharacterControls } from '../../src/controls/CharacterControls.js';
import type { CharacterControlsOptions } from '../../src/controls/controlsOptions.js';

/** An event target that knows the listeners it has. */
class Heard extends EventTarget {
  readonly heard = new Map<unknown, string>();

  override addEventListener(...args: Parameters<EventTarget['addEventListener']>): void {
    this.heard.set(args[1], args[0]);
    super.addEventListener(...args);
  }

  override removeEventListener(...args: Parameters<EventTarget['removeEventListener']>): void {
    if (this.heard.get(args[1]) === args[0]) this.heard.delete(args[1]);
    super.removeEventListener(...args);
  }
}

/** A document, its window and a canvas, as far as controls look at them. */
function makePage() {
  const defaultView = Object.assign(new Heard(), {
    navigator: { pads: [] as unknown[], getGamepads: () => defaultView.navigator.pads },
  });
  const document = Object.assign(new Heard(), {
    defaultView,
    pointerLockElement: null as unknown,
    exitPointerLock() {
      document.pointerLockElement = null;
      document.dispatchEvent(new Event('pointerlockchange'));
    },
  });
  const element = Object.assign(new Heard(), {
    ownerDocument: document,
    style: { touchAction: '' },
    /** 400 pixels wide: a finger walks up to x = 200. */
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 400, height: 300 }),
    /** Raw mouse travel is not to be had. */
    noRaw: false,
    /** No capture is to be had at all. */
    refuses: false,
    requestPointerLock({ unadjustedMovement = false } = {}) {
      if (element.refuses) return Promise.reject(new DOMException('no', 'NotAllowedError'));
      if (element.noRaw && unadjustedMovement) {
        return Promise.reject(new DOMException('no', 'NotSupportedError'));
      }
      document.pointerLockElement = element;
      document.dispatchEvent(new Event('pointerlockchange'));
      return Promise.resolve();
    },
  });
  return { defaultView, document, element };
}

/** Controls of a character on such a page, and the hands of its user. */
export function controlledPage(
  options: CharacterControlsOptions = {},
  camera = new PerspectiveCamera(),
) {
  const page = makePage();
  const character = {
    position: new Vector3(),
    velocity: new Vector3(),
    grounded: true,
    avatar: new Object3D(),
    walked: new Vector3(),
    walk: vi.fn((velocity: Vector3) => void character.walked.copy(velocity)),
    jump: vi.fn(),
    crouched: false,
    crouch: (on: boolean) => void (character.crouched = on),
  };
  const controls = new CharacterControls(
    character,
    camera,
    page.element as unknown as HTMLElement,
    options,
  );
  const send = (to: EventTarget, type: string, fields: object = {}): Event => {
    const event = Object.assign(new Event(type, { cancelable: true }), fields);
    // Node's `Event` has a read-only target; a page's key comes from the focused element.
    if ('from' in fields) Object.defineProperty(event, 'target', { value: fields.from });
    to.dispatchEvent(event);
    return event;
  };
  const key = (type: 'keydown' | 'keyup', code: string, fields: object = {}) =>
    send(page.document, type, { code, ...fields });
  const pointer = (type: string, clientX = 0, fields: object = {}) =>
    send(page.element, type, { pointerId: 1, clientX, clientY: 0, ...fields });
  return { ...page, character, camera, controls, send, key, pointer };
}
