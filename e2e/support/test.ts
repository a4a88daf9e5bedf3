import {
  expect,
  test as base,
  type BrowserContext,
  type ConsoleMessage,
  type Page,
  type WebError,
} from '@playwright/test';

export { expect };

interface Options {
  /**
   * Messages of the page that a test expects, and that therefore do not fail it. Two or more need Playwright's long
   * form, since it takes a list of two for a value and its settings: `[[/one/, /two/], { scope: 'test' }]`.
   */
  allowedMessages: RegExp[];
}

interface Fixtures {
  /** What the page has complained of so far; a test fails if any is left at its end. */
  complaints: string[];
}

/** Warnings that are errors to us: Chromium's own about WebGL, and three's about a second copy of three. */
const FATAL_WARNING =
  /GL_INVALID|GL_OUT_OF_MEMORY|WebGL: (INVALID|OUT_OF_MEMORY|too many errors)|Multiple instances of Three\.js/;

/**
 * Playwright's `test`, which also fails when the page logs an error, throws one that nobody catches, or misuses
 * WebGL. It watches every page of the test's own browser context.
 */
export const test = base.extend<Options & Fixtures>({
  allowedMessages: [[], { option: true }],
  // It asks for `page` so as to end before the page does: the page's contexts must still tell their errors.
  complaints: [
    async ({ page, context, allowedMessages }, use) => {
      if (!Array.isArray(allowedMessages)) {
        throw new TypeError('allowedMessages: write [[/one/, /two/], { scope: "test" }].');
      }
      const complaints: string[] = [];
      const report = (complaint: string) => {
        if (!allowedMessages.some((allowed) => allowed.test(complaint))) complaints.push(complaint);
      };
      const onConsole = (message: ConsoleMessage) => {
        const text = message.text();
        if (message.type() === 'error' || FATAL_WARNING.test(text)) {
          report(`console.${message.type()}: ${text}`);
        }
      };
      const onError = (error: WebError) =>
        report(`uncaught: ${error.error().stack ?? error.error()}`);
      const onCrash = () => report('the page crashed');
      context.on('console', onConsole);
      context.on('weberror', onError);
      page.on('crash', onCrash);
      if (!shared.has(page)) await context.addInitScript(rememberContexts);

      await use(complaints);

      for (const error of await pendingErrors(context)) report(error);
      // A shared page goes on to the next test.
      context.off('console', onConsole);
      context.off('weberror', onError);
      page.off('crash', onCrash);
      expect(complaints, 'what the page complained of').toEqual([]);
    },
    { auto: true },
  ],
});

/** Pages that many tests share. */
const shared = new WeakSet<Page>();

/**
 * The same, on one page that all these tests share, which saves each the opening of a page and the loading of three: for
 * tests that do nothing but `runInPage`, with modules that leave nothing behind. Each loses its WebGL contexts at its
 * end; after a test that fails, Playwright begins anew with a page of its own.
 */
export const testOnOnePage = test.extend<object, { sharedPage: Page }>({
  sharedPage: [
    async ({ browser }, use, { project }) => {
      const { baseURL, viewport, deviceScaleFactor } = project.use;
      const context = await browser.newContext({ baseURL, viewport, deviceScaleFactor });
      await context.addInitScript(rememberContexts);
      const page = await context.newPage();
      shared.add(page);
      await use(page);
      await context.close();
    },
    { scope: 'worker' },
  ],
  context: ({ sharedPage }, use) => use(sharedPage.context()),
  page: async ({ sharedPage }, use) => {
    await use(sharedPage);
    await sharedPage.evaluate(() => {
      for (const reference of window.testContexts ?? []) {
        reference.deref()?.getExtension('WEBGL_lose_context')?.loseContext();
      }
      window.testContexts = [];
    });
  },
});

declare global {
  interface Window {
    /** Every WebGL context that this document has made; weakly, so that the page may still drop them. */
    testContexts?: WeakRef<WebGLRenderingContext>[];
  }
}

/** Runs in the page, before any of its scripts. */
function rememberContexts(): void {
  window.testContexts = [];
  for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
    const getContext = prototype.getContext as (...args: unknown[]) => unknown;
    Object.assign(prototype, {
      getContext(this: unknown, ...args: unknown[]) {
        const context = getContext.apply(this, args);
        const contexts = window.testContexts!;
        const known = contexts.some((reference) => reference.deref() === context);
        if (context && 'getError' in (context as object) && !known) {
          contexts.push(new WeakRef(context as WebGLRenderingContext));
        }
        return context;
      },
    });
  }
}

/** What `getError` still says in any context of any open page. */
async function pendingErrors(context: BrowserContext): Promise<string[]> {
  const frames = context.pages().flatMap((page) => page.frames());
  const errors = await Promise.all(
    frames.map((frame) =>
      frame
        .evaluate(() =>
          (window.testContexts ?? []).flatMap((reference) => {
            const gl = reference.deref();
            // A lost context says so once, and has nothing else to tell.
            if (!gl || gl.isContextLost()) return [];
            const code = gl.getError();
            return code === gl.NO_ERROR ? [] : [`getError() is 0x${code.toString(16)}`];
          }),
        )
        // The page was closed, or crashed, which is reported on its own.
        .catch(() => []),
    ),
  );
  return errors.flat();
}

/**
 * Opens an empty page (a shared one only once), imports a module there, calls its default export, and returns what that
 * resolves with.
 *
 * @param url the module from the root of the repository: `/e2e/harness/readback.ts`
 * @param args handed to the function; they and the result go through JSON
 */
export async function runInPage<Result = unknown>(
  page: Page,
  url: string,
  args?: unknown,
): Promise<Result> {
  const address = '/e2e/harness/index.html';
  if (!shared.has(page) || !page.url().endsWith(address)) await page.goto(address);
  return page.evaluate(
    async ([url, args]) => (await import(/* @vite-ignore */ url)).default(args),
    [url, args] as [string, unknown],
  );
}
