import { recorded } from "./visit.mjs";

/**
 * @typedef {import("./intents.mjs").Action} Action
 * @typedef {import("./visit.mjs").Visited} Visited
 */

/** How many of the last actions are tried first, the fewest last. */
const LASTS = [50, 25, 12];
/** Each try is a visit of its own. */
const MOST_TRIES = 14;

/** @type {Action} */
const ARRIVE = { do: "files", files: ["portrait"], by: "drop", wait: true };

/**
 * A shorter way to the same finding: the last actions after the portrait was opened, and then without those that can be
 * left out; all actions if no shorter way is found.
 *
 * @param {Visited} visited that ended with a finding
 * @param {(wishes: ReturnType<typeof recorded>, how: { isKnown: (message: string) => boolean }) => Promise<Visited>} visit makes a visit of its own
 * @param {() => boolean} mayGoOn whether there is time for another try
 * @returns {Promise<Action[]>}
 */
export async function shrink({ actions, finding }, visit, mayGoOn) {
  let tries = 0;
  const isKnown = (/** @type {string} */ message) => kindOf(message) !== kindOf(finding.message);
  const leadsThere = async (/** @type {Action[]} */ tried) => {
    if (tries++ >= MOST_TRIES || !mayGoOn()) return false;
    const again = await visit(recorded(tried), { isKnown });
    return again.finding !== undefined && !isKnown(again.finding.message);
  };
  let fewest = actions;
  for (const last of LASTS.filter((last) => last < actions.length)) {
    const tried = [ARRIVE, ...actions.slice(-last)];
    if (!(await leadsThere(tried))) break;
    fewest = tried;
  }
  return withoutNeedless(fewest, leadsThere);
}

/**
 * Leaves out halves, then quarters, and so on, of what comes before the last action.
 *
 * @param {Action[]} actions
 * @param {(tried: Action[]) => Promise<boolean>} leadsThere
 */
async function withoutNeedless(actions, leadsThere) {
  let fewest = actions;
  for (let part = Math.ceil((fewest.length - 1) / 2); part >= 1; part = Math.floor(part / 2)) {
    for (let from = 0; from < fewest.length - 1; ) {
      const tried = fewest.filter((_, at) => at < from || at >= Math.min(from + part, fewest.length - 1));
      if (await leadsThere(tried)) fewest = tried;
      else from += part;
    }
  }
  return fewest;
}

/**
 * What findings with other numbers in them have in common.
 *
 * @param {string} message
 */
export function kindOf(message) {
  return message.replaceAll(/-?\d+(\.\d+)?(e[+-]?\d+)?/g, "N");
}
