/** Thrown where an answer takes too long. */
export class Late extends Error {}

/**
 * An answer, unless it takes longer than a limit: then it is given up with `Late`.
 *
 * @template T
 * @param {number} limit_ms
 * @param {Promise<T>} answer
 * @param {string} what it is an answer of, for the error
 * @returns {Promise<T>}
 */
export function within(limit_ms, answer, what) {
  let timer = 0;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Late(`${what}: no answer in ${limit_ms / 1000} s`)), limit_ms);
  });
  return Promise.race([answer, late]).finally(() => clearTimeout(timer));
}
