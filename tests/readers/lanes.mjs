import { availableParallelism } from "node:os";

/**
 * Work on each item, as many at a time as the machine has cores; the results in the items' order.
 *
 * @template T, R
 * @param {T[]} items
 * @param {(item: T) => Promise<R>} work
 * @returns {Promise<R[]>}
 */
export async function inLanes(items, work) {
  const waiting = [...items.entries()];
  /** @type {R[]} */
  const done = [];
  const lane = async () => {
    for (let next = waiting.shift(); next; next = waiting.shift()) done[next[0]] = await work(next[1]);
  };
  await Promise.all(Array.from({ length: availableParallelism() }, lane));
  return done;
}
