import { asPageError } from "../page/page-error.ts";

/** An error with a stable code for programs, and an English message for developers. */
export class RostoError extends Error {
  override name = "RostoError";
  readonly code: string;
  readonly hint: string;

  /**
   * @param code such as "no-face-found"
   * @param hint what to do about it
   */
  constructor(code: string, message: string, hint = "") {
    super(message);
    this.code = code;
    this.hint = hint;
  }

  /** Wraps any thrown value. */
  static of(thrown: unknown) {
    if (thrown instanceof RostoError) return thrown;
    const { code, message, hint } = asPageError(thrown);
    return new RostoError(code, message, hint);
  }
}

/** Levels of arrays and objects in data from the host page. No intent has more. */
const MAX_DEPTH = 5;

/** Characters of a text in a message. */
const MAX_SHOWN = 40;

// Checks of arguments from the host page. The modules trust their types, and a wrong one can stop them.

/** The error for an argument of the host page. @param allowed such as "a string" */
function refusal(code: "bad-choice" | "bad-number", name: string, value: unknown, allowed: string) {
  return new RostoError(code, `${name} is ${described(value)}; use ${allowed}`);
}

export function text(name: string, value: unknown) {
  if (typeof value === "string") return value;
  throw refusal("bad-choice", name, value, "a string");
}

/** A file or an address. */
export function photoFile(name: string, value: unknown) {
  try {
    if (typeof value === "string" || value instanceof Blob) return value;
  } catch {
    // A proxy of the host page threw.
  }
  throw refusal("bad-choice", name, value, "a Blob or an address");
}

/** @param ids the known ones; any string if there are none, as before a face is open */
export function oneOf(name: string, value: unknown, ids: string[]) {
  if (ids.length === 0) return text(name, value);
  if (typeof value === "string" && ids.includes(value)) return value;
  throw refusal("bad-choice", name, value, `one of ${ids.join(", ")}`);
}

export function finite(name: string, value: unknown) {
  if (Number.isFinite(value)) return value as number;
  throw refusal("bad-number", name, value, "a finite number");
}

/** @param count of items; the index is below it */
export function index(name: string, value: unknown, count: number) {
  if (Number.isInteger(value) && (value as number) >= 0 && (value as number) < count) return value as number;
  throw refusal("bad-number", name, value, count > 0 ? `an integer from 0 to ${count - 1}` : "it after rosto-face");
}

export function point(name: string, value: unknown) {
  const parts = plain(name, value);
  if (!Array.isArray(parts) || parts.length !== 3) throw refusal("bad-number", name, value, "[x, y, z]");
  return parts.map((part, axis) => finite(`${name}.${axis}`, part)) as [number, number, number];
}

/** Ids by name, such as the choices of a file. */
export function choices(name: string, value: unknown): Record<string, string> {
  const ids = plain(name, value);
  if (!isRecord(ids)) throw refusal("bad-choice", name, value, "an object of strings");
  return Object.fromEntries(Object.entries(ids).map(([key, id]) => [key, text(`${name}.${key}`, id)]));
}

/** A copy of plain data. A getter or proxy would otherwise run code of the host page while the module reads it. */
export function plain(name: string, value: unknown) {
  try {
    return copy(name, value, MAX_DEPTH);
  } catch (error) {
    throw error instanceof RostoError ? error : refusal("bad-choice", name, value, "plain data");
  }
}

function copy(name: string, value: unknown, depth: number): unknown {
  if (typeof value === "number") return finite(name, value);
  if (value === null || /undefined|string|boolean/.test(typeof value)) return value;
  const isArray = Array.isArray(value);
  if (depth === 0 || !(isArray || isRecord(value))) throw refusal("bad-choice", name, value, "plain data");
  const parts = Object.entries(value).map(([key, part]) => [key, copy(`${name}.${key}`, part, depth - 1)] as const);
  return isArray ? parts.map(([, part]) => part) : Object.fromEntries(parts);
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && [Object.prototype, null].includes(Object.getPrototypeOf(value));
}

function described(value: unknown) {
  if (typeof value === "string") return JSON.stringify(value.slice(0, MAX_SHOWN));
  if (typeof value === "function") return "a function";
  if (typeof value !== "object" || value === null) return String(value);
  try {
    return Array.isArray(value) ? `an array of ${value.length}` : "an object";
  } catch {
    return "a proxy";
  }
}
