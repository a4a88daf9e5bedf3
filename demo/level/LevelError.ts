/** Why a level cannot be walked in, and what to do: sentences to show as they are. */
export class LevelError extends Error {
  override readonly name = 'LevelError';
}
