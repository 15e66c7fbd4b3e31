/**
 * @typedef {{ state: "empty" | "photo" | "face", busy: boolean, dialog: boolean, error: string | null, notice: string }} Seen
 *   the page's state, whether it is opening a file, whether a modal dialog is open, and the notice's code and text
 */

/** Installs `window.monkey`; runs in the page before its own scripts. */
export function installMonkey() {
  const USABLE = "button, input:not([type=file]), select, summary, [role=button], .slider-label";
  const TICKS = "[type=radio], [type=checkbox]";
  const SHUFFLED = ["section-landmark", "section-view", "section-history"].map((id) => `#${id} :is(select, ${TICKS})`).join();
  /** Prefers shaping. */
  const WEIGHT_OF_GROUP = { "section-landmark": 8, "section-view": 3, "section-history": 3 };
  /** Prefers selects, which change how edits behave, and opening folds; avoids slow actions. */
  const WEIGHTS = [
    ["[data-action=run-paper], [data-action=camera], [data-action=close-camera]", 1],
    ["select", 15],
    [TICKS, 8],
    ["details:not([open]) > summary", 20],
    ["summary", 1],
    ["*", 5],
  ];

  const surface = (element) => (element.matches(TICKS) && element.closest("label")) || element;
  const isUsable = (element) => {
    const { width } = surface(element).getBoundingClientRect();
    return width > 0 && !element.matches(":disabled") && surface(element).checkVisibility({ visibilityProperty: true });
  };
  const usable = () => [...(document.querySelector("dialog:modal") ?? document).querySelectorAll(USABLE)].filter(isUsable);
  const groupOf = (element) => element.closest("dialog, details.section, .toolbar, header, footer, section, main")?.id ?? "";
  const weightOf = (element) => WEIGHTS.find(([selector]) => element.matches(selector))[1];
  /** Picks an item by a number from 0 to 1, in proportion to the weights. */
  const pick = (list, weightOf, share) => {
    const tickets = list.flatMap((one) => Array.from({ length: weightOf(one) }, () => one));
    return tickets[Math.floor(share * tickets.length)];
  };
  const short = (text) => text.trim().replaceAll(/\s+/g, " ");
  const set = (element, key, value) => {
    element[key] = value;
    for (const type of ["input", "change"]) element.dispatchEvent(new Event(type, { bubbles: true }));
  };
  const choose = (select, share) => {
    // Software rendering is slow on dense meshes, so choose them rarely.
    const place = select.id === "density" ? share ** 6 : share;
    // A placeholder is hidden.
    const options = [...select.options].filter(({ hidden }) => !hidden);
    set(select, "value", options[Math.floor(place * options.length)].value);
  };

  window["monkey"] = {
    /** State of the page after some frames. */
    look: async (frames) => {
      for (let frame = 0; frame < frames; frame++) await new Promise(requestAnimationFrame);
      const [notice, progress] = ["notice", "progress"].map((id) => document.getElementById(id));
      return {
        state: document.body.dataset["state"],
        busy: progress?.hidden === false,
        dialog: document.querySelector("dialog:modal") !== null,
        error: notice?.hidden === false ? notice.dataset["code"] : null,
        notice: short(notice?.innerText ?? ""),
      };
    },
    /** Chooses the section first, so that the number of its controls does not matter. */
    choose: ({ group, control }) => {
      const all = usable();
      const chosen = pick([...new Set(all.map(groupOf))], (name) => WEIGHT_OF_GROUP[name] ?? 2, group);
      const element = pick(all.filter((one) => groupOf(one) === chosen), weightOf, control);
      if (!element) return null;
      surface(element).scrollIntoView({ block: "center" });
      window["monkey"].chosen = element;
      const kind = element.matches(".slider-label") ? "label" : element.matches("input") ? element.type : element.localName;
      const label = short(element.getAttribute("aria-label") ?? surface(element).textContent).slice(0, 40);
      return { kind, label, box: surface(element).getBoundingClientRect().toJSON() };
    },
    /** Focuses the chosen field, with its text selected. */
    enter: () => {
      const { chosen } = window["monkey"];
      chosen.focus();
      if (chosen.type !== "range") chosen.select();
    },
    /** Sets a value that users choose in a native popup: an option or a colour. */
    set: (share) => {
      const { chosen } = window["monkey"];
      if (chosen.matches("select")) choose(chosen, share);
      else set(chosen, "value", `#${Math.floor(share * 0x1000000).toString(16).padStart(6, "0")}`);
    },
    /** Changes several choices in one task, to reach rare combinations. */
    shuffle: (picks) => {
      for (const { control, value } of picks) {
        const element = pick(usable().filter((one) => one.matches(SHUFFLED)), weightOf, control);
        if (element?.matches("select")) choose(element, value);
        else element?.click();
      }
    },
    /** Clicks a button even if it is not visible; returns whether it is enabled. */
    press: (selector) => {
      const element = document.querySelector(selector);
      if (!element || element.matches(":disabled")) return false;
      element.click();
      return true;
    },
    bring: ({ base64, name, by }) => {
      const files = new DataTransfer();
      files.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name));
      const how = { bubbles: true, cancelable: true, clipboardData: files, dataTransfer: files };
      const events = by === "paste" ? [new ClipboardEvent("paste", how)] : ["dragover", "drop"].map((type) => new DragEvent(type, how));
      for (const event of events) document.getElementById("stage").dispatchEvent(event);
    },
  };
}
