import { defineConfig } from 'vitest/config';

/** The tests of the packed package: `npm run test:package`, after a build. */
export default defineConfig({
  test: {
    include: ['consumers/**/*.test.ts'],
    environment: 'node',
    testTimeout: 120_000,
    hookTimeout: 60_000,
  },
});
