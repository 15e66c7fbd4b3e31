/**
 * The worker that decodes photos and saved files, finds and follows faces, and writes files: see tasks.ts. It holds no
 * user data that the page cannot send again, so the page can terminate and restart it at any time.
 */

import { asPageError } from "../page/page-error.ts";
import { transferable } from "./protocol.ts";
import { tasks } from "./tasks.ts";
import type { Report, Reply } from "./protocol.ts";
import type { Tasks } from "./tasks.ts";

type Request = { type: keyof Tasks; id: number };

/** Held for the life of this worker. The browser releases it even after a crash, which the page detects. */
const lock = `rosto-vision-${crypto.randomUUID()}`;
navigator.locks.request(lock, () => {
  post({ type: "alive", lock });
  return new Promise(() => {});
});

addEventListener("message", async ({ data }: MessageEvent<Request>) => {
  const { type, id } = data;
  const perform = tasks[type] as (argument: unknown, report: Report) => Promise<unknown>;
  try {
    const answer = await perform(data, (stage, fraction) => post({ type: "progress", id, stage, fraction }));
    post({ type, id, answer });
  } catch (error) {
    // A trap leaves the module's memory in an undefined state, so the page restarts the worker.
    if (error instanceof WebAssembly.RuntimeError) post({ type: "trapped", message: error.message });
    else post({ type: "failed", id, error: asPageError(error) });
  }
});

function post(reply: Reply) {
  postMessage(reply, { transfer: transferable(reply) });
}
