/**
 * @typedef {object} Seen
 * @property {string} state of the page: "empty", "photo" or "face"
 * @property {boolean} busy whether a file is being opened
 * @property {boolean} dialog whether a dialog covers the page
 * @property {string | null} error the code of the notice that is shown
 * @property {string} notice its text
 */

/** Gives the page `window.monkey`; runs in the page, before its own scripts. */
export function letMonkeyIn() {
  const USABLE = "button, input:not([type=file]), select, summary, [role=button], .slider-label";
  const SHUFFLED = ["section-landmark", "section-view", "section-history"];
  /** Most of the time goes into shaping. */
  const WEIGHT_OF_GROUP = { "section-landmark": 8, "section-view": 3, "section-history": 3 };
  /** Selects decide how the face follows; folds stay open more often than not. */
  const WEIGHT_OF_KIND = { select: 15, tick: 8, closed: 20, open: 1 };
  /** Actions that take long. */
  const SLOW = ["run-paper", "camera", "close-camera"];

  const surface = (element) => (element.matches("[type=radio], [type=checkbox]") && element.closest("label")) || element;
  const isVisible = (element) => surface(element).checkVisibility({ visibilityProperty: true }) && surface(element).getBoundingClientRect().width > 0;
  const groupOf = (element) => element.closest("dialog, details.section, .toolbar, header, footer, section, main")?.id ?? "";
  const kindOf = (element) => {
    if (element.matches("summary")) return element.parentElement.open ? "open" : "closed";
    if (element.matches("[type=radio], [type=checkbox]")) return "tick";
    if (element.matches(".slider-label")) return "label";
    return element.matches("input") ? element.type : element.localName;
  };
  const usable = () => [...(document.querySelector("dialog:modal") ?? document).querySelectorAll(USABLE)].filter((element) => !element.matches(":disabled") && isVisible(element));
  const weightOf = (element) => (SLOW.includes(element.dataset.action) ? 1 : (WEIGHT_OF_KIND[kindOf(element)] ?? 5));

  /** The one of a list that a share from 0 to 1 falls on, each as wide as its weight. */
  const pick = (list, weightOf, share) => {
    const tickets = list.flatMap((one) => Array.from({ length: weightOf(one) }, () => one));
    return tickets[Math.floor(share * tickets.length)];
  };
  /** A software GPU draws the dense meshes slowly: they come up less often. */
  const optionOf = (select, share) => Math.floor((select.id === "density" ? share ** 6 : share) * select.options.length);
  const set = (element, key, value) => {
    element[key] = value;
    for (const type of ["input", "change"]) element.dispatchEvent(new Event(type, { bubbles: true }));
  };

  window["monkey"] = {
    look: () => {
      const notice = document.getElementById("notice");
      const isTroubled = notice?.hidden === false;
      return {
        state: document.body.dataset["state"] ?? "",
        busy: document.getElementById("progress")?.hidden === false,
        dialog: document.querySelector("dialog:modal") !== null,
        error: isTroubled ? (notice.dataset["code"] ?? "") : null,
        notice: isTroubled ? notice.innerText.trim().replaceAll(/\s+/g, " ") : "",
      };
    },
    settle: async (/** @type {number} */ frames) => {
      for (let frame = 0; frame < frames; frame++) await new Promise(requestAnimationFrame);
      return window["monkey"].look();
    },
    /** Any part of the page is as likely as the others, however many controls it has. */
    choose: ({ group, control }) => {
      const all = usable();
      const chosen = pick([...new Set(all.map(groupOf))], (name) => WEIGHT_OF_GROUP[name] ?? 2, group);
      const element = pick(all.filter((one) => groupOf(one) === chosen), weightOf, control);
      if (!element) return null;
      surface(element).scrollIntoView({ block: "center" });
      const { x, y, width, height } = surface(element).getBoundingClientRect();
      const label = (element.getAttribute("aria-label") ?? surface(element).textContent ?? "").trim().replaceAll(/\s+/g, " ").slice(0, 40);
      window["monkey"].chosen = element;
      return { kind: kindOf(element), label, x, y, width, height };
    },
    /** Focuses the chosen field, with its text selected. */
    enter: () => {
      const { chosen } = window["monkey"];
      chosen.focus();
      if (chosen.type !== "range") chosen.select();
    },
    /** Sets what a browser's own window would set: an option, a colour. */
    set: (share) => {
      const { chosen } = window["monkey"];
      if (chosen.matches("select")) set(chosen, "selectedIndex", optionOf(chosen, share));
      else set(chosen, "value", `#${Math.floor(share * 0x1000000).toString(16).padStart(6, "0")}`);
    },
    /** Several choices in one task: modes meet that rarely meet otherwise. */
    shuffle: (picks) => {
      for (const { control, value } of picks) {
        const element = pick(usable().filter((one) => one.matches("select, [type=radio], [type=checkbox]") && SHUFFLED.includes(groupOf(one))), weightOf, control);
        if (element?.matches("select")) set(element, "selectedIndex", optionOf(element, value));
        else element?.click();
      }
    },
    /** Presses a button wherever it is, as a key or a screen reader would; returns whether it can be pressed. */
    press: (selector) => {
      const element = document.querySelector(selector);
      if (!element || element.matches(":disabled")) return false;
      element.click();
      return true;
    },
    bring: ({ base64, name, by }) => {
      const carried = new DataTransfer();
      carried.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name));
      const stage = document.getElementById("stage");
      if (by === "paste") stage.dispatchEvent(new ClipboardEvent("paste", { clipboardData: carried, bubbles: true, cancelable: true }));
      else for (const type of ["dragover", "drop"]) stage.dispatchEvent(new DragEvent(type, { dataTransfer: carried, bubbles: true, cancelable: true }));
    },
  };
}
