/** Frames the picture for who came to it by Tab: who walks by keys without the mouse captured needs no frame around all. */
export function showFocus(): void {
  const tabbed = (on: boolean) => document.body.classList.toggle('tabbed', on);
  // Before a dialog keeps the key for itself.
  window.addEventListener('keydown', ({ code }) => code === 'Tab' && tabbed(true), true);
  window.addEventListener('pointerdown', () => tabbed(false));
}
