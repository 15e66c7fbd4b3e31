import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import path from "node:path";
import { find } from "./find.mjs";
import { BrowserCrashed } from "./hand.mjs";

const START_MS = 15_000;
const SCRIPT_MS = 120_000;

/** What WebDriver has no way to ask: the errors that a page let through. They are lost when it is left. */
const LISTEN = `
  if (window.__troubles) return;
  window.__troubles = [];
  addEventListener("error", (event) => window.__troubles.push(String(event.error?.stack ?? event.message)));
  addEventListener("unhandledrejection", (event) => window.__troubles.push(String(event.reason?.stack ?? event.reason)));
  const said = console.error;
  console.error = (...words) => { window.__troubles.push(words.join(" ")); said(...words); };`;

/**
 * WebKitGTK's own small browser, spoken to in WebDriver.
 *
 * @param {NodeJS.ProcessEnv} env
 * @returns {Promise<import("./hand.mjs").Driver>}
 */
export async function webkit(env) {
  const program = find("WebKit", ["WebKitWebDriver"], "webkit2gtk-driver");
  const home = await mkdtemp(path.join(tmpdir(), "rosto-webkit-"));
  const downloads = path.join(home, "downloads");
  await mkdir(downloads);
  await mkdir(path.join(home, "config"));
  // Where GLib looks for the folder of downloads.
  await writeFile(path.join(home, "config/user-dirs.dirs"), `XDG_DOWNLOAD_DIR="${downloads}"\n`);
  const port = await freePort();
  const folders = { HOME: home, XDG_CONFIG_HOME: path.join(home, "config"), XDG_CACHE_HOME: path.join(home, "cache"), XDG_DATA_HOME: path.join(home, "data") };
  const server = spawn(program, [`--port=${port}`], { env: { ...env, ...folders }, stdio: ["ignore", "ignore", "pipe"] });
  const close = async () => {
    const ended = once(server, "exit");
    server.kill();
    await ended;
    // Its processes end a little later and still write what they keep.
    await rm(home, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
  };
  try {
    return await driver(`http://127.0.0.1:${port}/session`, downloads, close);
  } catch (error) {
    await close();
    throw error;
  }
}

/** @param {string} sessions @param {string} downloads @param {() => Promise<void>} close @returns {Promise<import("./hand.mjs").Driver>} */
async function driver(sessions, downloads, close) {
  const { sessionId, capabilities } = await started(sessions);
  const ask = (/** @type {string} */ method, /** @type {string} */ what, /** @type {object} */ body) => request(method, `${sessions}/${sessionId}/${what}`, body);
  const run = (/** @type {string} */ script) => ask("POST", "execute/sync", { script: `return (async () => { ${script} })()`, args: [] });
  await ask("POST", "timeouts", { script: SCRIPT_MS });
  await ask("POST", "window/rect", { x: 0, y: 0, width: 1024, height: 720 });
  /** @type {string[]} */
  const before = [];
  const errors = () => run("return window.__troubles ?? []");
  return {
    engine: "WebKit",
    version: capabilities.browserVersion,
    downloads,
    open: async (url) => {
      await ask("POST", "url", { url });
      await run(LISTEN);
    },
    reload: async () => {
      before.push(...(await errors()));
      await ask("POST", "refresh", {});
      await run(LISTEN);
    },
    evaluate: run,
    act: (actions) => ask("POST", "actions", { actions }),
    screenshot: async () => Buffer.from(await ask("GET", "screenshot"), "base64"),
    errors: async () => [...before, ...(await errors())],
    close: async () => {
      await request("DELETE", `${sessions}/${sessionId}`).catch(() => {});
      await close();
    },
  };
}

/** A session, as soon as the driver listens. @param {string} sessions */
async function started(sessions) {
  const until = performance.now() + START_MS;
  for (;;) {
    try {
      return await request("POST", sessions, { capabilities: { alwaysMatch: {} } });
    } catch (error) {
      if (error.cause?.code !== "ECONNREFUSED" || performance.now() > until) throw error;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }
}

/** @param {string} method @param {string} url @param {object} [body] @returns {Promise<any>} */
async function request(method, url, body) {
  const answer = await fetch(url, { method, body: body && JSON.stringify(body) });
  const { value } = await answer.json();
  // WebKitWebDriver reports a crash of the web process this way.
  if (value?.error === "invalid session id") throw new BrowserCrashed();
  if (!answer.ok) throw new Error(`${value.error}: ${value.message}`);
  return value;
}

/** @returns {Promise<number>} */
async function freePort() {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  server.close();
  await once(server, "close");
  return port;
}
