import { spawn } from "node:child_process";
import { once } from "node:events";
import { find } from "./find.mjs";

const SIZE = "1280x900x24";
const START_MS = 15_000;

/** A screen that nobody sees: Firefox and WebKit have no WebGL without one. */
export async function openDisplay() {
  const server = spawn(find("Xvfb", ["Xvfb"], "xvfb"), ["-displayfd", "3", "-screen", "0", SIZE, "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  const number = once(server.stdio[3], "data").then(([bytes]) => String(bytes).trim());
  const late = new Promise((_, reject) => setTimeout(() => reject(new Error(`Xvfb did not start within ${START_MS / 1000} s`)), START_MS).unref());
  const display = `:${await Promise.race([number, late])}`;
  return {
    /** For programs that draw on it, in software. */
    env: { ...process.env, DISPLAY: display, WAYLAND_DISPLAY: "", LIBGL_ALWAYS_SOFTWARE: "1" },
    close: () => server.kill(),
  };
}
