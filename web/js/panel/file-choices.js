import { byId } from "../page/dom.js";

/**
 * What is chosen about files.
 *
 * @returns {import("../work/written-file.js").Chosen}
 */
export function fileChoices() {
  return {
    "base-colour": chosen("base-colour"),
    material: isChecked("export-unlit") ? "unlit" : "lit",
    edits: isChecked("export-morphs") ? "morph-targets" : "shape",
    expressions: isChecked("export-expressions") ? "morph-targets" : "shape",
    eyes: isChecked("export-eyes") ? "pieces" : "skin",
    units: chosen("export-units"),
  };
}

/** The same with what is chosen about the body that is printed: a length that is no such length is refused. */
export function printChoices() {
  const solid = chosen("solid");
  const length = hasLength(solid) ? `${solid}:${byId("solid-mm", HTMLInputElement).value}` : solid;
  return { ...fileChoices(), solid: length };
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
