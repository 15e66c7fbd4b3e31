import { byId } from "../page/dom.js";
import { studioModule } from "../viewport/studio-module.js";

/**
 * @typedef {import("../../wasm/rosto-studio-web.js").FileChoices} FileChoices
 * @typedef {import("../viewport/whole-texture.js").WholeTexture} WholeTexture
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 */

/**
 * The face as a file, as it is asked for. One that is painted with the whole face waits for its texture.
 *
 * @param {Workbench} bench
 * @param {WholeTexture} texture
 * @param {string} format
 */
export async function writtenFile(bench, texture, format) {
  if (chosen("base-colour") === "whole" && bench.studio.isPainted(format)) await texture.ready();
  const choose = bench.studio.printedFormats.includes(format) ? withPrintChoices : withChoices;
  return choose((choices) => bench.studio.exportFile(format, choices));
}

/**
 * Does something with what is chosen about files.
 *
 * @template T
 * @param {(choices: FileChoices) => T} then
 */
export function withChoices(then) {
  const choices = new (studioModule().FileChoices)();
  try {
    choices.choose("base-colour", chosen("base-colour"));
    choices.choose("material", isChecked("export-unlit") ? "unlit" : "lit");
    choices.choose("edits", isChecked("export-morphs") ? "morph-targets" : "shape");
    choices.choose("expressions", isChecked("export-expressions") ? "morph-targets" : "shape");
    choices.choose("eyes", isChecked("export-eyes") ? "pieces" : "skin");
    choices.choose("units", chosen("export-units"));
    return then(choices);
  } finally {
    choices.free();
  }
}

/**
 * The same with what is chosen about the body that is printed: a length that is no such length is refused.
 *
 * @template T
 * @param {(choices: FileChoices) => T} then
 */
export function withPrintChoices(then) {
  return withChoices((choices) => {
    const solid = chosen("solid");
    choices.choose("solid", hasLength(solid) ? `${solid}:${byId("solid-mm", HTMLInputElement).value}` : solid);
    choices.choose("colours", chosen("colours"));
    return then(choices);
  });
}

/** @param {string} solid */
export function hasLength(solid) {
  return solid !== "surface";
}

/** @param {string} name of a group of radio buttons */
export function chosen(name) {
  const input = /** @type {HTMLInputElement | null} */ (document.querySelector(`input[name="${name}"]:checked`));
  return input?.value ?? "";
}

/** @param {string} id of a checkbox */
export function isChecked(id) {
  return byId(id, HTMLInputElement).checked;
}
