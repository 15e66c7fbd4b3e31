import { byId } from "./dom.ts";

/** Windows without a panel head, as in the style sheets. */
const SMALL = matchMedia("(width < 35rem), (width < 45rem) and (orientation: portrait), (height < 35rem)");

/** Sets up the panel's tabs, for pointer and keyboard. */
export function setUpTabs() {
  const tabs = allTabs();
  for (const [place, tab] of tabs.entries()) {
    tab.addEventListener("click", () => choose(tab));
    tab.addEventListener("keydown", (event) => {
      // A negative place counts from the end.
      const places: Record<string, number> = { ArrowRight: (place + 1) % tabs.length, ArrowLeft: place - 1, Home: 0, End: -1 };
      const next = tabs.at(places[event.key] ?? Number.POSITIVE_INFINITY);
      if (!next) return;
      event.preventDefault();
      event.stopPropagation();
      choose(next);
      next.focus();
    });
  }
  // Its target can be in another tab, another part and a closed section.
  byId("skip-link", HTMLAnchorElement).addEventListener("click", (event) => {
    event.preventDefault();
    choose(byId("tab-shape", HTMLButtonElement));
    const section = byId("section-landmark", HTMLDetailsElement);
    section.open = true;
    if (!section.checkVisibility()) document.querySelector<HTMLInputElement>("#shape input[value='point']")?.click();
    section.querySelector<HTMLElement>("input:checked")?.focus();
  });
  SMALL.addEventListener("change", placeSettings);
  // Chromium does not report that the query's result changed with the browser's font size.
  new ResizeObserver(placeSettings).observe(byId("panel-foot", HTMLElement));
  placeSettings();
}

/**
 * Resets the panel when another face opens: unfinished input, tab and scroll position.
 *
 * @param keepTab keep the tab, because the user chose another face of the same visit
 */
export function resetPanel(keepTab: boolean) {
  leaveField();
  if (!keepTab) choose(byId("tab-shape", HTMLButtonElement));
  // The page itself scrolls in tiny windows.
  scrollTo(0, 0);
}

/** Blurs the focused field of the panel without its change event, which would edit the new face. */
function leaveField() {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement) || !field.closest("#panel")) return;
  const suppress = (event: Event) => event.stopImmediatePropagation();
  addEventListener("change", suppress, true);
  field.blur();
  removeEventListener("change", suppress, true);
}

/** Selects a tab and scrolls to its top. */
function choose(chosen: HTMLButtonElement) {
  const sections = byId("sections", HTMLDivElement);
  document.body.dataset["tab"] = chosen.dataset["tabName"] ?? "shape";
  for (const tab of allTabs()) {
    tab.ariaSelected = String(tab === chosen);
    tab.tabIndex = tab === chosen ? 0 : -1;
  }
  sections.setAttribute("aria-labelledby", chosen.id);
  sections.scrollTop = 0;
}

/** Puts language and theme into the panel's head; in small windows, at the panel's end. */
function placeSettings() {
  const settings = byId("page-settings", HTMLDivElement);
  const place = byId(SMALL.matches ? "panel-foot" : "panel-head", HTMLElement);
  if (settings.parentElement === place) return;
  if (SMALL.matches) place.prepend(settings);
  else place.append(settings);
}

function allTabs() {
  return [...document.querySelectorAll<HTMLButtonElement>("[role=tab]")];
}
