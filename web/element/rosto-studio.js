import { init } from "../src/files.ts";
import { download } from "../js/page/download.js";
import { languageFor, loadWords, setLanguage } from "../js/words/words.js";
import { leadOf } from "../js/work/face.js";
import { fileName } from "../js/work/file-name.js";
import { FaceSession } from "./face-session.js";
import { fetchedFile, pictureIn } from "./photo-source.js";
import { RostoError } from "./rosto-error.js";
import { Stage } from "./stage.js";
import { stateOf, themeOf } from "./state.js";

/**
 * @typedef {import("./stage.js").Tool} Tool
 * @typedef {import("./state.js").StudioSnapshot} StudioSnapshot
 * @typedef {import("../js/viewport/host.js").Intent} Intent
 */

/** Attributes that set the studio's choice of the same name. */
const CHOICES = ["shading", "density", "lens"];

/**
 * `<rosto-studio>`: the face in a photo as a mesh that the user can rotate and reshape. The photo comes from `src` or
 * an `img` child. See docs/embed.md.
 */
export class RostoStudio extends HTMLElement {
  static observedAttributes = ["src", "lang", "controls", ...CHOICES];

  #shadow = this.attachShadow({ mode: "open" });
  /** @type {Stage | undefined} */
  #stage;
  /** @type {Promise<FaceSession> | undefined} */
  #opened;
  /** @type {FaceSession | undefined} */
  #session;
  #teardown = new AbortController();
  /** URL of the photo last given by the markup. @type {string | undefined} */
  #photoUrl;

  connectedCallback() {
    // Still open if the element was only moved within the page.
    if (this.#opened) return;
    this.#teardown = new AbortController();
    const { signal } = this.#teardown;
    this.#stage = new Stage(this.#shadow);
    this.#opened = this.#open(this.#stage, signal);
    this.#opened.then(() => this.#emit("rosto-ready"), (error) => signal.aborted || this.#fail(error));
    const update = () => this.#openFromMarkup();
    this.#stage.slot.addEventListener("slotchange", update);
    // An image's load and error events do not bubble.
    for (const type of ["load", "error"]) this.addEventListener(type, update, { capture: true, signal });
    update();
  }

  disconnectedCallback() {
    setTimeout(() => {
      if (!this.isConnected) this.#close();
    });
  }

  /** @param {string} name @param {string | null} _ @param {string | null} value */
  attributeChangedCallback(name, _, value) {
    // Initial attributes are read when the element is connected.
    if (!this.#opened) return;
    if (name === "src") this.#openFromMarkup();
    else if (name === "lang") this.#updateLanguage();
    else if (name === "controls") this.#showTools();
    else if (value !== null && this.#session) this.#choose(this.#session, name, value);
  }

  /** URL of the photo. Setting it opens the photo. */
  get src() {
    return this.getAttribute("src") ?? "";
  }

  set src(url) {
    this.setAttribute("src", url);
  }

  /** Whether the tools are shown. */
  get controls() {
    return this.hasAttribute("controls");
  }

  set controls(shown) {
    this.toggleAttribute("controls", shown);
  }

  /** A snapshot of the element's state. */
  get state() {
    return stateOf(this.#session);
  }

  /**
   * Opens a photo, GLB or project, and resolves once its face is shown. Errors are thrown and also dispatched as
   * `rosto-error`. A newer call cancels the pending one, which then resolves without effect.
   *
   * @param {Blob | string} photo file or URL
   */
  async open(photo) {
    const file = Promise.resolve(typeof photo === "string" ? fetchedFile(new URL(photo, this.baseURI).href) : photo);
    file.catch(() => {});
    const session = await this.#ready();
    try {
      await session.open(file);
    } catch (error) {
      if (this.#teardown.signal.aborted) return;
      throw this.#fail(error);
    }
  }

  /**
   * Shows another face of the same photo.
   *
   * @param {number} index from 0, most prominent first
   */
  async openFace(index) {
    const session = await this.#ready();
    await session.openFace(index).catch((error) => Promise.reject(RostoError.of(error)));
  }

  /**
   * Moves a landmark, as one edit; the surface deforms smoothly.
   *
   * @param {number} landmark number in MediaPipe's mesh
   * @param {[x_mm: number, y_mm: number, z_mm: number]} offset_mm to the subject's left, up, and out of the face
   */
  moveLandmark(landmark, offset_mm) {
    this.apply({ "select-at": landmark });
    const [x = 0, y = 0, z = 0] = this.#session?.host.read(({ offsetMm }) => offsetMm) ?? [];
    const [dx, dy, dz] = offset_mm;
    this.apply({ offset: [x + dx, y + dy, z + dz] });
    this.apply("commit");
  }

  /**
   * Sets a slider, as one edit.
   *
   * @param {string} slider such as "nose-width"
   * @param {number} to_mm new value
   */
  setSlider(slider, to_mm) {
    this.apply({ slide: [slider, to_mm] });
    this.apply("commit");
  }

  /**
   * Sets an expression, as one edit.
   *
   * @param {string} expression ARKit name, such as "jawOpen"
   * @param {number} to weight, 0 to 1
   */
  express(expression, to) {
    this.apply({ express: [expression, to] });
    this.apply("commit");
  }

  undo() {
    this.apply("undo");
  }

  redo() {
    this.apply("redo");
  }

  /** Removes all edits, as one undoable step. */
  reset() {
    this.apply("reset");
  }

  /**
   * Applies any other intent, such as `{ zoom: 1.2 }`. If the studio rejects it, throws and changes nothing.
   *
   * @param {Intent} intent
   */
  apply(intent) {
    try {
      if (!this.#session) throw new RostoError("not-ready", "the element is not ready yet; wait for rosto-ready");
      this.#session.apply(intent);
      // The session reports document changes only, and a choice changes the view only.
      this.#reflectState();
    } catch (error) {
      throw RostoError.of(error);
    }
  }

  /**
   * Exports the face as GLB.
   *
   * @param {Record<string, string>} [choices] by id, such as `{ "base-colour": "photo" }`
   */
  getGlb(choices) {
    return this.getFile("glb", choices);
  }

  /**
   * Exports the face as glb, obj, ply, stl, 3mf, usdz or json.
   *
   * @param {string} format
   * @param {Record<string, string>} [choices]
   */
  async getFile(format, choices = {}) {
    try {
      return await (await this.#ready()).file(format, choices);
    } catch (error) {
      throw RostoError.of(error);
    }
  }

  /** @param {Stage} stage @param {AbortSignal} signal @returns {Promise<FaceSession>} */
  async #open(stage, signal) {
    const base = this.getAttribute("base");
    if (base !== null) init(new URL(base, this.baseURI));
    await loadWords(this.#language()).catch((error) => Promise.reject(new RostoError("not-loaded", String(error))));
    stage.addTools((tool) => this.#use(tool), signal);
    const session = await FaceSession.open(stage.canvas, {
      progress: (step, fraction) => stage.showProgress(step, fraction),
      ended: () => stage.hideProgress(),
      face: () => this.#showFace(),
      change: () => this.#change(),
      announce: () => this.#reflectState(),
      error: (thrown, owner) => this.#fail(thrown, owner),
      settled: (owner) => stage.hideNotice(owner),
    }, stage.tag);
    if (signal.aborted) {
      session.close();
      throw new RostoError("closed", "the element was removed from the page");
    }
    this.#setUp(session, signal);
    return session;
  }

  /** @param {FaceSession} session @param {AbortSignal} signal */
  #setUp(session, signal) {
    this.#session = session;
    const [reducedMotion, dark] = ["(prefers-reduced-motion: reduce)", "(prefers-color-scheme: dark)"].map((query) => matchMedia(query));
    const applyPreferences = () => {
      session.host.apply({ theme: themeOf(this) });
      session.host.apply({ "reduced-motion": reducedMotion?.matches ?? false });
    };
    for (const query of [reducedMotion, dark]) query?.addEventListener("change", applyPreferences, { signal });
    applyPreferences();
    session.host.onRestart(async () => applyPreferences());
    for (const name of CHOICES) {
      const value = this.getAttribute(name);
      if (value !== null) this.#choose(session, name, value);
    }
    this.addEventListener("keydown", (event) => this.#key(event), { signal });
  }

  #close() {
    this.#teardown.abort();
    this.#session?.close();
    [this.#session, this.#opened, this.#photoUrl] = [undefined, undefined, undefined];
    this.#shadow.replaceChildren();
  }

  #ready() {
    return this.#opened ?? Promise.reject(new RostoError("not-ready", "the element is not on a page"));
  }

  #openFromMarkup() {
    const url = this.getAttribute("src") ?? pictureIn(this);
    if (!url || url === this.#photoUrl) return;
    this.#photoUrl = url;
    // Errors are dispatched as rosto-error.
    this.open(url).catch(() => {});
  }

  #updateLanguage() {
    this.#opened?.then(() => setLanguage(languageFor(this.#language()))).catch(() => {});
  }

  #language() {
    return this.closest("[lang]")?.getAttribute("lang") ?? navigator.language;
  }

  /** @param {FaceSession} session @param {string} choice @param {string} id */
  #choose(session, choice, id) {
    if (session.host.read(({ chosen }) => chosen[choice]) === id) return;
    try {
      session.apply(/** @type {Intent} */ ({ [choice]: id }));
    } catch (error) {
      this.#fail(error);
    }
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (!(event.ctrlKey || event.metaKey) || !/^[zy]$/i.test(event.key)) return;
    event.preventDefault();
    this.#use(event.shiftKey || event.key.toLowerCase() === "y" ? "redo" : "undo");
  }

  /** @param {Tool} tool */
  async #use(tool) {
    if (tool !== "download") return this[tool]();
    const file = await this.getGlb().catch((error) => this.#fail(error));
    if (file instanceof Blob) download(file, fileName(this.#session?.face, "glb"), file.type);
  }

  #showFace() {
    if (!this.#session) return;
    this.#stage?.showFace();
    this.#showTools();
    const { face, faces } = this.#session;
    if (!face) return;
    const { landmarks, width_px, height_px } = leadOf(face);
    this.#emit("rosto-face", { landmarks, width_px, height_px, faces: faces.length, index: faces.indexOf(face) });
  }

  #change() {
    this.#stage?.hideNotice();
    this.#emit("rosto-change", this.state);
  }

  /** Reflects the studio's choices in the attributes, and enables the tools that apply. */
  #reflectState() {
    const { state } = this;
    for (const name of CHOICES) {
      const chosen = state[/** @type {"shading" | "density" | "lens"} */ (name)];
      if (this.hasAttribute(name) && chosen !== undefined && this.getAttribute(name) !== chosen) this.setAttribute(name, chosen);
    }
    this.#stage?.enableTools({ undo: state.canUndo, redo: state.canRedo, reset: state.edits > 0, download: true });
  }

  #showTools() {
    const covered_px = this.#stage?.showTools(this.controls) ?? 0;
    this.#session?.host.apply({ "viewport-insets": [0, 0, covered_px * devicePixelRatio, 0] });
  }

  /**
   * Shows an error in the element and dispatches it as `rosto-error`.
   *
   * @param {unknown} thrown
   * @param {string} [owner] part of the program that may hide it
   */
  #fail(thrown, owner) {
    const error = RostoError.of(thrown);
    const { code, message, hint } = error;
    this.#stage?.showNotice(error, owner);
    this.#emit("rosto-error", { code, message, hint });
    return error;
  }

  /** @param {string} type @param {unknown} [detail] */
  #emit(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { bubbles: true, composed: true, detail }));
  }
}

if (!customElements.get("rosto-studio")) customElements.define("rosto-studio", RostoStudio);
