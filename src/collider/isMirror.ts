/** Objects whose own hook renders the scene once more, into a texture of theirs. */
const MIRRORS = ['isReflector', 'isRefractor', 'isWater'] as const;

/** Is its `onBeforeRender` not to be called for a cubemap? */
export function isMirror(object: object): boolean {
  return MIRRORS.some((flag) => (object as Record<string, unknown>)[flag] === true);
}
