import { test as base } from "@playwright/test";
import { Browsers, kindFor } from "./browsers.mjs";
import { DIST, serve } from "./server.mjs";
import { storedProject } from "./stored-project.mjs";
import { Visitor } from "./visitor.mjs";

/** Path prefix, as on hosts that serve the page below the root. */
const BELOW = "/some/where/";

/**
 * Tests of the page. Tags choose the browser: `@eyes` (screenshots show the 3D view), `@webgl`, `@no-gpu`, `@camera`,
 * `@moving-camera` (plays the video of video-frames.mjs), `@seen-camera` (both `@eyes` and `@moving-camera`),
 * `@way-back` (with back/forward cache). The gate runs `@usual` tests, the night the others.
 */
export const test = base.extend({
  /** Browsers of this worker, launched when a test needs them. */
  browsers: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the dependencies here
    async ({}, use) => {
      const browsers = new Browsers();
      await use(browsers);
      await browsers.close();
    },
    { scope: "worker" },
  ],

  /** The sample portrait as a project. */
  project: [
    async ({ browsers }, use) => use(await storedProject(() => browsers.get("gpu"))),
    { scope: "worker", timeout: 60_000 },
  ],

  /** Server of the built page. */
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the dependencies here
  server: async ({}, use) => {
    const server = await serve(DIST, BELOW);
    await use(server);
    server.close();
  },

  /** Options of {@link Visitor.open}, and an optional `url`. */
  visit: [{}, { option: true }],

  /** Opens the page in a new browser context. */
  open: async ({ browsers, project, server, visit }, use, testInfo) => {
    const kind = kindFor(testInfo.tags);
    /** @type {Visitor[]} */
    const visitors = [];
    await use(async (options) => {
      const { url = server.url, ...visiting } = { ...visit, ...options };
      const visitor = await Visitor.open(await browsers.get(kind), url, visiting);
      Object.assign(visitor, { project, showsView: browsers.showsView(kind) });
      visitors.push(visitor);
      return visitor;
    });
    const hasFailed = testInfo.status !== testInfo.expectedStatus || visitors.some(({ errors }) => errors.length > 0);
    try {
      for (const visitor of visitors) visitor.assertNoErrors();
    } finally {
      if (hasFailed) await attachConsoles(visitors, testInfo);
      for (const visitor of visitors) await browsers.release(visitor);
    }
  },

  visitor: async ({ open }, use) => use(await open()),

  page: async ({ visitor }, use) => use(visitor.page),

  /** The visitor, with the sample portrait open. */
  editor: async ({ visitor }, use) => {
    await visitor.openFace();
    await use(visitor);
  },
});

/**
 * Pairs similar cases with tags: the first one is usual, the others are rare.
 *
 * @template T
 * @param {readonly T[]} cases
 * @returns {[T, string[]][]}
 */
export function variants(cases) {
  return cases.map((one, place) => [one, place === 0 ? ["@usual"] : []]);
}

/** @param {Visitor[]} visitors @param {import("@playwright/test").TestInfo} testInfo */
async function attachConsoles(visitors, testInfo) {
  for (const { consoleLines, browserLines } of visitors) {
    const lines = [...consoleLines.map((line) => `page: ${line}`), ...browserLines.map((line) => `browser: ${line}`)];
    await testInfo.attach("console", { body: lines.join("\n"), contentType: "text/plain" });
  }
}
