import { defineConfig } from 'vitest/config';
import { alias } from './vite.config.js';

export default defineConfig({
  resolve: { alias },
  test: {
    include: ['test/**/*.test.ts'],
    environment: 'node',
    testTimeout: 120_000,
    // All cores: nothing else runs meanwhile.
    maxWorkers: '100%',
  },
});
