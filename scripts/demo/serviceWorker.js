// Built into sw.js by offline.mjs, which puts the two names below in place.
/* global PRECACHE_VERSION, PRECACHE_FILES */

const NAME = 'three-cube-collider ';
const KEPT = NAME + PRECACHE_VERSION;
/** What was asked for besides: rivals, decoders, levels, the page that measures. */
const VISITED = NAME + 'visited';

self.addEventListener('install', (event) => {
  event.waitUntil(
    caches
      .open(KEPT)
      // Asked anew, for a file may have changed under its name; what did not costs no bytes.
      .then((cache) =>
        cache.addAll(PRECACHE_FILES.map((url) => new Request(url, { cache: 'no-cache' }))),
      ),
  );
});

self.addEventListener('activate', (event) => {
  const old = (name) => name.startsWith(NAME) && name !== KEPT;
  event.waitUntil(
    caches
      .keys()
      .then((names) => Promise.all(names.filter(old).map((name) => caches.delete(name))))
      .then(() => self.clients.claim()),
  );
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const url = new URL(request.url);
  if (request.method !== 'GET' || !url.href.startsWith(self.registration.scope)) return;
  event.respondWith(answer(request, url));
});

// What the page asked for before this worker answered.
self.addEventListener('message', (event) => {
  event.waitUntil(Promise.all(event.data.map(keep)));
});

async function keep(address) {
  const url = new URL(address);
  url.search = '';
  if (!url.href.startsWith(self.registration.scope) || (await caches.match(url))) return;
  // A file that is not there, or a network gone meanwhile, is no fault of this worker.
  await (await caches.open(VISITED)).add(url).catch(() => undefined);
}

async function answer(request, url) {
  // A folder is its page, and the page is one whatever is asked of it.
  url.search = '';
  if (url.pathname.endsWith('/')) url.pathname += 'index.html';
  const kept = await (await caches.open(KEPT)).match(url);
  if (kept) return kept;
  const visited = await caches.open(VISITED);
  try {
    const response = await fetch(request);
    if (response.ok) await visited.put(url, response.clone());
    return response;
  } catch (error) {
    const last = await visited.match(url);
    if (last) return last;
    throw error;
  }
}
