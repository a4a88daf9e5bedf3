/** Whether the long run was asked for: `SOAK=1 npx vitest run test/character/slide`. */
export const SOAK = process.env.SOAK === '1';

/** How many tries: the usual number, or the long run's. */
export const tries = (usual: number, soak: number): number => (SOAK ? soak : usual);
