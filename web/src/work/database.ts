/*!
 * idb 8.0.4, Copyright (c) 2016, Jake Archibald <jaffathecake@gmail.com>. ISC License: Permission to use, copy, modify,
 * and/or distribute this software for any purpose with or without fee is hereby granted, provided that the above
 * copyright notice and this permission notice appear in all copies. THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR
 * DISCLAIMS ALL WARRANTIES WITH REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS.
 * IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT, INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES
 * WHATSOEVER RESULTING FROM LOSS OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER TORTIOUS
 * ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF THIS SOFTWARE.
 */

import { openDB } from "idb";
import type { DBSchema, IDBPDatabase, IDBPTransaction } from "idb";
import type { Face, SourceFile } from "./face.ts";

/** The part of a face that changes often. */
export type Work = Required<Pick<Face, "photos" | "pictures" | "lead" | "edits" | "preferences">>;

export interface FaceRow {
  name: string;
  /** bytes in browsers that cannot store blobs */
  files: (Omit<SourceFile, "file"> & { file: Blob | ArrayBuffer })[];
}

/** `order`: save order of all slots */
export type WorkRow = Work & { order: number };

/** A slot has one row in each store. Rows can be damaged, so readers check them. */
interface Schema extends DBSchema {
  faces: { key: string; value: FaceRow };
  done: { key: string; value: WorkRow; indexes: { order: number } };
}

const STORES: ("faces" | "done")[] = ["faces", "done"];

const ANSWER_MS = 5000;

/** Thrown if the browser does not answer in time. */
export class TimeoutError extends Error {}

/** Kept open, because a page that is being left has no time to wait. */
let connection: Promise<IDBPDatabase<Schema>> | undefined;

/**
 * Runs `act` in one transaction over both stores. Resolves after the commit: a request that succeeded can still be
 * rolled back, for example on a full disk. Another tab can block the database indefinitely, so there is a limit.
 *
 * @param act may await requests to these stores only
 * @param limit_ms from the request to the commit
 */
export async function transact<T, Mode extends IDBTransactionMode>(
  mode: Mode,
  act: (transaction: IDBPTransaction<Schema, typeof STORES, Mode>) => Promise<T>,
  limit_ms = ANSWER_MS,
) {
  connection ??= connect();
  const transaction = (await connection).transaction(STORES, mode);
  try {
    const ended = Promise.all([act(transaction), transaction.done]);
    const [result] = await withTimeout(limit_ms, ended, `a ${mode} transaction`);
    return result;
  } catch (error) {
    // Fails after a commit or an abort.
    attempt(() => transaction.abort());
    throw error;
  }
}

async function connect() {
  const opening = Promise.resolve().then(() => openDB<Schema>("rosto", 1, {
    upgrade: (database) => {
      database.createObjectStore("faces");
      database.createObjectStore("done").createIndex("order", "order");
    },
    // Another tab deletes the database, or has a newer version of the page.
    blocking: (_version, _next, { target }) => {
      connection = undefined;
      (target as IDBDatabase).close();
    },
    terminated: () => (connection = undefined),
  }));
  try {
    return await withTimeout(ANSWER_MS, opening, "opening the database");
  } catch (error) {
    connection = undefined;
    throw error;
  }
}

/** Rejects with {@link TimeoutError} if `promise` does not settle in time. */
export function withTimeout<T>(limit_ms: number, promise: Promise<T>, operation: string): Promise<T> {
  let timer = 0;
  const timeout = new Promise<never>((_, reject) => {
    timer = setTimeout(() => reject(new TimeoutError(`${operation}: no answer in ${limit_ms / 1000} s`)), limit_ms);
  });
  return Promise.race([promise, timeout]).finally(() => clearTimeout(timer));
}

/** Returns the result of `act`; undefined if it throws. */
export function attempt<T>(act: () => T) {
  try {
    return act();
  } catch {
    return undefined;
  }
}
