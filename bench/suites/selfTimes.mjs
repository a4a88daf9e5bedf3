// @ts-check
// Reads what the browser's sampling profiler saw: https://chromedevtools.github.io/devtools-protocol/tot/Profiler

/** @typedef {{ functionName: string, url: string }} CallFrame */
/** @typedef {{ id: number, callFrame: CallFrame, children?: number[] }} ProfileNode */
/** @typedef {{ nodes: ProfileNode[], samples: number[], timeDeltas: number[] }} CpuProfile */
/** @typedef {{ group: string, name: string, time: number }} Spent in one function itself, milliseconds */

const GPU = "calls of the GPU's interface";
const GARBAGE = 'collecting garbage';

/**
 * The time that each function itself took, of those that are ours, three's or the browser's at their call.
 *
 * @param {CpuProfile} profile
 * @param {ReadonlySet<string>} gpuCalls names of the functions of WebGL and WebGPU
 * @returns {Spent[]}
 */
export function selfTimes({ nodes, samples, timeDeltas }, gpuCalls) {
  /** @type {Map<number, ProfileNode>} */
  const parents = new Map();
  for (const node of nodes) for (const child of node.children ?? []) parents.set(child, node);
  /** @type {Map<number, number>} */
  const times = new Map();
  samples.forEach((id, i) => times.set(id, (times.get(id) ?? 0) + (timeDeltas[i] ?? 0) / 1000));

  /** @type {Map<string, Spent>} */
  const found = new Map();
  for (const node of nodes) {
    const time = times.get(node.id) ?? 0;
    const place = time > 0 ? placeOf(node, parents, gpuCalls) : undefined;
    if (place === undefined) continue;
    const key = `${place.group} ${place.name}`;
    const known = found.get(key);
    if (known) known.time += time;
    else found.set(key, { ...place, time });
  }
  return [...found.values()];
}

/**
 * @param {ProfileNode} node
 * @param {ReadonlyMap<number, ProfileNode>} parents
 * @param {ReadonlySet<string>} gpuCalls
 * @returns {{ group: string, name: string } | undefined} undefined for the bench and the page it runs in
 */
function placeOf(node, parents, gpuCalls) {
  const { functionName, url } = node.callFrame;
  if (functionName === '(garbage collector)') return { group: GARBAGE, name: GARBAGE };
  // What is built in counts for who called it, except what goes to the GPU.
  if (url === '') {
    if (gpuCalls.has(functionName)) return { group: GPU, name: functionName };
    const parent = parents.get(node.id);
    return parent && placeOf(parent, parents, gpuCalls);
  }
  const [, folder, file] = /\/src\/(?:(\w+)\/)?([^/?]+)\.ts/.exec(url) ?? [];
  const name = functionName || 'a function without a name';
  if (file) {
    const group = `three-cube-collider, src${folder ? `/${folder}` : ''}`;
    return { group, name: `${name}, src/${folder ? `${folder}/` : ''}${file}.ts` };
  }
  if (/\/three\b|three[._-]/.test(url)) return { group: 'three', name: `${name}, three` };
  return undefined;
}
