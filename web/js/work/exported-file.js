import { release, studioModule } from "../viewport/studio-module.js";

/**
 * @typedef {import("../../wasm/rosto-studio-web.js").StudioFileOptions} StudioFileOptions
 * @typedef {import("../viewport/whole-texture.js").WholeTexture} WholeTexture
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {Record<string, string>} ExportChoices values by the ids of the studio's `StudioFileOptions`
 */

/**
 * Exports the face, once the whole-face texture is ready if the file needs it.
 *
 * @param {Host} host
 * @param {WholeTexture} texture
 * @param {string} format
 * @param {ExportChoices} chosen
 */
export async function exportedFile(host, texture, format, chosen) {
  if (chosen["base-colour"] === "whole" && host.answer((studio) => studio.isPainted(format))) await texture.ready();
  return withFileChoices(chosen, (choices) => host.answer((studio) => studio.exportFile(format, choices)));
}

/**
 * Calls `then` with the choices as a wasm object, and frees it.
 *
 * @template T
 * @param {ExportChoices} chosen
 * @param {(choices: StudioFileOptions) => T} then
 */
export function withFileChoices(chosen, then) {
  const choices = new (studioModule().StudioFileOptions)();
  try {
    for (const [choice, id] of Object.entries(chosen)) choices.choose(choice, id);
    return then(choices);
  } finally {
    release(choices);
  }
}
