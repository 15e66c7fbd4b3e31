// A long visit by somebody who does anything at random: node tests/journeys/restless.mjs [--actions N] [--seed S]
// [--minutes M]. It goes on after a finding, and ends with figures, which target/torture/restless.json holds as well. Two
// visits go on at a time, each in a browser of its own, where the machine has two cores.
// --seed S --upto K does the first K actions of one visit again and shows them.
import { mkdir, writeFile } from "node:fs/promises";
import { availableParallelism } from "node:os";
import path from "node:path";
import { parseArgs } from "node:util";
import { portraitFilm } from "./pictures.mjs";
import { Run, Visits } from "./restless/lanes.mjs";
import { kindOf, shrink } from "./restless/shrink.mjs";
import { inWords, wishes } from "./restless/visit.mjs";
import { DIST, serve } from "./server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const REPORT = path.join(ROOT, "target/torture/restless.json");
const LANES = Math.min(2, availableParallelism());
const LAST_SHOWN = 15;
const SHRINKING_MS = 120_000;

const { values } = parseArgs({
  options: {
    actions: { type: "string", default: "20000" },
    seed: { type: "string", default: "1" },
    minutes: { type: "string", default: "600" },
    upto: { type: "string" },
  },
});
const started = performance.now();
const server = await serve(DIST, "/some/where/");
const film = await portraitFilm();

if (values.upto) await replay(Number(values.seed), Number(values.upto));
else await wander(Number(values.actions), Number(values.seed), Number(values.minutes));
server.close();

/** @param {number} seed @param {number} upto */
async function replay(seed, upto) {
  let done = 0;
  const tell = (action) => console.log(`${++done}. ${inWords(action)}`);
  const visits = new Visits(server.url, film);
  // The long run passed over notices that it had noted before.
  const { finding } = await visits.make(wishes(seed, upto), { tell, isKnown: () => done < upto });
  await visits.end();
  console.log(finding ? `✗ ${finding.message}\n${finding.stack ?? ""}` : "✓ nothing was found");
  process.exitCode = finding ? 1 : 0;
}

/** @param {number} wanted @param {number} firstSeed @param {number} minutes */
async function wander(wanted, firstSeed, minutes) {
  const run = new Run(wanted, firstSeed, started + 60_000 * minutes);
  await Promise.all(Array.from({ length: LANES }, () => wanderInLane(run)));
  const seconds = (performance.now() - started) / 1000;
  await report({ actions: run.done, seconds, actionsPerSecond: run.done / seconds, findings: [...run.findings.values()] });
}

/** One visit after the other, as long as there is anything left to do. @param {Run} run */
async function wanderInLane(run) {
  const visits = new Visits(server.url, film);
  for (let next = run.next(); next; next = run.next()) {
    const isKnown = (message) => run.findings.has(kindOf(message));
    const visited = await visits.make(wishes(next.seed, next.count), { isKnown });
    run.finish(next.count, visited.actions.length);
    for (const message of visited.known) run.findings.get(kindOf(message)).count += 1;
    if (visited.finding) await note(run, next.seed, visited, visits);
    if (visited.finding || next.seed % 10 === 0) console.log(progress(run));
  }
  await visits.end();
}

/** Adds a finding; the first of its kind is also made shorter. */
async function note({ findings, until }, seed, visited, visits) {
  const { message, stack } = visited.finding;
  const kind = kindOf(message);
  const known = findings.get(kind);
  const at = { seed, upto: visited.actions.length };
  if (known) {
    known.count += 1;
    known.seeds.push(at);
    return;
  }
  console.log(`✗ ${message}\n  again: npm run restless -- --seed ${at.seed} --upto ${at.upto}`);
  const finding = { message, count: 1, seeds: [at], stack, last: visited.actions.slice(-LAST_SHOWN).map(inWords) };
  findings.set(kind, finding);
  const limit = Math.min(until, performance.now() + SHRINKING_MS);
  const shortest = await shrink(visited, (...how) => visits.make(...how), () => performance.now() < limit);
  if (shortest.length >= visited.actions.length) return;
  finding.shortest = shortest.map(inWords);
  console.log([`  the same after ${shortest.length} actions:`, ...finding.shortest].join("\n    "));
}

/** @param {Run} run */
function progress({ done, findings }) {
  return `  ${done} actions, ${((1000 * done) / (performance.now() - started)).toFixed(1)} a second, ${findings.size} kinds of findings`;
}

/** @param {{ actions: number, seconds: number, actionsPerSecond: number, findings: any[] }} figures */
async function report(figures) {
  await mkdir(path.dirname(REPORT), { recursive: true });
  await writeFile(REPORT, `${JSON.stringify(figures, null, 2)}\n`);
  for (const { message, count, seeds, last, shortest } of figures.findings) {
    console.log(`\n✗ ${message}\n  ${count} times; by ${seeds.slice(0, 5).map(({ seed, upto }) => `--seed ${seed} --upto ${upto}`).join(", ")}`);
    for (const line of (shortest ?? last).slice(-LAST_SHOWN)) console.log(`    ${line}`);
  }
  const { actions, seconds, actionsPerSecond, findings } = figures;
  const times = findings.reduce((sum, { count }) => sum + count, 0);
  console.log(`\nrestless: ${actions} actions in ${seconds.toFixed(0)} s (${actionsPerSecond.toFixed(1)} a second), ${times} findings of ${findings.length} kinds`);
  process.exitCode = times === 0 ? 0 : 1;
}
