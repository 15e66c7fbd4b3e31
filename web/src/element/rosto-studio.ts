import { init } from "../files.ts";
import { download } from "../page/download.ts";
import { languageFor, loadWords, setLanguage } from "../words/words.ts";
import { leadOf } from "../work/face.ts";
import { fileName } from "../work/file-name.ts";
import { FaceSession } from "./face-session.ts";
import { fetchedFile, pictureIn } from "./photo-source.ts";
import { RostoError } from "./rosto-error.ts";
import { Stage } from "./stage.ts";
import { stateOf, themeOf } from "./state.ts";
import type { Tool } from "./stage.ts";
import type { Intent } from "../../wasm/rosto-studio-web.js";

/** Attributes that set the studio's choice of the same name. */
const CHOICES = ["shading", "density", "lens"];

/**
 * `<rosto-studio>`: the face in a photo as a mesh that the user can rotate and reshape. The photo comes from `src` or
 * an `img` child. See docs/embed.md.
 */
export class RostoStudio extends HTMLElement {
  static observedAttributes = ["src", "lang", "controls", ...CHOICES];

  #shadow = this.attachShadow({ mode: "open" });
  #stage: Stage | undefined;
  #opened: Promise<FaceSession> | undefined;
  #session: FaceSession | undefined;
  #teardown = new AbortController();
  /** URL of the photo last given by the markup. */
  #photoUrl: string | undefined;

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

  attributeChangedCallback(name: string, _: string | null, value: string | null) {
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
   * @param photo file or URL
   */
  async open(photo: Blob | string) {
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
   * @param index from 0, most prominent first
   */
  async openFace(index: number) {
    const session = await this.#ready();
    await session.openFace(index).catch((error) => Promise.reject(RostoError.of(error)));
  }

  /**
   * Moves a landmark, as one edit; the surface deforms smoothly.
   *
   * @param landmark number in MediaPipe's mesh
   * @param offset_mm to the subject's left, up, and out of the face
   */
  moveLandmark(landmark: number, offset_mm: [x_mm: number, y_mm: number, z_mm: number]) {
    this.apply({ "select-at": landmark });
    const [x = 0, y = 0, z = 0] = this.#session?.host.read(({ offsetMm }) => offsetMm) ?? [];
    const [dx, dy, dz] = offset_mm;
    this.apply({ offset: [x + dx, y + dy, z + dz] });
    this.apply("commit");
  }

  /**
   * Sets a slider, as one edit.
   *
   * @param slider such as "nose-width"
   * @param to_mm new value
   */
  setSlider(slider: string, to_mm: number) {
    this.apply({ slide: [slider, to_mm] });
    this.apply("commit");
  }

  /**
   * Sets an expression, as one edit.
   *
   * @param expression ARKit name, such as "jawOpen"
   * @param to weight, 0 to 1
   */
  express(expression: string, to: number) {
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

  /** Applies any other intent, such as `{ zoom: 1.2 }`. If the studio rejects it, throws and changes nothing. */
  apply(intent: Intent) {
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
   * @param choices by id, such as `{ "base-colour": "photo" }`
   */
  getGlb(choices?: Record<string, string>) {
    return this.getFile("glb", choices);
  }

  /** Exports the face as glb, obj, ply, stl, 3mf, usdz or json. */
  async getFile(format: string, choices: Record<string, string> = {}) {
    try {
      return await (await this.#ready()).file(format, choices);
    } catch (error) {
      throw RostoError.of(error);
    }
  }

  async #open(stage: Stage, signal: AbortSignal): Promise<FaceSession> {
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

  #setUp(session: FaceSession, signal: AbortSignal) {
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

  #choose(session: FaceSession, choice: string, id: string) {
    if (session.host.read(({ chosen }) => chosen[choice]) === id) return;
    try {
      session.apply(({ [choice]: id } as Intent));
    } catch (error) {
      this.#fail(error);
    }
  }

  #key(event: KeyboardEvent) {
    if (!(event.ctrlKey || event.metaKey) || !/^[zy]$/i.test(event.key)) return;
    event.preventDefault();
    this.#use(event.shiftKey || event.key.toLowerCase() === "y" ? "redo" : "undo");
  }

  async #use(tool: Tool) {
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
      const chosen = state[(name as "shading" | "density" | "lens")];
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
   * @param owner part of the program that may hide it
   */
  #fail(thrown: unknown, owner?: string) {
    const error = RostoError.of(thrown);
    const { code, message, hint } = error;
    this.#stage?.showNotice(error, owner);
    this.#emit("rosto-error", { code, message, hint });
    return error;
  }

  #emit(type: string, detail?: unknown) {
    this.dispatchEvent(new CustomEvent(type, { bubbles: true, composed: true, detail }));
  }
}

if (!customElements.get("rosto-studio")) customElements.define("rosto-studio", RostoStudio);
