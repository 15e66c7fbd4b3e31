import { byId } from "../page/dom.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").StudioState} StudioState
 */

/** The options of an edit that are not lists: symmetry, influence radius, pins and marks. */
export class EditOptions {
  #mirror = byId("mirror", HTMLInputElement);
  #nearby = byId("nearby", HTMLInputElement);
  #pinned = byId("pinned", HTMLInputElement);
  #anchorsMarked = byId("anchors-shown", HTMLInputElement);
  #host;
  #radius;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#radius = this.#makeRadius();
    this.#mirror.addEventListener("change", () => host.act((studio) => studio.setMirror(this.#mirror.checked)));
    this.#nearby.addEventListener("change", () => host.act((studio) => studio.setNearby(this.#nearby.checked)));
    this.#pinned.addEventListener("change", () => host.act((studio) => studio.setPinned(this.#pinned.checked)));
    this.#anchorsMarked.addEventListener("change", () => host.act((studio) => studio.setAnchorsMarked(this.#anchorsMarked.checked)));
    host.onChange((state) => this.#show(state));
  }

  #makeRadius() {
    const apply = () => this.#host.act((studio) => studio.setRadius(this.#radius.value));
    const { min, max, step, neutral } = this.#host.answer((studio) => studio.radiusRange);
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
