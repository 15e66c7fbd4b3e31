import { test } from "./fixtures.mjs";
import { CONTEXT, Visit, inWords, wishes } from "./restless/visit.mjs";

/** `cargo xtask torture` goes on for as many actions as it is given. */
const SEEDS = [1, 2];
const ACTIONS = 125;

for (const seed of SEEDS) {
  test(`a restless visitor does ${ACTIONS} things at random, by seed ${seed}, and nothing breaks`, { tag: "@rare" }, async ({ open }) => {
    const visitor = await open(CONTEXT);
    const { actions, finding } = await (await Visit.of(visitor)).go(wishes(seed, ACTIONS));
    if (!finding) return;
    const log = actions.map((action, at) => `${at + 1}. ${inWords(action)}`).join("\n");
    const again = `npm run restless -- --seed ${seed} --upto ${actions.length}`;
    throw new Error(`${finding.message}\n${finding.stack ?? ""}\nagain: ${again}\n${log}`);
  });
}
