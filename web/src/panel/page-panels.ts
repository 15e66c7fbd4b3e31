import { byId, onAction } from "../page/dom.ts";
import { remember, remembered } from "../page/remember.ts";
import type { Host } from "../viewport/host.ts";
import { setPointNumbersShown } from "../words/names.ts";
import { notifyLocaleChange, onLocaleChange } from "../words/words.ts";
import { setUpLandmarkSearch } from "./landmark-search.ts";
import { setUpLightSphere } from "./light-sphere.ts";
import { Panels } from "./panels.ts";

/** Shows the panels that the studio describes. */
export function setUpPanels(host: Host) {
  setUpLandmarkSearch(host);
  setUpLightSphere(host);
  const panels = new Panels(place, (intent) => host.applyShown(intent));
  host.on("panel", (widgets) => panels.update(widgets));
  onLocaleChange(() => panels.translate());
  onAction("reset-view", () => host.apply({ "go-to": "reset" }));
  setUpExpert(host);
}

/** Puts a section before those of the page, or a single widget into its place. */
function place(section: HTMLElement) {
  const there = document.querySelector(`[data-place="${section.id || section.querySelector("[id]")?.id}"]`);
  // The toolbar names its choices for screen readers only.
  if (there?.closest("[role=toolbar]")) section.querySelector("legend")?.classList.add("visually-hidden");
  if (there) there.replaceChildren(section);
  else byId("panel-foot", HTMLElement).before(section);
}

/** The switch that shows technical controls and point numbers. */
function setUpExpert(host: Host) {
  const box = byId("expert", HTMLInputElement);
  const apply = () => {
    document.documentElement.toggleAttribute("data-expert-on", box.checked);
    setPointNumbersShown(box.checked);
    host.apply({ expert: box.checked });
  };
  box.checked = remembered("expert") === "on";
  box.addEventListener("change", () => {
    remember("expert", box.checked ? "on" : "off");
    apply();
    notifyLocaleChange();
  });
  apply();
  host.onRestart(async () => apply());
}
