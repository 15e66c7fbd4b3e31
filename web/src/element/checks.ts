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
    [this.code, this.hint] = [code, hint];
  }

  /** Wraps any thrown value. */
  static of(thrown: unknown) {
    if (thrown instanceof RostoError) return thrown;
    const { code, message, hint } = asPageError(thrown);
    return new RostoError(code, message, hint);
  }
}

// Checks of arguments from the host page. The modules trust their types, and a wrong one can stop them.

/** Levels of arrays and objects in data from the host page. No intent has more. */
const MAX_DEPTH = 5;

/** Characters of a text in a message. */
const MAX_SHOWN = 40;

export function text(name: string, value: unknown, allowed = "a string") {
  return typeof value === "string" ? value : refuse("bad-choice", name, value, allowed);
}

/** @param ids the known ones; any string if there are none, as before a face is open */
export function oneOf(name: string, value: unknown, ids: string[]) {
  if (ids.length === 0) return text(name, value);
  return ids.find((id) => id === value) ?? refuse("bad-choice", name, value, `one of ${ids.join(", ")}`);
}

export function finite(name: string, value: unknown) {
  return Number.isFinite(value) ? (value as number) : refuse("bad-number", name, value, "a finite number");
}

/** @param count of items; the index is below it */
export function index(name: string, value: unknown, count: number) {
  const isIndex = Number.isInteger(value) && (value as number) >= 0 && (value as number) < count;
  return isIndex ? (value as number) : refuse("bad-number", name, value, `an integer from 0, below ${count}`);
}

export function point(name: string, value: unknown) {
  const parts = plain(name, value);
  if (!Array.isArray(parts)) return refuse("bad-number", name, value, "[x, y, z]");
  if (parts.length !== 3) return refuse("bad-number", `length of ${name}`, parts.length, "3");
  return parts.map((part, axis) => finite(`${name}.${axis}`, part)) as [number, number, number];
}

/** Ids by name, such as the choices of a file. */
export function choices(name: string, value: unknown) {
  const ids = plain(name, value);
  if (!isRecord(ids)) return refuse("bad-choice", name, value, "an object of strings");
  return Object.fromEntries(Object.entries(ids).map(([key, id]) => [key, text(`${name}.${key}`, id)]));
}

/** A copy of plain data. A getter or proxy would otherwise run code of the host page while the module reads it. */
export function plain(name: string, value: unknown, depth = MAX_DEPTH): unknown {
  if (typeof value === "number") return finite(name, value);
  if (value === null || /undefined|string|boolean/.test(typeof value)) return value;
  const isArray = Array.isArray(value);
  if (depth === 0 || !(isArray || isRecord(value))) return refuse("bad-choice", name, value, "plain data");
  const parts = Object.entries(value).map(([key, part]) => [key, plain(`${name}.${key}`, part, depth - 1)] as const);
  return isArray ? parts.map(([, part]) => part) : Object.fromEntries(parts);
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && [Object.prototype, null].includes(Object.getPrototypeOf(value));
}

function refuse(code: "bad-choice" | "bad-number", name: string, value: unknown, allowed: string): never {
  throw new RostoError(code, `${name} is ${described(value)}; use ${allowed}`);
}

function described(value: unknown) {
  if (typeof value === "string") return JSON.stringify(value.slice(0, MAX_SHOWN));
  return /object|function/.test(typeof value) && value !== null ? `of type ${typeof value}` : String(value);
}
