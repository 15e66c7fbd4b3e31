import type { Tasks } from "./tasks.ts";

/**
 * Messages between the page and its worker. A request is the name of a task with its argument; the answer is what the
 * task returns. Bitmaps and buffers are transferred, not copied.
 */

/** An error, as both wasm modules throw it. */
export type PageError = { code: string; message: string; hint: string; maxMm?: number };

export type Stage = "decode" | "detect" | "landmarks" | "paper";

export type Report = (stage: Stage, fraction: number) => void;

export type PhotoType = "image/png" | "image/jpeg";

export type Argument<Name extends keyof Tasks> = Parameters<Tasks[Name]>[0];
export type Answer<Name extends keyof Tasks> = Awaited<ReturnType<Tasks[Name]>>;

export type Opened = Answer<"open">;
export type FollowedFrame = Answer<"follow">;

export type Reply =
  | { type: "alive"; lock: string }
  | { type: "loading" }
  | { type: "progress"; id: number; stage: Stage; fraction: number }
  | { type: "failed"; id: number; error: PageError }
  | { type: "trapped"; message: string }
  | { type: keyof Tasks; id: number; answer: unknown };

/** The bitmaps and buffers in a message. */
export function transferable(message: unknown): Transferable[] {
  if (message instanceof ImageBitmap) return [message];
  if (message instanceof Uint8Array || message instanceof Float32Array) return [message.buffer];
  const isPlain = typeof message === "object" && message !== null && !(message instanceof Blob);
  return isPlain ? Object.values(message).flatMap(transferable) : [];
}
