// The page and the command line write the same bytes for the same pixels, edits and options. JSON is excluded, because
// its last digits depend on the build's arithmetic.
import assert from "node:assert/strict";
import { filesByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { PAGE_OPTIONS, openAsCommandLine, storedFiles } from "./same-face.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

const EDITED = ["--slider", "nose-width:4"];

/**
 * Choices on the page and the equivalent options of the command line. The rows cover each base colour, material, size,
 * density and body.
 *
 * @typedef {{ format: string, choose: Record<string, string | boolean>, options: string[] }} Row
 * @type {Row[]}
 */
const USUAL = [
  { format: "glb", choose: { paint: "whole", size: "1024", density: "2", unlit: false }, options: ["--base-colour", "whole", "--texture-size", "1024"] },
  { format: "obj", choose: { paint: "colours", density: "0" }, options: ["--base-colour", "colours", "--density", "0"] },
];

/** @type {Row[]} */
const PAINTED = [
  { format: "png", choose: { paint: "whole", size: "1024" }, options: ["--base-colour", "whole", "--texture-size", "1024"] },
  { format: "obj", choose: { paint: "whole", size: "1024" }, options: ["--base-colour", "whole", "--texture-size", "1024"] },
  { format: "usdz", choose: { paint: "photo", size: "2048", density: "1", eyes: true }, options: ["--base-colour", "photo", "--texture-size", "2048", "--density", "1", "--eyes", "pieces"] },
  { format: "glb", choose: { eyes: false, unlit: true }, options: ["--base-colour", "photo", "--material", "unlit", "--density", "1"] },
  { format: "glb", choose: { paint: "photo", morphs: true }, options: ["--base-colour", "photo", "--material", "unlit", "--morph-targets", "--density", "1"] },
  { format: "obj", choose: { paint: "colours", density: "0" }, options: ["--base-colour", "colours", "--density", "0"] },
  { format: "ply", choose: {}, options: ["--density", "0"] },
  { format: "glb", choose: { morphs: false, expressions: true, unlit: false }, options: ["--base-colour", "colours", "--density", "0", "--expressions"] },
];

/** @type {Row[]} */
const PRINTED = [
  { format: "3mf", choose: { solid: "thickness", length: "2" }, options: ["--height-mm", "80"] },
  { format: "3mf", choose: { solid: "flat", length: "30" }, options: ["--height-mm", "80", "--solid", "flat:30"] },
  { format: "stl", choose: { solid: "thickness", length: "1.2", density: "1" }, options: ["--height-mm", "80", "--solid", "thickness:1.2", "--density", "1"] },
];

for (const [kind, rows] of Object.entries({ "a GLB and an OBJ": USUAL, meshes: PAINTED, printed: PRINTED })) {
  test(`page and command line write the same bytes for the same face and edits: ${kind}`, async ({ visitor }) => {
    await openAsCommandLine(visitor);
    await visitor.setSlider("nose-width", 4);
    for (const { format, choose, options } of rows) {
      for (const [what, value] of Object.entries(choose)) await setOption(visitor, what, value);
      const mine = await visitor.download(`download-${format}`);
      const { files, log } = await filesByCommandLine(SAMPLE, `face.${format}`, [...PAGE_OPTIONS, ...EDITED, ...options]);
      const pages = files.size > 1 ? storedFiles(mine) : new Map([[`face.${format}`, mine]]);
      assert.deepEqual([...pages.keys()].sort(), [...files.keys()].sort(), `${options}: ${log}`);
      for (const [name, bytes] of files) {
        const page = pages.get(name);
        const at = bytes.findIndex((byte, place) => byte !== page[place]);
        assert.deepEqual({ at, length: page.length }, { at: -1, length: bytes.length }, `${name} with ${options}`);
      }
    }
  });
}

/** Chooses a file option on the page. @param {import("./visitor.mjs").Visitor} visitor */
async function setOption({ page }, what, value) {
  const radios = { paint: "base-colour", solid: "solid" };
  const lists = { size: "#texture-size", density: "#export-density" };
  const checks = { unlit: "#export-unlit", morphs: "#export-morphs", expressions: "#export-expressions", eyes: "#export-eyes" };
  // Opens the fold that contains the print options.
  await page.evaluate(() => (/** @type {HTMLDetailsElement} */ (document.getElementById("print")).open = true));
  await page.click("#tab-export");
  if (what in radios) await page.check(`input[name="${radios[what]}"][value="${value}"]`, { force: true });
  else if (what in lists) await page.selectOption(lists[what], String(value));
  else if (what in checks) await page.setChecked(checks[what], value === true);
  else await page.fill("#print .slider:not([hidden]) .number-field", String(value));
  await page.waitForSelector("body:not([data-texture])");
}
