import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { createInterface } from "node:readline";
import WebSocket from "ws";
import { find } from "./find.mjs";

const START_MS = 60_000;

/** What a profile of its own says: downloads go to a folder without a question, and nothing else is fetched or asked. */
const preferences = (/** @type {string} */ downloads) => ({
  "browser.download.folderList": 2,
  "browser.download.dir": downloads,
  "browser.download.useDownloadDir": true,
  "browser.download.always_ask_before_handling_new_types": false,
  "browser.download.alwaysOpenPanel": false,
  "browser.shell.checkDefaultBrowser": false,
  "browser.startup.homepage_override.mstone": "ignore",
  "browser.aboutwelcome.enabled": false,
  "datareporting.policy.dataSubmissionEnabled": false,
  "toolkit.telemetry.reportingpolicy.firstRun": false,
  "app.update.disabledForTesting": true,
  "app.normandy.enabled": false,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
  "extensions.update.enabled": false,
  "remote.active-protocols": 1,
  "webgl.force-enabled": true,
});

/**
 * Firefox, spoken to in WebDriver BiDi.
 *
 * @param {NodeJS.ProcessEnv} env
 * @returns {Promise<import("./hand.mjs").Driver>}
 */
export async function firefox(env) {
  const folder = await mkdtemp(path.join(tmpdir(), "rosto-firefox-"));
  const downloads = await mkdtemp(path.join(folder, "downloads-"));
  const lines = Object.entries(preferences(downloads)).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});`);
  await writeFile(path.join(folder, "user.js"), lines.join("\n"));
  const program = find("Firefox", ["firefox-esr", "firefox"], "firefox-esr");
  const options = ["--no-remote", "--profile", folder, "--width", "1024", "--height", "720", "--remote-debugging-port", "0", "about:blank"];
  const browser = spawn(program, options, { env: { ...env, MOZ_CRASHREPORTER_DISABLE: "1" }, stdio: ["ignore", "ignore", "pipe"] });
  try {
    return await driver(await Connection.to(await address(browser)), browser, folder, downloads);
  } catch (error) {
    browser.kill();
    throw error;
  }
}

/** Where Firefox says that it listens. @param {import("node:child_process").ChildProcess} browser @returns {Promise<string>} */
function address(browser) {
  return new Promise((resolve, reject) => {
    const said = [];
    const late = setTimeout(() => reject(new Error(`Firefox did not say where it listens within ${START_MS / 1000} s:\n${said.join("\n")}`)), START_MS);
    createInterface(browser.stderr).on("line", (line) => {
      said.push(line);
      const [, found] = line.match(/WebDriver BiDi listening on (ws:\S+)/) ?? [];
      if (!found) return;
      clearTimeout(late);
      resolve(`${found}/session`);
    });
    browser.on("exit", (code) => reject(new Error(`Firefox ended with ${code}:\n${said.join("\n")}`)));
  });
}

/** @param {Connection} to @returns {Promise<import("./hand.mjs").Driver>} */
async function driver(to, browser, folder, downloads) {
  const { capabilities } = await to.ask("session.new", { capabilities: {} });
  // The tab that is there from the start never has the focus: fields in it do not hear that they are left.
  const { context } = await to.ask("browsingContext.create", { type: "tab" });
  /** @type {string[]} */
  const errors = [];
  to.onEvent = ({ level, text, stackTrace }) => {
    const [at] = stackTrace?.callFrames ?? [];
    if (level === "error") errors.push(at ? `${text} (${at.url}:${at.lineNumber})` : text);
  };
  await to.ask("session.subscribe", { events: ["log.entryAdded"] });
  return {
    engine: "Firefox",
    version: capabilities.browserVersion,
    downloads,
    open: async (url) => void (await to.ask("browsingContext.navigate", { context, url, wait: "complete" })),
    reload: async () => void (await to.ask("browsingContext.reload", { context, wait: "complete" })),
    evaluate: async (script) => {
      // As JSON, since the protocol's own way of saying values has another shape.
      const functionDeclaration = `async () => JSON.stringify((await (async () => { ${script} })()) ?? null)`;
      const ended = await to.ask("script.callFunction", { functionDeclaration, awaitPromise: true, target: { context } });
      if (ended.type === "exception") throw new Error(ended.exceptionDetails.text);
      return JSON.parse(ended.result.value);
    },
    act: async (actions) => void (await to.ask("input.performActions", { context, actions })),
    screenshot: async () => Buffer.from((await to.ask("browsingContext.captureScreenshot", { context })).data, "base64"),
    errors: async () => errors,
    close: async () => {
      const ended = once(browser, "exit");
      await to.ask("browser.close", {}).catch(() => browser.kill());
      await ended;
      await rm(folder, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
    },
  };
}

/** Questions and answers over a web socket. */
class Connection {
  /** @type {Map<number, { resolve: (result: any) => void, reject: (error: Error) => void }>} */
  #waiting = new Map();
  #asked = 0;
  #socket;
  /** @type {(params: any) => void} */
  onEvent = () => {};

  /** @param {string} url */
  static async to(url) {
    const socket = new WebSocket(url, { maxPayload: 0 });
    await once(socket, "open");
    return new Connection(socket);
  }

  /** @param {WebSocket} socket */
  constructor(socket) {
    this.#socket = socket;
    socket.on("message", (message) => this.#hear(JSON.parse(String(message))));
    socket.on("close", () => {
      for (const { reject } of this.#waiting.values()) reject(new Error("Firefox hung up"));
    });
  }

  /** @param {string} method @param {object} params @returns {Promise<any>} */
  ask(method, params) {
    const id = ++this.#asked;
    this.#socket.send(JSON.stringify({ id, method, params }));
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  #hear({ type, id, result, error, message, params }) {
    if (type === "event") return this.onEvent(params);
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (type === "success") waiting?.resolve(result);
    else waiting?.reject(new Error(`${error}: ${message}`));
  }
}
