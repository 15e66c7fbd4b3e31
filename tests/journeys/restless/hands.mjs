import { readFile } from "node:fs/promises";
import { SAMPLE } from "../visitor.mjs";
import { faceless, text, twice } from "../pictures.mjs";

/**
 * @typedef {import("./intents.mjs").Action} Action
 * @typedef {import("./intents.mjs").Move} Move
 * @typedef {import("./eyes.mjs").Box} Box
 * @typedef {import("./eyes.mjs").Seen} Seen
 */

/** A finger that rests for a while. */
const REST_MS = 520;

/** A file is opened within this time, or the visitor goes on. */
const OPENING_MS = 30_000;

const MOUSE = new Set(["down", "move", "up"]);
const BUTTONS = { left: 1, right: 2, middle: 4 };

/** Does what a visitor wishes, with real input wherever the browser's protocol has it. */
export class Hands {
  /** What was downloaded in this visit, the newest of its kind. @type {Map<string, Buffer>} */
  pocket = new Map();
  #touching = false;

  /**
   * @param {import("playwright-core").Page} page
   * @param {import("playwright-core").CDPSession} input
   */
  constructor(page, input) {
    this.page = page;
    this.input = input;
  }

  /** @param {import("playwright-core").Page} page */
  static async of(page) {
    return new Hands(page, await page.context().newCDPSession(page));
  }

  /**
   * @param {Exclude<Action, { do: "check" }>} action
   * @param {Seen} seen what the page showed before it
   */
  async perform(action, seen) {
    switch (action.do) {
      case "press":
        return this.#press(action.at, 1);
      case "doublePress":
        return this.#press(action.at, 2);
      case "set":
        return this.page.evaluate(([at, value]) => window["__eyes"].set(at, value), [action.at, action.value]);
      case "enter":
        return this.#enter(action.at, action.text, action.lastKey);
      case "slide":
        if (await this.#focus(action.at)) await this.#keys(action.keys);
        return;
      case "pull":
        return this.#pull(action.at, action.from, action.to);
      case "pointer":
        return this.#pointer(seen[action.on], action.moves);
      case "keys":
        if (action.focus) await this.page.evaluate(() => document.getElementById("viewport")?.focus());
        return this.#keys(action.keys);
      case "files":
        return this.#bring(action.files, action.by, action.wait);
      case "storm":
        return this.#storm(action.presses);
      case "shuffle":
        return this.page.evaluate((choices) => {
          for (const { at, value } of choices) value === null ? window["__eyes"].press(at) : window["__eyes"].set(at, value);
        }, action.choices);
      case "resize":
        return this.page.setViewportSize(action);
      case "media":
        return this.page.emulateMedia(action.media);
      case "reload":
        return this.#reload(action.goOn);
    }
  }

  /** @param {string} at @param {number} times */
  async #press(at, times) {
    const box = await this.#aim(at);
    if (!box) return;
    const place = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    await this.input.send("Input.dispatchMouseEvent", { type: "mouseMoved", ...place });
    for (let clickCount = 1; clickCount <= times; clickCount++) {
      for (const type of /** @type {const} */ (["mousePressed", "mouseReleased"])) {
        await this.input.send("Input.dispatchMouseEvent", { type, ...place, button: "left", clickCount });
      }
    }
  }

  /** @param {string} at @returns {Promise<Box | null>} */
  #aim(at) {
    return this.page.evaluate((at) => window["__eyes"].aim(at), at);
  }

  /** @param {string} at @returns {Promise<boolean>} */
  #focus(at) {
    return this.page.evaluate((at) => window["__eyes"].enter(at), at);
  }

  /** @param {string} at @param {string} text @param {string | null} lastKey */
  async #enter(at, text, lastKey) {
    if (!(await this.#focus(at))) return;
    if (text === "") await this.page.keyboard.press("Delete");
    else await this.input.send("Input.insertText", { text });
    if (lastKey) await this.page.keyboard.press(lastKey);
  }

  /** @param {string} at @param {number} from @param {number} to shares of the slider's width */
  async #pull(at, from, to) {
    const box = await this.#aim(at);
    if (!box) return;
    const y = box.y + box.height / 2;
    const x = (/** @type {number} */ share) => box.x + 8 + share * (box.width - 16);
    const steps = [0.3, 0.7, 1].map((share) => x(from + share * (to - from)));
    await this.input.send("Input.dispatchMouseEvent", { type: "mousePressed", x: x(from), y, button: "left", clickCount: 1 });
    const moved = steps.map((at) => this.input.send("Input.dispatchMouseEvent", { type: "mouseMoved", x: at, y, button: "left", buttons: 1 }));
    await Promise.all(moved);
    await this.input.send("Input.dispatchMouseEvent", { type: "mouseReleased", x: x(to), y, button: "left", clickCount: 1 });
  }

  /** @param {readonly string[]} keys */
  async #keys(keys) {
    for (const key of keys) await this.page.keyboard.press(key);
  }

  /** @param {Box | null} box @param {Move[]} moves */
  async #pointer(box, moves) {
    if (!box) return;
    const at = ({ x = 0.5, y = 0.5 }) => ({ x: box.x + x * box.width, y: box.y + y * box.height });
    // The mouse does not wait for the page; whatever else comes in between waits for the mouse.
    let mouse = Promise.resolve();
    for (const move of moves) {
      if (!MOUSE.has(move.type)) await mouse;
      if (move.type === "pause") await new Promise((resolve) => setTimeout(resolve, REST_MS));
      else if (move.type === "key") await this.page.keyboard.press(move.key);
      else if (move.type === "cancel") await this.#cancel();
      else if (move.type === "fingers") await this.#fingers(move.places.map(at));
      else if (move.type === "wheel") await this.input.send("Input.dispatchMouseEvent", { type: "mouseWheel", ...at(move), deltaX: 0, deltaY: move.dy, modifiers: move.held ?? 0 });
      else mouse = this.#mouse(move, at(move));
    }
    await mouse;
    if (this.#touching) await this.#fingers([]);
  }

  /** @param {Move} move @param {{ x: number, y: number }} place */
  async #mouse({ type, button, held = 0 }, place) {
    const types = /** @type {const} */ ({ down: "mousePressed", up: "mouseReleased", move: "mouseMoved" });
    const pressed = type !== "up" && button ? BUTTONS[button] : 0;
    const event = { type: types[type], ...place, button: button ?? "none", buttons: pressed, modifiers: held, clickCount: type === "move" ? 0 : 1 };
    await this.input.send("Input.dispatchMouseEvent", /** @type {any} */ (event));
  }

  /** @param {{ x: number, y: number }[]} places of all fingers that touch from now on */
  async #fingers(places) {
    const type = places.length === 0 ? "touchEnd" : this.#touching ? "touchMove" : "touchStart";
    if (type === "touchEnd" && !this.#touching) return;
    this.#touching = places.length > 0;
    await this.input.send("Input.dispatchTouchEvent", { type, touchPoints: places.map((place, id) => ({ ...place, id })) });
  }

  /** The system takes the pointer away, as it does for a gesture of its own. */
  async #cancel() {
    if (this.#touching) {
      this.#touching = false;
      await this.input.send("Input.dispatchTouchEvent", { type: "touchCancel", touchPoints: [] });
      return;
    }
    await this.page.evaluate(() => {
      document.getElementById("viewport")?.dispatchEvent(new PointerEvent("pointercancel", { pointerId: 1, pointerType: "mouse", bubbles: true }));
    });
  }

  /** @param {string[]} names @param {"drop" | "paste"} by @param {boolean} wait */
  async #bring(names, by, wait) {
    for (const name of names) {
      const file = await this.#file(name);
      if (file) await this.page.evaluate((file) => window["__eyes"].bring(file), { ...file, base64: file.bytes.toString("base64"), bytes: undefined, by });
    }
    if (wait) await this.untilQuiet();
  }

  /** Waits until no file is being opened. */
  async untilQuiet() {
    await this.page.evaluate(() => window["__eyes"].settle(3));
    await this.page.waitForFunction(() => !window["__eyes"].look().busy, undefined, { timeout: OPENING_MS }).catch(() => {});
  }

  /**
   * @param {string} name
   * @returns {Promise<{ bytes: Buffer, name: string, type: string } | undefined>} nothing if it was not downloaded yet
   */
  async #file(name) {
    const kept = this.pocket.get(name.replace("half a ", ""));
    const half = (/** @type {Buffer} */ bytes) => bytes.subarray(0, bytes.length / 2);
    const portrait = () => readFile(SAMPLE);
    switch (name) {
      case "portrait":
        return { bytes: await portrait(), name: "portrait.png", type: "image/png" };
      case "two faces":
        return { bytes: await twice(this.page, await portrait()), name: "friends.png", type: "image/png" };
      case "no face":
        return { bytes: faceless(), name: "wall.png", type: "image/png" };
      case "damaged picture":
        return { bytes: half(await portrait()), name: "half.png", type: "image/png" };
      case "text":
        return { bytes: text(), name: "diary.jpg", type: "image/jpeg" };
      case "text called GLB":
        return { bytes: Buffer.concat([Buffer.from("glTF"), text()]), name: "diary.glb", type: "model/gltf-binary" };
      case "text called project":
        return { bytes: Buffer.concat([Buffer.from('{"format":"rosto-project","version":1}\n'), text()]), name: "diary.rosto", type: "" };
      case "GLB":
      case "project":
        return kept && { bytes: kept, name: `face.${name === "GLB" ? "glb" : "rosto"}`, type: "" };
      default:
        return kept && { bytes: half(kept), name: `${name}.bin`, type: "" };
    }
  }

  /** @param {string[]} presses */
  async #storm(presses) {
    await this.page.evaluate((presses) => {
      for (const action of presses) window["__eyes"].press(`#section-history [data-action="${action}"]`);
    }, presses);
  }

  /** @param {boolean} goOn */
  async #reload(goOn) {
    await this.page.reload();
    if (goOn) await this.goOn(3_000);
  }

  /**
   * Goes on with the kept work, if it is offered within so long.
   *
   * @param {number} limit_ms
   */
  async goOn(limit_ms) {
    const offered = await this.page.waitForSelector("#continue:not([hidden])", { timeout: limit_ms, state: "attached" }).catch(() => null);
    if (!offered) return false;
    await this.page.evaluate(() => window["__eyes"].press("#continue"));
    await this.page.waitForSelector("body[data-state='face']", { timeout: OPENING_MS });
    await this.untilQuiet();
    return true;
  }
}
