/** The element of that id; index.html has it. */
export function element<E extends HTMLElement>(id: string): E {
  return document.getElementById(id) as E;
}

/** Tells a screen reader what changed, once it has said what it is saying. */
export function announce(text: string): void {
  element('told').textContent = text;
}

/** Whether there is a mouse to look with. */
export const hasMouse = () => window.matchMedia('(pointer: fine)').matches;

/** Tells whether the user asked their system for less motion: now, and whenever that changes. */
export function onReducedMotion(listener: (reduced: boolean) => void): void {
  const query = window.matchMedia('(prefers-reduced-motion: reduce)');
  query.addEventListener('change', () => listener(query.matches));
  listener(query.matches);
}
