import type { Suite, SuiteOptions, SuiteRow } from './suite.js';

/** The page's side of `list.mjs`: runs the suite of that name; what it tells goes to the console, as information. */
export default async function inPage(request: {
  suite: string;
  options: SuiteOptions;
}): Promise<SuiteRow[]> {
  const url = `/bench/suites/${request.suite}.ts`;
  const { default: run } = (await import(/* @vite-ignore */ url)) as { default: Suite };
  return run(request.options, (line) => console.info(line));
}
