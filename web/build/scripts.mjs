// Scripts that esbuild makes from the sources.
import path from "node:path";

export const WEB = path.resolve(import.meta.dirname, "..");

/** @type {import("esbuild").BuildOptions} */
export const SHARED = {
  absWorkingDir: WEB,
  bundle: true,
  minify: true,
  legalComments: "inline",
  target: "es2023",
  charset: "utf8",
  logLevel: "warning",
};

/**
 * Scripts for one folder; parts that load later become chunks there, and style sheets of shadow roots texts.
 *
 * @type {import("esbuild").BuildOptions}
 */
export const MODULES = { ...SHARED, format: "esm", splitting: true, chunkNames: "[name]-[hash]", loader: { ".css": "text" } };

/** The worker is one classic script, which bundlers of other projects can copy. @type {import("esbuild").BuildOptions} */
export const WORKER = {
  ...SHARED,
  format: "iife",
  entryPoints: { "vision-worker": "src/worker/vision-worker.ts" },
  // The default URL of the module is not used.
  define: { "import.meta.url": "location.href" },
};

/** @type {import("esbuild").BuildOptions[]} */
export const BUNDLES = [
  { ...MODULES, entryPoints: { page: "src/main.ts" } },
  WORKER,
  { ...SHARED, format: "iife", entryPoints: { "validator-worker": "src/validator-worker.ts", start: "src/start.ts", page: "css/page.css" } },
];
