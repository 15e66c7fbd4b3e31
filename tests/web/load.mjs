import path from "node:path";
import { build } from "esbuild";

const SOURCES = path.resolve(import.meta.dirname, "../../web/src");

/** The pointer of the device: the page's words differ for touch. */
export const pointer = { matches: false, addEventListener() {} };
Object.assign(globalThis, { matchMedia: () => pointer });

/**
 * Imports modules of the page that need no document, bundled together.
 *
 * @param {string[]} names paths below web/src/
 */
export async function load(...names) {
  const contents = names.map((name) => `export * from "./${name}";`).join("\n");
  const { outputFiles } = await build({ stdin: { contents, resolveDir: SOURCES }, bundle: true, write: false, format: "esm" });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}
