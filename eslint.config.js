import js from '@eslint/js';
import prettier from 'eslint-config-prettier';
import globals from 'globals';
import tseslint from 'typescript-eslint';

export default tseslint.config(
  {
    ignores: [
      'dist',
      'dist-demo',
      'public',
      'test-results',
      'playwright-report',
      'docs/api',
      '.cache',
    ],
  },
  js.configs.recommended,
  ...tseslint.configs.strict,
  prettier,
  {
    languageOptions: { globals: { ...globals.browser, ...globals.node } },
    rules: {
      eqeqeq: 'error',
      'prefer-const': 'error',
      // A `!` says "the layout guarantees this"; the alternative is a check in a hot loop.
      '@typescript-eslint/no-non-null-assertion': 'off',
    },
  },
  // The stages know only what lies before them (docs/architecture.md).
  ...[
    {
      files: ['src/cube/**', 'src/field/**', 'src/response/**'],
      away: ['collider', 'character', 'controls', 'helpers', 'react'],
    },
    { files: ['src/character/**'], away: ['collider', 'controls', 'helpers', 'react'] },
    { files: ['src/collider/**'], away: ['character', 'controls', 'helpers', 'react'] },
    { files: ['src/controls/**'], away: ['collider', 'helpers', 'react'] },
    {
      files: ['src/webgpu/*.ts'],
      ignores: ['src/webgpu/index.ts'],
      away: ['character', 'controls', 'helpers', 'react'],
      three: ['three/addons/*'],
    },
  ].map(({ files, ignores = [], away, three = ['three/*'] }) => ({
    ignores,
    files,
    rules: {
      'no-restricted-imports': [
        'error',
        {
          patterns: [...away.map((folder) => `**/${folder}/*`), ...three].map((group) => ({
            group: [group],
          })),
        },
      ],
    },
  })),
);
