import { byId } from "../page/dom.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").StudioState} StudioState
 */

/** How the surface follows a landmark, apart from what is chosen from lists. */
export class EditOptions {
  #mirror = byId("mirror", HTMLInputElement);
  #nearby = byId("nearby", HTMLInputElement);
  #pinned = byId("pinned", HTMLInputElement);
  #anchorsMarked = byId("anchors-shown", HTMLInputElement);
  #bench;
  #radius;

  /** @param {Workbench} bench */
  constructor(bench) {
    this.#bench = bench;
    this.#radius = this.#makeRadius();
    this.#mirror.addEventListener("change", () => bench.act((studio) => studio.setMirror(this.#mirror.checked)));
    this.#nearby.addEventListener("change", () => bench.act((studio) => studio.setNearby(this.#nearby.checked)));
    this.#pinned.addEventListener("change", () => bench.act((studio) => studio.setPinned(this.#pinned.checked)));
    this.#anchorsMarked.addEventListener("change", () => bench.act((studio) => studio.setAnchorsMarked(this.#anchorsMarked.checked)));
    bench.onChange((state) => this.#show(state));
  }

  #makeRadius() {
    const apply = () => this.#bench.act((studio) => studio.setRadius(this.#radius.value));
    const { min, max, step, neutral } = this.#bench.answer((studio) => studio.radiusRange);
    const radius = new Slider({
      label: "edit.radius",
      longLabel: "edit.radius.long",
      unit: "mm",
      ...{ min, max, step, neutral },
      onInput: apply,
      onCommit: apply,
      onCancel: () => {},
    });
    byId("radius", HTMLDivElement).append(radius.element);
    return radius;
  }

  /** @param {StudioState} state */
  #show({ mirror, nearby, radiusMm, pinned, selected, canMirror, anchorsMarked }) {
    this.#anchorsMarked.checked = anchorsMarked;
    this.#mirror.checked = mirror;
    this.#mirror.disabled = !canMirror;
    byId("mirror-help", HTMLParagraphElement).hidden = canMirror;
    this.#nearby.checked = nearby;
    byId("radius", HTMLDivElement).hidden = !nearby;
    this.#radius.value = radiusMm;
    this.#pinned.disabled = selected === undefined;
    this.#pinned.checked = pinned;
  }
}
