/**
 * What a visitor sees of the page, as the page itself looks it up.
 *
 * @typedef {object} Control something that can be used now
 * @property {string} at a selector that finds it again
 * @property {string} label what it says
 * @property {string} group the part of the page that it is in
 * @property {"button" | "tick" | "select" | "range" | "number" | "text" | "colour" | "fold" | "label"} kind
 * @property {string} action its `data-action`, if it has one
 * @property {number} options of a select
 * @property {boolean} open whether a fold shows what is in it
 *
 * @typedef {object} Box in CSS px of the window
 * @property {number} x
 * @property {number} y
 * @property {number} width
 * @property {number} height
 *
 * @typedef {object} Seen
 * @property {string} state of the page: "empty", "photo" or "face"
 * @property {boolean} busy whether a file is being opened
 * @property {boolean} dialog whether a dialog covers the page
 * @property {string | null} error the code of the notice that is shown
 * @property {string} said what the notice says
 * @property {Control[]} controls
 * @property {Box | null} view the 3D view
 * @property {Box | null} photo the small photo
 */

/** Gives the page eyes under the name `__eyes`; runs in the page, before its own scripts. */
export function openEyes() {
  const USABLE = "button, input:not([type=file]), select, summary, [role=button], .slider-label";

  /** @param {Element} element */
  const surface = (element) => (element.matches("input[type=radio], input[type=checkbox]") && element.closest("label")) || element;

  /** @param {Element} element */
  const boxOf = (element) => {
    const { x, y, width, height } = surface(element).getBoundingClientRect();
    return { x, y, width, height };
  };

  /** @param {Element | null} element */
  const visibleBox = (element) => {
    if (!element || !surface(element).checkVisibility({ visibilityProperty: true })) return null;
    const box = boxOf(element);
    return box.width > 0 && box.height > 0 ? box : null;
  };

  /** @param {Element} element */
  const pathTo = (element) => {
    const steps = [];
    let at = element;
    while (!at.id && at.parentElement) {
      const same = [...at.parentElement.children].filter(({ localName }) => localName === at.localName);
      steps.unshift(`${at.localName}:nth-of-type(${same.indexOf(at) + 1})`);
      at = at.parentElement;
    }
    return [at.id ? `#${at.id}` : at.localName, ...steps].join(" > ");
  };

  /** @param {Element} element */
  const kindOf = (element) => {
    if (element.matches("select")) return "select";
    if (element.matches("summary")) return "fold";
    if (element.matches(".slider-label")) return "label";
    if (!element.matches("input")) return "button";
    const kinds = { radio: "tick", checkbox: "tick", range: "range", number: "number", color: "colour" };
    return kinds[element.type] ?? "text";
  };

  /** @param {Element} element */
  const controlOf = (element) => ({
    at: pathTo(element),
    label: (element.getAttribute("aria-label") ?? surface(element).textContent ?? "").trim().replaceAll(/\s+/g, " ").slice(0, 40),
    group: element.closest("dialog, details.section, .toolbar, header, footer, section, main")?.id ?? "",
    kind: kindOf(element),
    action: element.getAttribute("data-action") ?? "",
    options: element.matches("select") ? element.options.length : 0,
    open: element.parentElement?.hasAttribute("open") ?? false,
  });

  const look = () => {
    const covering = document.querySelector("dialog:modal");
    const notice = document.getElementById("notice");
    const isTroubled = notice !== null && !notice.hidden;
    const usable = [...(covering ?? document).querySelectorAll(USABLE)];
    return {
      state: document.body.dataset["state"] ?? "",
      busy: document.getElementById("progress")?.hidden === false,
      dialog: covering !== null,
      error: isTroubled ? (notice.dataset["code"] ?? "") : null,
      said: isTroubled ? notice.innerText.trim().replaceAll(/\s+/g, " ") : "",
      controls: usable.filter((element) => !element.matches(":disabled") && visibleBox(element)).map(controlOf),
      view: visibleBox(document.getElementById("viewport")),
      photo: visibleBox(document.getElementById("photo-picture")),
    };
  };

  window["__eyes"] = {
    look,
    /** Looks once so many frames have been drawn. */
    settle: async (/** @type {number} */ frames) => {
      for (let frame = 0; frame < frames; frame++) await new Promise(requestAnimationFrame);
      return look();
    },
    /** Scrolls a control into view and says where it is, if it is there at all. */
    aim: (/** @type {string} */ at) => {
      const element = document.querySelector(at);
      if (!element || !visibleBox(element)) return null;
      surface(element).scrollIntoView({ block: "center" });
      return boxOf(element);
    },
    /** Puts the focus into a field, with all that is in it selected. */
    enter: (/** @type {string} */ at) => {
      const element = document.querySelector(at);
      if (!(element instanceof HTMLInputElement) || !visibleBox(element)) return false;
      element.focus();
      if (element.type !== "range") element.select();
      return true;
    },
    /** Sets what a browser's own window would set: the choice of a select, a colour. */
    set: (/** @type {string} */ at, /** @type {string | number} */ value) => {
      const element = document.querySelector(at);
      if (!(element instanceof HTMLSelectElement || element instanceof HTMLInputElement)) return;
      if (typeof value === "number" && element instanceof HTMLSelectElement) element.selectedIndex = value;
      else element.value = String(value);
      for (const type of ["input", "change"]) element.dispatchEvent(new Event(type, { bubbles: true }));
    },
    /** Presses a button wherever it is, as a key or a screen reader would. */
    press: (/** @type {string} */ at) => {
      const element = document.querySelector(at);
      if (element instanceof HTMLElement && !element.matches(":disabled")) element.click();
    },
    /** Brings a file to the page. */
    bring: (/** @type {{ base64: string, name: string, type: string, by: "drop" | "paste" }} */ { base64, name, type, by }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const carried = new DataTransfer();
      carried.items.add(new File([bytes], name, { type }));
      const target = document.getElementById("stage") ?? document.body;
      if (by === "paste") {
        target.dispatchEvent(new ClipboardEvent("paste", { clipboardData: carried, bubbles: true, cancelable: true }));
        return;
      }
      for (const event of ["dragover", "drop"]) {
        target.dispatchEvent(new DragEvent(event, { dataTransfer: carried, bubbles: true, cancelable: true }));
      }
    },
  };
}
