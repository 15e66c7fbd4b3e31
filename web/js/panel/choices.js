import { make } from "../page/dom.js";
import { idName } from "../words/names.js";
import { onLocaleChange, isWord, t } from "../words/words.js";
import { isSlow, announcePreparing } from "./selection-mode.js";

/** @typedef {import("../viewport/host.js").Host} Host */

/** Shown while the current options match none of a choice's presets. */
const CUSTOM = "custom";

/**
 * Fills each list and button group that has `data-choice` with the studio's ids, and follows the studio's state. The
 * words `choice.id`, `choice.id.help` and `choice.id.legend` belong to the chosen id.
 *
 * @param {Host} host
 */
export function setUpChoices(host) {
  for (const element of document.querySelectorAll("[data-choice]")) {
    const choice = element.getAttribute("data-choice") ?? "";
    const ids = host.catalogue.choices[choice] ?? [];
    const control = element instanceof HTMLSelectElement ? listOf(element) : groupOf(/** @type {HTMLElement} */ (element), choice);
    const explain = () => showHelp(choice, control.chosen());
    control.offer(ids);
    element.addEventListener("change", async () => {
      const id = control.chosen();
      if (isSlow(choice, id)) await announcePreparing();
      host.apply(choiceIntent(choice, id));
      explain();
    });
    host.onChange((state) => {
      control.show(state.chosen[choice] ?? "");
      explain();
    });
    onLocaleChange(() => {
      control.name((id) => idName(choice, id));
      explain();
    });
  }
}

/**
 * The intent that sets a choice to the value with an id.
 *
 * @param {string} choice
 * @param {string} id
 */
function choiceIntent(choice, id) {
  return /** @type {import("../viewport/host.js").Intent} */ ({ [choice]: id });
}

/**
 * @typedef {object} Control
 * @property {(ids: string[]) => void} offer
 * @property {(nameOf: (id: string) => string) => void} name
 * @property {(id: string) => void} show
 * @property {() => string} chosen
 */

/**
 * @param {HTMLSelectElement} list
 * @returns {Control}
 */
function listOf(list) {
  return {
    offer: (ids) => list.replaceChildren(...ids.map((id) => new Option("", id))),
    name: (nameOf) => {
      for (const option of list.options) option.textContent = nameOf(option.value);
    },
    show: (id) => {
      list.value = id;
    },
    chosen: () => list.value,
  };
}

/**
 * @param {HTMLElement} group
 * @param {string} choice
 * @returns {Control}
 */
function groupOf(group, choice) {
  const inputs = () => [...group.querySelectorAll("input")];
  return {
    offer: (ids) => group.replaceChildren(...ids.map((id) => button(choice, id)), ...customOption(choice)),
    name: (nameOf) => {
      for (const input of inputs()) if (input.nextElementSibling) input.nextElementSibling.textContent = nameOf(input.value);
    },
    show: (id) => {
      const custom = inputs().find(({ value }) => value === CUSTOM);
      if (custom?.parentElement) custom.parentElement.hidden = id !== "";
      for (const input of inputs()) input.checked = input.value === (custom && id === "" ? CUSTOM : id);
    },
    chosen: () => inputs().find((input) => input.checked)?.value ?? "",
  };
}

/**
 * @param {string} choice
 * @param {string} id
 */
function button(choice, id) {
  const label = make("label");
  const input = make("input");
  input.type = "radio";
  input.name = choice;
  input.value = id;
  label.append(input, make("span"));
  return label;
}

/**
 * The disabled "custom" button of a choice that consists of presets.
 *
 * @param {string} choice
 */
function customOption(choice) {
  if (!isWord(`${choice}.${CUSTOM}`)) return [];
  const label = button(choice, CUSTOM);
  for (const input of label.querySelectorAll("input")) input.disabled = true;
  label.hidden = true;
  return [label];
}

/**
 * Shows the help and the legend of the chosen id, if the page has an element for them.
 *
 * @param {string} choice
 * @param {string} id
 */
function showHelp(choice, id) {
  for (const kind of /** @type {const} */ (["help", "legend"])) {
    const key = `${choice}.${id}.${kind}`;
    const place = document.getElementById(`${choice}-${kind}`);
    if (!place) continue;
    place.textContent = isWord(key) ? t(key) : "";
    const frame = place.closest("[data-legend]");
    if (frame instanceof HTMLElement) {
      frame.hidden = !isWord(key);
      frame.dataset["legend"] = id;
    }
  }
}
