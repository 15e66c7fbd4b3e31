// The readers in Python, each a script of its own in one process for all its files.
import { execFile } from "node:child_process";
import path from "node:path";
import { promisify } from "node:util";
import { Missing } from "./missing.mjs";

/** Names the interpreter that has them, which `cargo xtask test readers` makes. */
const READERS = "ROSTO_READERS_PYTHON";
/** Names the one that has Blender, which `cargo xtask readers` makes. */
export const BLENDER = "ROSTO_READERS_BLENDER";
/** The positions of many thousand vertices as text. */
const MOST_BYTES = 1 << 30;

/** @param {string} reader the script's name behind `with_` @param {string} [variable] names the interpreter @returns {(files: string[]) => Promise<import("./judge.mjs").Seen[]>} */
export function python(reader, variable = READERS) {
  return async (files) => {
    const interpreter = process.env[variable];
    if (!interpreter) throw new Missing(`${variable} names no Python`);
    const script = path.join(import.meta.dirname, `python/with_${reader}.py`);
    const { stdout } = await promisify(execFile)(interpreter, [script, ...files], { maxBuffer: MOST_BYTES }).catch(whyNot);
    // What a library prints of its own accord is no line of ours.
    return stdout.split("\n").filter((line) => line.startsWith('{"reader"')).map((line) => JSON.parse(line));
  };
}

/** A library that this Python does not have is missing; anything else that goes wrong is an error. @param {any} error */
function whyNot(error) {
  const lacking = /ModuleNotFoundError: (.+)/.exec(error.stderr ?? "");
  throw lacking ? new Missing(lacking[1]) : error;
}
