import { defineConfig } from 'vitest/config';
import { alias } from './vite.config.js';

export default defineConfig({
  resolve: { alias },
  test: {
    include: ['test/**/*.test.ts'],
    environment: 'node',
    testTimeout: process.env.SOAK === '1' ? 3_600_000 : 120_000,
    // All cores: nothing else runs meanwhile.
    maxWorkers: '100%',
  },
});
