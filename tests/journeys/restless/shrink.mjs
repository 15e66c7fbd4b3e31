import { recorded } from "./visit.mjs";

/**
 * @typedef {import("./wishes.mjs").Action} Action
 * @typedef {import("./visit.mjs").Visited} Visited
 */

/** How many of the last actions are tried, the most first. */
const LASTS = [50, 25, 12, 6, 3];

/**
 * The fewest of the last actions that still lead to the same finding, after the portrait was opened; all of them if none do.
 *
 * @param {Visited} visited that ended with a finding
 * @param {(wishes: ReturnType<typeof recorded>) => Promise<Visited>} visit makes a visit of its own
 * @param {() => boolean} mayGoOn whether there is time for another try
 * @returns {Promise<Action[]>}
 */
export async function shrink({ actions, finding }, visit, mayGoOn) {
  const arrive = /** @type {Action} */ ({ do: "files", files: ["portrait"], by: "drop", wait: true });
  let fewest = actions;
  for (const last of LASTS) {
    if (last >= actions.length) continue;
    if (!mayGoOn()) break;
    const tried = [arrive, ...actions.slice(-last)];
    const again = await visit(recorded(tried));
    if (again.finding && kindOf(again.finding.message) === kindOf(finding.message)) fewest = tried;
    else break;
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
