import { make } from "../page/dom.js";
import { idName } from "../words/names.js";
import { onLocaleChange, isWord, t } from "../words/words.js";
import { isSlow, untilWaitIsSaid } from "./selection-mode.js";

/** @typedef {import("../viewport/host.js").Host} Host */

/** The word under which a choice says that none of its sets of options is on. */
const OWN = "custom";

/**
 * Fills every list and group of buttons that offers a choice with what the studio has to choose from, and keeps them
 * as the studio says. `data-choice` names the choice; the words `choice.id`, `choice.id.help` and `choice.id.legend` go
 * with what is chosen.
 *
 * @param {Host} host
 */
export function setUpChoices(host) {
  for (const element of document.querySelectorAll("[data-choice]")) {
    const choice = element.getAttribute("data-choice") ?? "";
    const ids = host.answer((studio) => studio.choices(choice));
    const control = element instanceof HTMLSelectElement ? listOf(element) : groupOf(/** @type {HTMLElement} */ (element), choice);
    const explain = () => sayMore(choice, control.chosen());
    control.offer(ids);
    element.addEventListener("change", async () => {
      const id = control.chosen();
      if (isSlow(choice, id)) await untilWaitIsSaid();
      host.act((studio) => studio.choose(choice, id));
      explain();
    });
    host.onChange((state) => {
      control.show(state.chosen(choice) ?? "");
      explain();
    });
    onLocaleChange(() => {
      control.name((id) => idName(choice, id));
      explain();
    });
  }
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
    offer: (ids) => group.replaceChildren(...ids.map((id) => button(choice, id)), ...ownChoice(choice)),
    name: (nameOf) => {
      for (const input of inputs()) if (input.nextElementSibling) input.nextElementSibling.textContent = nameOf(input.value);
    },
    show: (id) => {
      const own = inputs().find(({ value }) => value === OWN);
      if (own?.parentElement) own.parentElement.hidden = id !== "";
      for (const input of inputs()) input.checked = input.value === (own && id === "" ? OWN : id);
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
 * What a choice of whole sets of options shows while none of them is on: it tells, and cannot be chosen.
 *
 * @param {string} choice
 */
function ownChoice(choice) {
  if (!isWord(`${choice}.${OWN}`)) return [];
  const label = button(choice, OWN);
  for (const input of label.querySelectorAll("input")) input.disabled = true;
  label.hidden = true;
  return [label];
}

/**
 * Says what goes with what is chosen, where the page has a place for it.
 *
 * @param {string} choice
 * @param {string} id
 */
function sayMore(choice, id) {
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
