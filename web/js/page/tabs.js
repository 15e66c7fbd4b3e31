import { byId } from "./dom.js";

/** Windows without room for a head of the panel's own, as the style sheets have it. */
const SMALL = matchMedia("(width < 560px), (width < 720px) and (orientation: portrait), (height < 560px)");

/** Where the arrow keys, Home and End lead from a tab. @type {Record<string, (place: number, count: number) => number>} */
const STEPS = {
  ArrowRight: (place, count) => (place + 1) % count,
  ArrowLeft: (place, count) => (place - 1 + count) % count,
  Home: () => 0,
  End: (_, count) => count - 1,
};

/** The panel's three tabs, by pointer and by keys. */
export function setUpTabs() {
  const tabs = allTabs();
  for (const [place, tab] of tabs.entries()) {
    tab.addEventListener("click", () => choose(tab));
    tab.addEventListener("keydown", (event) => {
      const next = tabs[STEPS[event.key]?.(place, tabs.length) ?? -1];
      if (!next) return;
      event.preventDefault();
      event.stopPropagation();
      choose(next);
      next.focus();
    });
  }
  byId("skip-link", HTMLAnchorElement).addEventListener("click", () => reveal("section-landmark"));
  SMALL.addEventListener("change", placeSettings);
  placeSettings();
}

/**
 * Shows a section of the panel, whichever tab or fold hides it.
 *
 * @param {string} id
 */
export function reveal(id) {
  const section = byId(id, HTMLElement);
  const name = section.closest("#sections > [data-tab]")?.getAttribute("data-tab");
  const tab = allTabs().find(({ dataset }) => dataset["tabName"] === name);
  if (tab && tab.getAttribute("aria-selected") !== "true") choose(tab);
  for (let fold = section.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null) fold.open = true;
}

/** A tab begins at its top. @param {HTMLButtonElement} chosen */
function choose(chosen) {
  const sections = byId("sections", HTMLDivElement);
  document.body.dataset["tab"] = chosen.dataset["tabName"] ?? "shape";
  for (const tab of allTabs()) {
    tab.setAttribute("aria-selected", String(tab === chosen));
    tab.tabIndex = tab === chosen ? 0 : -1;
  }
  sections.setAttribute("aria-labelledby", chosen.id);
  sections.scrollTop = 0;
}

/** Language and theme stand at the panel's head, or where there is none, at its end. */
function placeSettings() {
  const settings = byId("page-settings", HTMLDivElement);
  if (SMALL.matches) byId("panel-foot", HTMLElement).prepend(settings);
  else byId("panel-head", HTMLElement).append(settings);
}

function allTabs() {
  return /** @type {HTMLButtonElement[]} */ ([...document.querySelectorAll("[role=tab]")]);
}
