import { byId } from "../page/dom.js";

/** The values of the export tab’s checked inputs, by file option. @returns {Record<string, string>} */
export function fileChoices() {
  const inputs = /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll("[data-file-option]:checked"));
  return Object.fromEntries([...inputs].map(({ dataset, value }) => [dataset["fileOption"] ?? "", value]));
}

/** File options plus print options. The studio rejects an invalid length. */
export function printChoices() {
  const solid = chosen("solid");
  const length = hasLength(solid) ? `${solid}:${byId("solid-mm", HTMLInputElement).value}` : solid;
  return { ...fileChoices(), solid: length };
}

/** @param {string} solid */
export function hasLength(solid) {
  return solid !== "surface";
}

/** @param {string} name name of a radio group */
export function chosen(name) {
  const input = /** @type {HTMLInputElement | null} */ (document.querySelector(`input[name="${name}"]:checked`));
  return input?.value ?? "";
}

/** @param {string} id id of a checkbox */
export function isChecked(id) {
  return byId(id, HTMLInputElement).checked;
}
