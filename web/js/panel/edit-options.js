import { byId } from "../page/dom.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").State} State
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
    this.#mirror.addEventListener("change", () => host.apply({ mirror: this.#mirror.checked }));
    this.#nearby.addEventListener("change", () => host.apply({ nearby: this.#nearby.checked }));
    this.#pinned.addEventListener("change", () => host.apply({ pin: this.#pinned.checked }));
    this.#anchorsMarked.addEventListener("change", () => host.apply({ "mark-anchors": this.#anchorsMarked.checked }));
    host.onChange((state) => this.#show(state));
  }

  #makeRadius() {
    const apply = () => this.#host.apply({ radius: this.#radius.value });
    const radius = new Slider({
      label: "edit.radius",
      longLabel: "edit.radius.long",
      unit: "mm",
      ...this.#host.catalogue.radius,
      onInput: apply,
      onCommit: apply,
      onCancel: () => {},
    });
    byId("radius", HTMLDivElement).append(radius.element);
    return radius;
  }

  /** @param {State} state */
  #show({ mirror, nearby, radiusMm, isPinned, selected, canMirror, anchorsMarked }) {
    this.#anchorsMarked.checked = anchorsMarked;
    this.#mirror.checked = mirror;
    this.#mirror.disabled = !canMirror;
    byId("mirror-help", HTMLParagraphElement).hidden = canMirror;
    this.#nearby.checked = nearby;
    byId("radius", HTMLDivElement).hidden = !nearby;
    this.#radius.value = radiusMm;
    this.#pinned.disabled = selected === undefined;
    this.#pinned.checked = isPinned;
  }
}
