// @ts-check
// npm start [-- any option of Vite, such as --host or --port 8080]
import { install } from './install.mjs';
import { main, root } from './run.mjs';

await main(install);

// Whoever ends npm by a signal ends npm's shell, which tells nobody: notice that it is gone, or the server would stay.
if (process.env.npm_lifecycle_event) {
  const shell = process.ppid;
  setInterval(() => process.ppid === shell || process.exit(), 500).unref();
}

// Vite in this very process, which reads the options itself: signals and the exit code are then Vite's own.
process.chdir(root);
// @ts-expect-error: a program, not a module with types
await import('../node_modules/vite/bin/vite.js');
