// Monkey test of the built page:
// node tests/e2e/monkey.mjs [--runs N] [--actions MAX] [--seed S] [--path P] [--replay R]
// On two cores, two lanes share the runs. fast-check shrinks a failure and prints the seed, path and replay path that
// reproduce it.
import { availableParallelism } from "node:os";
import { parseArgs } from "node:util";
import fc from "fast-check";
import { action } from "./monkey/actions.mjs";
import { Visit } from "./monkey/visit.mjs";
import { portraitVideo } from "./pictures.mjs";
import { DIST, serve } from "./server.mjs";

const SHRINKING_MS = 300_000;

/**
 * `actions` is the maximum per run.
 *
 * @typedef {{ runs: number, actions: number, seed: number, path?: string, replay?: string }} Amount
 */

/** @param {Amount} amount @returns {Promise<number>} number of actions performed */
export async function monkeyTest({ runs, actions, seed, path, replay }) {
  const server = await serve(DIST, "/some/where/");
  const video = await portraitVideo();
  let done = 0;
  let shrinkingEnds = Number.POSITIVE_INFINITY;
  const commands = fc.commands([action], { maxCommands: actions, size: "max", replayPath: replay });
  const property = fc.asyncProperty(commands, async (commands) => {
    if (performance.now() > shrinkingEnds) return;
    const visit = await Visit.start(server.url, video);
    try {
      await fc.asyncModelRun(() => ({ model: visit, real: visit }), commands);
      await visit.look(3);
    } catch (error) {
      shrinkingEnds = Math.min(shrinkingEnds, performance.now() + SHRINKING_MS);
      throw error;
    } finally {
      done += visit.done;
      await visit.page.context().browser().close();
    }
  });
  await fc.assert(property, { numRuns: runs, seed, path, unbiased: true }).finally(() => server.close());
  return done;
}

if (process.argv[1] === import.meta.filename) {
  const text = (standard) => ({ type: /** @type {const} */ ("string"), default: standard });
  const options = { runs: text("100"), actions: text("250"), seed: text("1"), path: text(), replay: text() };
  const { runs, actions, seed, ...again } = parseArgs({ options }).values;
  const lanes = again.path ? 1 : Math.min(2, availableParallelism());
  const amount = { runs: Math.ceil(Number(runs) / lanes), actions: Number(actions), ...again };
  const ended = await Promise.allSettled(Array.from({ length: lanes }, (_, lane) => monkeyTest({ ...amount, seed: Number(seed) + lane })));
  for (const { value, reason } of ended) console.log(reason ?? `${value} actions, nothing found`);
  process.exitCode = ended.some(({ reason }) => reason) ? 1 : 0;
}
