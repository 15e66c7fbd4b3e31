import { release, studioModule } from "../viewport/studio-module.js";

/**
 * @typedef {import("../../wasm/rosto-studio-web.js").FileChoices} FileChoices
 * @typedef {import("../viewport/whole-texture.js").WholeTexture} WholeTexture
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {Record<string, string>} Chosen what is chosen about a file, by the ids of the studio's `FileChoices`
 */

/**
 * The face as a file, as it is asked for. One that is painted with the whole face waits for its texture.
 *
 * @param {Host} host
 * @param {WholeTexture} texture
 * @param {string} format
 * @param {Chosen} chosen
 */
export async function writtenFile(host, texture, format, chosen) {
  if (chosen["base-colour"] === "whole" && host.answer((studio) => studio.isPainted(format))) await texture.ready();
  return withFileChoices(chosen, (choices) => host.answer((studio) => studio.exportFile(format, choices)));
}

/**
 * Does something with what is chosen about files.
 *
 * @template T
 * @param {Chosen} chosen
 * @param {(choices: FileChoices) => T} then
 */
export function withFileChoices(chosen, then) {
  const choices = new (studioModule().FileChoices)();
  try {
    for (const [what, id] of Object.entries(chosen)) choices.choose(what, id);
    return then(choices);
  } finally {
    release(choices);
  }
}
