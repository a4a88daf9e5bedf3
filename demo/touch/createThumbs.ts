import type { ButtonAction, CharacterControls } from 'three-cube-collider';
import './touch.css';

/** Where the stick waits for a thumb, CSS pixels from the left and from the bottom. */
const REST = { left: 92, bottom: 104 };

export interface Thumbs {
  /** Draws the stick where the thumb is: once a frame. */
  update(): void;
}

/** What fingers need over the picture: a drawing of the stick, and buttons to jump and crouch. */
export function createThumbs(controls: CharacterControls): Thumbs {
  const root = document.createElement('div');
  root.className = 'thumbs';
  root.innerHTML = `
    <div class="stick"><div class="knob"></div></div>
    <button type="button" class="crouch" aria-label="Crouch">
      <svg viewBox="0 0 24 24" aria-hidden="true"><path d="M5 7l7 7 7-7M6 19h12" /></svg>
    </button>
    <button type="button" class="jump" aria-label="Jump">
      <svg viewBox="0 0 24 24" aria-hidden="true"><path d="M12 20V5M5 12l7-7 7 7" /></svg>
    </button>`;
  document.body.append(root);
  const stick = root.querySelector<HTMLElement>('.stick')!;
  const knob = root.querySelector<HTMLElement>('.knob')!;
  for (const action of ['jump', 'crouch'] as const) {
    hold(root.querySelector<HTMLButtonElement>(`.${action}`)!, action, controls);
  }
  let drawn = '';
  return {
    update() {
      const { active, originX, originY, radius, x, y, runs } = controls.stick;
      const left = active ? originX : REST.left;
      const top = active ? originY : window.innerHeight - REST.bottom;
      // The knob stays with the ring, however far the thumb goes.
      const part = Math.min(1, radius / Math.max(1e-6, Math.hypot(x, y)));
      const place = `translate(${left}px, ${top}px)`;
      const now = `${place} ${part * x} ${part * y} ${active} ${runs}`;
      if (now === drawn) return;
      drawn = now;
      stick.style.transform = place;
      stick.classList.toggle('held', active);
      stick.classList.toggle('runs', runs);
      knob.style.transform = `translate(${part * x}px, ${part * y}px)`;
    },
  };
}

/** A button that asks for an action as long as a finger is on it, or a key of the keyboard. */
function hold(button: HTMLButtonElement, action: ButtonAction, controls: CharacterControls): void {
  const press = () => {
    button.classList.add('pressed');
    controls.press(action);
  };
  const release = () => {
    button.classList.remove('pressed');
    controls.release(action);
  };
  button.addEventListener('pointerdown', (event) => {
    button.setPointerCapture(event.pointerId);
    press();
  });
  for (const end of ['pointerup', 'pointercancel', 'blur'] as const) {
    button.addEventListener(end, release);
  }
  // By a keyboard or a screen reader there is no pointer; a finger's click comes after its pointer.
  button.addEventListener('click', ({ detail }) => {
    if (detail !== 0) return;
    press();
    window.setTimeout(release, 300);
  });
  button.addEventListener('contextmenu', (event) => event.preventDefault());
}
