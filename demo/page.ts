/** The element of that id; index.html has it. */
export function element<E extends HTMLElement>(id: string): E {
  return document.getElementById(id) as E;
}

/** Tells a screen reader what changed, once it has said what it is saying. */
export function announce(text: string): void {
  element('told').textContent = text;
}

/** Seconds that a notice stays. */
const NOTICE = 4;
let noticed = 0;

/** Says something short in the picture, and to a screen reader; it goes by itself. */
export function notify(text: string): void {
  const notice = element('notice');
  window.clearTimeout(noticed);
  notice.textContent = text;
  notice.hidden = false;
  noticed = window.setTimeout(() => (notice.hidden = true), 1000 * NOTICE);
  announce(text);
}

/** Whether there is no room for two panels, as on a phone, upright or not. */
export const isSmall = () => window.matchMedia('(max-width: 720px), (max-height: 499px)').matches;

/** Whether there is a mouse to look with. */
export const hasMouse = () => window.matchMedia('(pointer: fine)').matches;

/** Tells whether the user asked their system for less motion: now, and whenever that changes. */
export function onReducedMotion(listener: (reduced: boolean) => void): void {
  const query = window.matchMedia('(prefers-reduced-motion: reduce)');
  query.addEventListener('change', () => listener(query.matches));
  listener(query.matches);
}
