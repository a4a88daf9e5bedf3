import { ready } from './RapierWalker.js';

let memory: Promise<WebAssembly.Memory | null> | null = null;

/** Rapier's WebAssembly, loaded; and its memory, or null where another has loaded it before. */
export function rapierMemory(): Promise<WebAssembly.Memory | null> {
  return (memory ??= loadRapier().catch((error: unknown) => {
    memory = null; // to be tried again
    throw error;
  }));
}

async function loadRapier(): Promise<WebAssembly.Memory | null> {
  const { instantiate } = WebAssembly;
  let found: WebAssembly.Memory | null = null;
  const watched = async (...args: Parameters<typeof instantiate>) => {
    const result = (await instantiate(...args)) as object;
    const { exports } =
      'instance' in result
        ? (result.instance as WebAssembly.Instance)
        : (result as WebAssembly.Instance);
    found ??= exports.memory instanceof WebAssembly.Memory ? exports.memory : null;
    return result;
  };
  WebAssembly.instantiate = watched as typeof instantiate;
  try {
    await ready();
  } finally {
    WebAssembly.instantiate = instantiate;
  }
  return found;
}
