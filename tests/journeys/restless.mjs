// A long visit by somebody who does anything at random: node tests/journeys/restless.mjs [--actions N] [--seed S]
// [--minutes M]. It goes on after a finding, and ends with figures, which target/torture/restless.json holds as well.
// --seed S --upto K does the first K actions of one visit again and shows them.
import { mkdir, mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { parseArgs } from "node:util";
import { launch } from "./browser.mjs";
import { asFilm } from "./pictures.mjs";
import { kindOf, shrink } from "./restless/shrink.mjs";
import { CONTEXT, Visit, inWords, wishes } from "./restless/visit.mjs";
import { serve } from "./server.mjs";
import { SAMPLE, Visitor } from "./visitor.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const DIST = path.resolve(process.env.ROSTO_DIST ?? path.join(ROOT, "dist"));
const REPORT = path.join(ROOT, "target/torture/restless.json");
/** Each visit has a seed of its own, so that what it found can be found again quickly. */
const ACTIONS_PER_VISIT = 250;
const VISITS_PER_BROWSER = 12;
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
/** @type {import("playwright-core").Browser | undefined} */
let browser;
let visits = 0;

if (values.upto) await replay(Number(values.seed), Number(values.upto));
else await wander(Number(values.actions), Number(values.seed), Number(values.minutes));
await browser?.close();
server.close();

/** @param {number} seed @param {number} upto */
async function replay(seed, upto) {
  let done = 0;
  const tell = (action) => console.log(`${++done}. ${inWords(action)}`);
  // The long run passed over notices that it had noted before.
  const { finding } = await visit(wishes(seed, upto), { tell, isKnown: () => done < upto });
  console.log(finding ? `✗ ${finding.message}\n${finding.stack ?? ""}` : "✓ nothing was found");
  process.exitCode = finding ? 1 : 0;
}

/** @param {number} wanted @param {number} firstSeed @param {number} minutes */
async function wander(wanted, firstSeed, minutes) {
  const isInTime = () => performance.now() - started < 60_000 * minutes;
  /** @type {Map<string, { message: string, count: number, seeds: { seed: number, upto: number }[], stack?: string, last: string[], shortest?: string[] }>} */
  const findings = new Map();
  let done = 0;
  let acting_ms = 0;
  for (let seed = firstSeed; done < wanted && isInTime(); seed++) {
    const isKnown = (message) => findings.has(kindOf(message));
    const visited = await visit(wishes(seed, Math.min(ACTIONS_PER_VISIT, wanted - done)), { isKnown });
    done += visited.actions.length;
    acting_ms += visited.took_ms;
    for (const message of visited.known) findings.get(kindOf(message)).count += 1;
    if (visited.finding) await note(findings, seed, visited, isInTime);
    if (visited.finding || seed % 10 === 0) console.log(progress(done, acting_ms, findings));
  }
  await report({ actions: done, visits, seconds: (performance.now() - started) / 1000, actionsPerSecond: (1000 * done) / acting_ms, findings: [...findings.values()] });
}

/** Adds a finding; the first of its kind is also made shorter. */
async function note(findings, seed, visited, isInTime) {
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
  const since = performance.now();
  const shortest = await shrink(visited, visit, () => isInTime() && performance.now() - since < SHRINKING_MS);
  if (shortest.length >= visited.actions.length) return;
  finding.shortest = shortest.map(inWords);
  console.log([`  the same after ${shortest.length} actions:`, ...finding.shortest].join("\n    "));
}

/** A browser context of its own for each visit, and a fresh browser now and then. */
async function visit(wishes, how) {
  if (visits++ % VISITS_PER_BROWSER === 0 || !browser?.isConnected()) {
    await browser?.close().catch(() => {});
    browser = await launch({ film: await film() });
  }
  const visitor = await Visitor.arrive(browser, server.url, CONTEXT);
  try {
    return await (await Visit.of(visitor)).go(wishes, how);
  } finally {
    await visitor.leave().catch(() => {});
  }
}

/** What the camera shows. */
async function film() {
  const file = path.join(await mkdtemp(path.join(tmpdir(), "rosto-")), "portrait.y4m");
  await writeFile(file, asFilm(await readFile(SAMPLE), 5));
  return file;
}

function progress(done, acting_ms, findings) {
  return `  ${done} actions, ${((1000 * done) / acting_ms).toFixed(1)} a second, ${findings.size} kinds of findings`;
}

/** @param {{ actions: number, visits: number, seconds: number, actionsPerSecond: number, findings: any[] }} figures */
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
