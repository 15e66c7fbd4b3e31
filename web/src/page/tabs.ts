import { byId } from "./dom.ts";

/** Windows without a panel head, as in the style sheets. */
const SMALL = matchMedia("(width < 560px), (width < 720px) and (orientation: portrait), (height < 560px)");

/** Index of the tab that a key selects. */
const NEXT_TAB: Record<string, (place: number, count: number) => number> = {
  ArrowRight: (place, count) => (place + 1) % count,
  ArrowLeft: (place, count) => (place - 1 + count) % count,
  Home: () => 0,
  End: (_, count) => count - 1,
};

/** Sets up the panel's tabs, for pointer and keyboard. */
export function setUpTabs() {
  const tabs = allTabs();
  for (const [place, tab] of tabs.entries()) {
    tab.addEventListener("click", () => choose(tab));
    tab.addEventListener("keydown", (event) => {
      const next = tabs[NEXT_TAB[event.key]?.(place, tabs.length) ?? -1];
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

/** Shows a section: selects its tab and opens the folds around it. */
export function reveal(id: string) {
  const section = byId(id, HTMLElement);
  const name = section.closest("#sections > [data-tab]")?.getAttribute("data-tab");
  const tab = allTabs().find(({ dataset }) => dataset["tabName"] === name);
  if (tab && tab.getAttribute("aria-selected") !== "true") choose(tab);
  for (let fold = section.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null) fold.open = true;
}

/** Selects a tab and scrolls to its top. */
function choose(chosen: HTMLButtonElement) {
  const sections = byId("sections", HTMLDivElement);
  document.body.dataset["tab"] = chosen.dataset["tabName"] ?? "shape";
  for (const tab of allTabs()) {
    tab.setAttribute("aria-selected", String(tab === chosen));
    tab.tabIndex = tab === chosen ? 0 : -1;
  }
  sections.setAttribute("aria-labelledby", chosen.id);
  sections.scrollTop = 0;
}

/** Puts language and theme into the panel's head; in small windows, at the panel's end. */
function placeSettings() {
  const settings = byId("page-settings", HTMLDivElement);
  if (SMALL.matches) byId("panel-foot", HTMLElement).prepend(settings);
  else byId("panel-head", HTMLElement).append(settings);
}

function allTabs() {
  return ([...document.querySelectorAll("[role=tab]")] as HTMLButtonElement[]);
}
