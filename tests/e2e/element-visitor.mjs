import path from "node:path";
import { PNG } from "pngjs";
import { test as base } from "./fixtures.mjs";
import { installed, SITE } from "./package.mjs";
import { serve } from "./server.mjs";
import { hookModule, recordGpus } from "./page-scripts.mjs";

const SCRIPT = `<script type="module" src="node_modules/rosto/rosto.js"></script>`;

/**
 * Fixtures for the example page, or for a page with a given `body` and policy next to the installed package, whose files
 * are served with `headers`.
 */
export const test = base.extend({
  openElement: async ({ open }, use) => {
    await installed();
    const server = await serve(SITE, "/a/page/");
    await use(async ({ body, policy, headers: ofFiles = {} } = {}) => {
      server.intercept((_, response) => {
        for (const [name, value] of Object.entries(ofFiles)) response.setHeader(name, value);
        return false;
      });
      const url = `${server.url}${body ? "page.html" : ""}`;
      const html = `<!doctype html><html lang="en"><meta charset="utf-8">${SCRIPT}<body>${body}`;
      const headers = { "content-type": "text/html", ...(policy && { "content-security-policy": policy }) };
      const before = async (context) => {
        // Browsers refuse a sandboxed page the local server itself.
        const answer = (route) => route.fulfill({ path: path.join(SITE, route.request().url().slice(server.url.length)), headers: ofFiles });
        if (policy?.startsWith("sandbox")) await context.route(`${server.url}**`, answer);
        if (body) await context.route(url, (route) => route.fulfill({ headers, body: html }));
      };
      return new ElementVisitor(await open({ url, before, scripts: [hookModule, recordGpus, recordEvents] }));
    });
    server.close();
  },
});

/** Drives a page that contains the element. */
class ElementVisitor {
  /** @param {import("./visitor.mjs").Visitor} visitor */
  constructor(visitor) {
    this.visitor = visitor;
    this.page = visitor.page;
    this.element = visitor.page.locator("rosto-studio").first();
  }

  /**
   * Waits for `count` events of a type; resolves to the detail of the last one.
   *
   * @param {string} type
   * @param {number} count
   */
  async until(type, count = 1) {
    await this.page.waitForFunction(([type, count]) => window.elementEvents.filter((one) => one.type === type).length >= count, [type, count]);
    return this.last(type);
  }

  /** Detail of the last event of a type. @param {string} type */
  last(type) {
    return this.page.evaluate((type) => window.elementEvents.findLast((one) => one.type === type)?.detail, type);
  }

  /** Types of all events so far. */
  names() {
    return this.page.evaluate(() => window.elementEvents.map(({ type }) => type));
  }

  /** Calls a function with the page's first element. @param {(face: any) => unknown} action */
  act(action) {
    return this.element.evaluate(action);
  }

  state() {
    return this.act((face) => face.state);
  }

  /** Code of the error that a function throws for the first element. @param {(face: any) => unknown} action */
  async refusal(action) {
    return (await this.thrown(action))?.code;
  }

  /** The error that a function throws for the first element. @param {(face: any) => unknown} action */
  thrown(action) {
    const face = `document.querySelector("rosto-studio")`;
    return this.page.evaluate(`(async () => {
      try { await (${action})(${face}); } catch ({ name, code, message, hint }) { return { name, code, message, hint }; }
    })()`);
  }

  /** Opens a file in the page's first element. @param {Uint8Array} bytes @param {string} name */
  openFile(bytes, name) {
    return this.element.evaluate((face, { bytes, name }) => face.open(new File([bytes], name)), { bytes: new Uint8Array(bytes), name });
  }

  /** @param {string} [format] */
  async file(format = "glb") {
    const read = async (face, format) => {
      const file = await (format === "glb" ? face.getGlb() : face.getFile(format));
      return new Uint8Array(await file.arrayBuffer());
    };
    return Buffer.from(await this.element.evaluate(read, format));
  }

  /** Notice on the stage. */
  async notice() {
    const notice = this.element.locator(".notice");
    return (await notice.isVisible()) ? notice.innerText() : "";
  }

  /** Drags from the middle of the element. @param {{ x: number, y: number }} by */
  async dragMiddle(by) {
    const box = await this.element.boundingBox();
    await this.visitor.drag({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, by);
    await this.page.mouse.move(1, 1);
  }

  /** Pixels of the element at rest. */
  async view() {
    await this.visitor.frames(5);
    return PNG.sync.read(await this.element.screenshot());
  }
}

/** Runs in the page: records the elements' events. */
function recordEvents() {
  window.elementEvents = [];
  for (const type of ["rosto-ready", "rosto-face", "rosto-change", "rosto-error"]) {
    addEventListener(type, ({ detail }) => window.elementEvents.push({ type, detail: detail && structuredClone(detail) }));
  }
}
