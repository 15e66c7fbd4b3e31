import path from "node:path";
import { build } from "esbuild";
import { inVersion } from "./server.mjs";

const WEB = path.resolve(import.meta.dirname, "../../web");

/**
 * Imports modules of the page's sources into a page, apart from the page's own instances.
 *
 * @param {import("@playwright/test").Page} page
 * @param {string[]} modules paths below web/
 */
export async function importParts(page, modules) {
  const contents = modules.map((name) => `export * from "./${name}";`).join("\n");
  const { outputFiles } = await build({ stdin: { contents, resolveDir: WEB }, bundle: true, write: false, format: "esm" });
  // Next to the files that they load.
  const name = await inVersion("parts.js");
  await page.context().route(`**/${name}`, (route) => route.fulfill({ contentType: "text/javascript", body: outputFiles[0].text }));
  return page.evaluateHandle((name) => import(new URL(name, document.baseURI).href), name);
}
