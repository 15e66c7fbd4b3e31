import { make } from "../page/dom.ts";
import { Panels } from "../panel/panels.ts";
import { onLocaleChange } from "../words/words.ts";
import base from "../../css/base.css";
import controls from "../../css/controls.css";
import panel from "../../css/panel.css";
import type { Host } from "../viewport/host.ts";

/** The page's sections that need nothing else of the page. */
const SECTIONS = ["section-face", "section-expressions", "section-history"];

/** The page's declarations in whose place the element has its own. */
const REPLACED = /(color-scheme|--(text|surface|line|accent)): [^;]*;/g;

/** Adds the page's Shape panel to an element. */
export function addPanel(host: Host, shadow: ShadowRoot) {
  const [aside, sections, sheet] = [make("aside", "panel"), make("div", "sections"), new CSSStyleSheet()];
  // The panel is the root of its styles.
  sheet.replaceSync([base, controls, panel].join("\n").replaceAll(":root", ".panel").replaceAll(REPLACED, ""));
  shadow.adoptedStyleSheets.unshift(sheet);
  aside.append(sections);
  shadow.append(aside);
  const place = (section: HTMLElement) => SECTIONS.includes(section.id) && sections.append(section);
  const panels = new Panels(place, (intent) => host.applyShown(intent), shadow);
  host.on("panel", (widgets) => panels.update(widgets));
  onLocaleChange(() => panels.translate(), host.closed);
  host.announce();
}
