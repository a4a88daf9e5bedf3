/** Lets a service worker keep the built page, once it has loaded: the next visit needs no network. */
export function keepForOffline(): void {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  window.addEventListener('load', () => {
    // Refused, as in some private windows: the page works without.
    navigator.serviceWorker.register(`${import.meta.env.BASE_URL}sw.js`).catch(console.warn);
    // What was asked for before it listened: another renderer, another level.
    void navigator.serviceWorker.ready.then(({ active }) => {
      active?.postMessage(performance.getEntriesByType('resource').map(({ name }) => name));
    });
  });
}
