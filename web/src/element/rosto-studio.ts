import { fileUrl, init } from "../files.ts";
import { download } from "../page/download.ts";
import { scriptUrl } from "../trusted.ts";
import { languageFor, loadWords, onLocaleChange, setLanguage } from "../words/words.ts";
import { leadOf } from "../work/face.ts";
import { fileName } from "../work/file-name.ts";
import { RostoError, finite, index, oneOf, point, text } from "./checks.ts";
import { FaceSession } from "./face-session.ts";
import { hasSize, photoFile, untilShown } from "./host-page.ts";
import { Stage } from "./stage.ts";
import type { Tool } from "./stage.ts";
import type { Host } from "../viewport/host.ts";
import type { Intent, State } from "../../wasm/rosto-studio-web.js";

/** Attributes that set the studio's choice of the same name. */
const CHOICES = ["shading", "density", "lens"] as const;

/**
 * `<rosto-studio>`: the face in a photo as a mesh that the user can rotate and reshape. The photo comes from `src` or
 * an `img` child. See docs/embed.md.
 */
export class RostoStudio extends HTMLElement {
  static observedAttributes = ["src", "lang", "controls", "panel", ...CHOICES];

  #shadow = this.attachShadow({ mode: "open" });
  #stage: Stage | undefined;
  #opened: Promise<FaceSession> | undefined;
  #session: FaceSession | undefined;
  /** Why the session did not open. */
  #failure: RostoError | undefined;
  #teardown = new AbortController();
  #panel: Promise<void> | undefined;
  /** URL of the photo last given by the markup. */
  #photoUrl: string | undefined;

  connectedCallback() {
    // Still open if the element was only moved within the page.
    if (this.#opened) return;
    this.#teardown = new AbortController();
    const { signal } = this.#teardown;
    const stage = new Stage(this.#shadow, (tool) => this.#use(tool));
    this.#stage = stage;
    this.#opened = this.#later(() => this.#open(stage, signal));
    this.#opened.then(() => this.#emit("rosto-ready"), (error) => {
      if (!signal.aborted) this.#failure = this.#fail(error);
    });
    const update = () => this.#openFromMarkup();
    this.#shadow.addEventListener("slotchange", update, { signal });
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
    else if (name === "lang") this.#opened.then(() => setLanguage(languageFor(this.#language()))).catch(() => {});
    else if (name === "controls" || name === "panel") this.#showTools();
    else if (value !== null && this.#session) this.#choose(this.#session, name, value);
  }

  /** URL of the photo. Setting it opens the photo. */
  get src() {
    return this.getAttribute("src") ?? "";
  }

  set src(url) {
    this.setAttribute("src", text("src", url));
  }

  /** Whether the tools are shown. */
  get controls() {
    return this.hasAttribute("controls");
  }

  set controls(shown) {
    this.toggleAttribute("controls", Boolean(shown));
  }

  /** A snapshot of the element's state. */
  get state() {
    const state = this.#session?.host.read((state) => state);
    const chosen: State["chosen"] = state?.chosen ?? {};
    return {
      /** to show a face */
      ready: state !== undefined,
      /** in the photo; 0 before a face is shown */
      faces: this.#session?.faces.length ?? 0,
      /** of the displayed mesh */
      vertices: state?.vertexCount ?? 0,
      /** in the history */
      edits: state?.entryCount ?? 0,
      canUndo: state?.canUndo ?? false,
      canRedo: state?.canRedo ?? false,
      /** landmark or vertex */
      selected: state?.selected,
      ...{ shading: chosen["shading"], density: chosen["density"], lens: chosen["lens"] },
      /** value of each slider */
      sliders_mm: state?.slidersMm ?? {},
    };
  }

  /**
   * Opens a photo, GLB or project, and resolves once its face is shown. Errors are thrown and also dispatched as
   * `rosto-error`. A newer call cancels the pending one, which then resolves without effect.
   *
   * @param photo file or URL
   */
  async open(photo: Blob | string) {
    await this.#later(async () => {
      const file = photoFile(photo, this.baseURI);
      file.catch(() => {});
      const session = await this.#ready();
      await session.open(file).catch((error) => {
        if (!this.#teardown.signal.aborted) throw this.#fail(error);
      });
    });
  }

  /**
   * Shows another face of the same photo.
   *
   * @param index from 0, most prominent first
   */
  openFace(index: number) {
    return this.#later(async () => (await this.#ready()).openFace(index));
  }

  /**
   * Moves a landmark, as one edit; the surface deforms smoothly.
   *
   * @param landmark number in MediaPipe's mesh
   * @param offset_mm to the subject's left, up, and out of the face
   */
  moveLandmark(landmark: number, offset_mm: [x_mm: number, y_mm: number, z_mm: number]) {
    this.#now(({ host }) => {
      const vertex = index("landmark", landmark, host.catalogue.landmarks.length);
      const [dx, dy, dz] = point("offset_mm", offset_mm);
      host.attempt({ select: { landmark: vertex } });
      const [x, y, z] = host.answer((studio) => studio.state().offsetMm);
      return [{ offset: [x + dx, y + dy, z + dz] }, "commit"];
    });
  }

  /**
   * Sets a slider, as one edit.
   *
   * @param slider such as "nose-width"
   * @param to_mm new value
   */
  setSlider(slider: string, to_mm: number) {
    this.#now((_, { slidersMm }) => {
      return [{ slide: [oneOf("slider", slider, Object.keys(slidersMm)), finite("to_mm", to_mm)] }, "commit"];
    });
  }

  /**
   * Sets an expression, as one edit.
   *
   * @param expression ARKit name, such as "jawOpen"
   * @param to weight, 0 to 1
   */
  express(expression: string, to: number) {
    this.#now((_, { weights }) => {
      return [{ express: [oneOf("expression", expression, Object.keys(weights)), finite("to", to)] }, "commit"];
    });
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
    this.#now(() => [intent]);
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
  getFile(format: string, choices?: Record<string, string>) {
    return this.#later(async () => (await this.#ready()).file(format, choices));
  }

  /** Applies the intents that `plan` returns. */
  #now(plan: (session: FaceSession, state: State) => Intent[]) {
    try {
      const session = this.#session;
      if (!session) throw this.#notReady();
      for (const intent of plan(session, session.host.answer((studio) => studio.state()))) session.apply(intent);
      // The session reports document changes only, and a choice changes the view only.
      this.#reflectState();
    } catch (error) {
      throw RostoError.of(error);
    }
  }

  #later<T>(act: () => Promise<T>) {
    return act().catch((error) => Promise.reject(RostoError.of(error)));
  }

  #ready() {
    return this.#opened ?? Promise.reject(this.#notReady());
  }

  #notReady() {
    const inPage = hasSize(this) ? "loading; wait for rosto-ready" : "hidden, and starts once it is shown";
    return this.#failure ?? new RostoError("not-ready", `the element is ${this.#opened ? inPage : "not on a page"}`);
  }

  async #open(stage: Stage, signal: AbortSignal) {
    await loadWords(this.#language());
    onLocaleChange(() => stage.translate(), signal);
    const base = this.getAttribute("base");
    if (base !== null) init(base, this.baseURI);
    // Reports a page that forbids workers now, not when a photo needs one.
    scriptUrl(fileUrl(new URL("./vision-worker.js", import.meta.url)));
    await untilShown(this, signal);
    const session = await FaceSession.open(stage.canvas, {
      progress: (step, fraction) => stage.showProgress(step, fraction),
      face: () => this.#showFace(),
      change: (isEdited) => this.#change(isEdited),
      show: (thrown, owner) => this.#fail(thrown, owner),
      hide: (owner) => stage.hideNotice(owner),
    }, stage.tag);
    if (signal.aborted) session.close();
    signal.throwIfAborted();
    this.#setUp(session, signal);
    return session;
  }

  #setUp(session: FaceSession, signal: AbortSignal) {
    this.#session = session;
    const [motion, dark] = [matchMedia("(prefers-reduced-motion: reduce)"), matchMedia("(prefers-color-scheme: dark)")];
    const applyPreferences = () => {
      const scheme = getComputedStyle(this).colorScheme;
      const isDark = scheme.includes("dark") && (!scheme.includes("light") || dark.matches);
      session.host.apply({ theme: isDark ? "dark" : "light" });
      session.host.apply({ "reduced-motion": motion.matches });
    };
    for (const query of [motion, dark]) query.addEventListener("change", applyPreferences, { signal });
    applyPreferences();
    session.host.onRestart(async () => applyPreferences());
    for (const name of CHOICES) this.attributeChangedCallback(name, null, this.getAttribute(name));
  }

  #close() {
    this.#teardown.abort(new RostoError("closed", "the element was removed from the page"));
    this.#session?.close();
    this.#session = this.#opened = this.#failure = this.#panel = this.#photoUrl = undefined;
    this.#shadow.replaceChildren();
  }

  #openFromMarkup() {
    const image = this.querySelector("img");
    // Once the browser has chosen its source.
    const url = this.getAttribute("src") ?? (image?.currentSrc || (image?.complete && image.src));
    if (!url || url === this.#photoUrl) return;
    this.#photoUrl = url;
    // Errors are dispatched as rosto-error.
    this.open(url).catch(() => {});
  }

  #language() {
    return this.closest("[lang]")?.getAttribute("lang") ?? navigator.language;
  }

  #choose(session: FaceSession, choice: string, id: string) {
    if (session.host.read(({ chosen }) => chosen[choice]) === id) return;
    try {
      session.apply({ [choice]: id } as Intent);
    } catch (error) {
      this.#fail(error);
    }
  }

  async #use(tool: Tool) {
    try {
      if (tool !== "download") return this[tool]();
      const file = await this.getGlb();
      download(file, fileName(this.#session?.face, "glb"), file.type);
    } catch (error) {
      this.#fail(error);
    }
  }

  #showFace() {
    this.#stage?.showFace();
    this.#showTools();
    const { face, faces = [] } = this.#session ?? {};
    if (!face) return;
    const { landmarks, width_px, height_px } = leadOf(face);
    this.#emit("rosto-face", { landmarks, width_px, height_px, faces: faces.length, index: faces.indexOf(face) });
  }

  #change(isEdited: boolean) {
    if (isEdited) {
      this.#stage?.hideNotice();
      this.#emit("rosto-change", this.state);
    }
    this.#reflectState();
  }

  /** Reflects the studio's choices in the attributes, and enables the tools that apply. */
  #reflectState() {
    const { state } = this;
    for (const name of CHOICES) {
      const [given, chosen] = [this.getAttribute(name), state[name]];
      if (given !== null && chosen !== undefined && given !== chosen) this.setAttribute(name, chosen);
    }
    this.#stage?.enableTools({ undo: state.canUndo, redo: state.canRedo, reset: state.edits > 0, download: true });
  }

  #showTools() {
    const { face, host } = this.#session ?? {};
    if (face && host && this.hasAttribute("panel")) this.#panel ??= this.#addPanel(host);
    const covered_px = this.#stage?.showTools(this.controls) ?? 0;
    this.#session?.host.apply({ "viewport-insets": [0, 0, covered_px * devicePixelRatio, 0] });
  }

  async #addPanel(host: Host) {
    const { addPanel } = await import("./panel.ts");
    if (!host.closed.aborted) addPanel(host, this.#shadow);
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
