export class TimeoutError extends Error {}

/**
 * Rejects with `TimeoutError` if `promise` does not settle in time.
 *
 * @template T
 * @param {number} limit_ms
 * @param {Promise<T>} promise
 * @param {string} operation for the error message
 * @returns {Promise<T>}
 */
export function withTimeout(limit_ms, promise, operation) {
  let timer = 0;
  const timeout = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new TimeoutError(`${operation}: no answer in ${limit_ms / 1000} s`)), limit_ms);
  });
  return Promise.race([promise, timeout]).finally(() => clearTimeout(timer));
}
