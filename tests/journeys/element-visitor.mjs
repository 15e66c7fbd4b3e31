import { PNG } from "pngjs";
import { test as base } from "./fixtures.mjs";
import { installed, SITE } from "./package.mjs";
import { serve } from "./server.mjs";
import { watchGpus } from "./watches.mjs";

const BELOW = "/a/page/";
/** What the element tells. */
const EVENTS = ["rosto-ready", "rosto-face", "rosto-change", "rosto-error"];

/**
 * @typedef {object} Site the example, and pages like it, beside the installed package
 * @property {(body: string, policy?: string) => string} page has a page with the element in it, and tells its address
 * @property {(url?: string) => Promise<ElementVisitor>} arrive at the example, or at another page
 */

/** Tests with a {@link Site}. */
export const test = base.extend({
  site: async ({ open }, use) => {
    await installed();
    const server = await serve(SITE, BELOW);
    const arrive = async (url = server.url) => {
      const before = (context) => Promise.all([context.addInitScript(watchGpus), context.addInitScript(listen, EVENTS)]);
      return new ElementVisitor(await open({ url, before }));
    };
    await use({ page: pagesOn(server), arrive });
    server.close();
  },
});

/** @param {Awaited<ReturnType<typeof serve>>} server */
function pagesOn(server) {
  /** @type {Map<string, { html: string, policy: string }>} */
  const pages = new Map();
  server.disturb((name, response) => {
    const { html, policy } = pages.get(name) ?? {};
    if (html === undefined) return false;
    response.writeHead(200, { "content-type": "text/html", ...(policy && { "content-security-policy": policy }) }).end(html);
    return true;
  });
  return (/** @type {string} */ body, policy = "") => {
    const name = `page-${pages.size}.html`;
    const script = `<script type="module" src="node_modules/rosto/element/rosto-studio.js"></script>`;
    pages.set(name, { html: `<!doctype html><html lang="en"><meta charset="utf-8">${script}<body>${body}`, policy });
    return `${server.url}${name}`;
  };
}

/** Someone at a page that has the element. */
export class ElementVisitor {
  /** @param {import("./visitor.mjs").Visitor} visitor */
  constructor(visitor) {
    this.visitor = visitor;
    this.page = visitor.page;
  }

  /** Waits for so many events of a type; resolves to what the last one told. @param {string} type @param {number} count */
  async until(type, count = 1) {
    await this.page.waitForFunction(([type, count]) => window.heard.filter((one) => one.type === type).length >= count, [type, count]);
    return this.last(type);
  }

  /** What the last event of a type told. @param {string} type */
  last(type) {
    return this.page.evaluate((type) => window.heard.findLast((one) => one.type === type)?.detail, type);
  }

  /** The types of all events so far. */
  names() {
    return this.page.evaluate(() => window.heard.map(({ type }) => type));
  }

  state() {
    return this.page.evaluate(() => document.querySelector("rosto-studio").state);
  }

  /** Does something with the page's first element. @param {(face: any) => void} deed */
  async act(deed) {
    await this.page.locator("rosto-studio").first().evaluate(deed);
  }

  /** Hands a file to the page's first element, until it is open. @param {Uint8Array} bytes @param {string} name */
  openFile(bytes, name) {
    const file = { base64: Buffer.from(bytes).toString("base64"), name };
    return this.page.evaluate(({ base64, name }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      return document.querySelector("rosto-studio").open(new File([bytes], name));
    }, file);
  }

  glb() {
    return this.file("glb");
  }

  /** @param {string} format */
  async file(format) {
    const base64 = await this.page.evaluate(async (format) => {
      const face = document.querySelector("rosto-studio");
      const file = await (format === "glb" ? face.getGlb() : face.getFile(format));
      return btoa(Array.from(new Uint8Array(await file.arrayBuffer()), (byte) => String.fromCharCode(byte)).join(""));
    }, format);
    return Buffer.from(base64, "base64");
  }

  /** The code of what it throws. @param {() => unknown} deed */
  refusal(deed) {
    return this.page.evaluate(`(async () => { try { await (${deed})(); } catch (error) { return error.code; } })()`);
  }

  /** What is said on the stage. */
  async notice() {
    const notice = this.page.locator("rosto-studio .notice").first();
    return (await notice.isVisible()) ? notice.innerText() : "";
  }

  /** Takes what lies in the middle of the element by the mouse, and moves it. @param {{ x: number, y: number }} by */
  async dragMiddle(by) {
    const box = await this.page.locator("rosto-studio").first().boundingBox();
    await this.visitor.drag({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, by);
    await this.page.mouse.move(1, 1);
  }

  /** The element's pixels at rest. */
  async view() {
    await this.frames(5);
    return PNG.sync.read(await this.page.locator("rosto-studio").first().screenshot());
  }

  /** @param {number} count */
  frames(count) {
    return this.visitor.frames(count);
  }

  /** How large the memory of the elements' module is. */
  moduleBytes() {
    return this.page.evaluate(async () => {
      const { studioModule } = await import(new URL("node_modules/rosto/js/viewport/studio-module.js", document.baseURI).href);
      return (await studioModule().default()).memory.buffer.byteLength;
    });
  }
}

/** Runs in the page before it: remembers what elements tell. @param {string[]} types */
function listen(types) {
  window.heard = [];
  for (const type of types) addEventListener(type, ({ detail }) => window.heard.push({ type, detail: detail && structuredClone(detail) }));
}
