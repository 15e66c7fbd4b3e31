import { accessSync, constants } from "node:fs";
import path from "node:path";

/**
 * A program on PATH.
 *
 * @param {string} what it is, for the message
 * @param {string[]} names tried one after the other
 * @param {string} debian the package that has it
 */
export function find(what, names, debian) {
  const folders = (process.env.PATH ?? "").split(path.delimiter);
  const files = names.flatMap((name) => folders.map((folder) => path.join(folder, name)));
  const found = files.find(isProgram);
  if (!found) throw new Error(`no ${what} on this machine: \`cargo xtask setup\` installs it, or apt-get install ${debian}`);
  return found;
}

/** @param {string} file */
function isProgram(file) {
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}
