export class TimeoutError extends Error {}

/**
 * Rejects with `TimeoutError` if `promise` does not settle in time.
 *
 * @param operation for the error message
 */
export function withTimeout<T>(limit_ms: number, promise: Promise<T>, operation: string): Promise<T> {
  let timer = 0;
  const timeout = new Promise<never>((_, reject) => {
    timer = setTimeout(() => reject(new TimeoutError(`${operation}: no answer in ${limit_ms / 1000} s`)), limit_ms);
  });
  return Promise.race([promise, timeout]).finally(() => clearTimeout(timer));
}
