// Monkey test of the built page:
// node tests/e2e/monkey.mjs [--actions TOTAL] [--length MOST] [--visitor KIND] [--seed S] [--path P] [--replay R]
// Each kind of visitor performs TOTAL actions, at most MOST in a visit; the kinds run side by side. fast-check shrinks a
// failure and prints the seed, path and replay path that reproduce it with its `--visitor`.
import { parseArgs } from "node:util";
import fc from "fast-check";
import { action } from "./monkey/actions.mjs";
import { KINDS, Visit } from "./monkey/visit.mjs";
import { portraitVideo } from "./pictures.mjs";
import { DIST, serve } from "./server.mjs";

const SHRINKING_MS = 300_000;
/** Less than the mean length of a visit, so that the visits suffice. */
const LEAST_PER_VISIT = 10;

const text = (/** @type {string=} */ standard) => ({ type: /** @type {const} */ ("string"), default: standard });
const options = { actions: text("500"), length: text("250"), visitor: text(), seed: text("1"), path: text(), replay: text() };
const { actions, length, visitor, seed, path, replay } = parseArgs({ options }).values;
const server = await serve(DIST, "/some/where/");
const video = await portraitVideo();
const kinds = Object.keys(KINDS).filter((kind) => visitor === undefined || kind === visitor);
const ended = await Promise.allSettled(kinds.map(monkeyTest));
server.close();
// A separate argument, so that the cause of an error is printed.
for (const [at, { value, reason }] of ended.entries()) console.log(`${kinds[at]}:`, reason ?? `${value} actions, nothing found`);
process.exitCode = kinds.length === 0 || ended.some(({ reason }) => reason) ? 1 : 0;

/** @param {string} kind of visitor @returns {Promise<number>} number of actions performed */
async function monkeyTest(kind) {
  let [done, shown, shrinkingEnds] = [0, 0, Number.POSITIVE_INFINITY];
  const commands = fc.commands([action], { maxCommands: Number(length), size: "max", replayPath: replay });
  const property = fc.asyncProperty(commands, async (commands) => {
    if (done >= Number(actions) || performance.now() > shrinkingEnds) return;
    const visit = await Visit.start(server.url, video, kind);
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
    if (done < shown + 100) return;
    shown = done;
    console.log(`${kind}: ${done} actions`);
  });
  const numRuns = Math.ceil(Number(actions) / LEAST_PER_VISIT);
  await fc.assert(property, { numRuns, seed: Number(seed), path, unbiased: true });
  return done;
}
