// Opens the files of the table in other programs: node --test tests/readers/*.test.mjs
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { validateGlb } from "../e2e/validate-glb.mjs";
import { openPage } from "./chromium.mjs";
import { shapeOf, exported } from "./files.mjs";
import { verify, truthOf } from "./verifier.mjs";
import { assertOnThePhoto } from "./on-the-photo.mjs";
import { Missing } from "./programs.mjs";
import { READERS } from "./readers.mjs";
import { MATRIX, ON_THE_PHOTO, ROWS } from "./table.mjs";

/** Missing programs fail on CI, and are skipped elsewhere. */
const MAY_SKIP = process.env.CI !== "true";

const files = await exported(ROWS);
/** Texture sizes by file. @type {Map<string, import("./verifier.mjs").Report["texture"]>} */
const textures = new Map();

for (const { name, opens, blind = [], supports = () => true, start } of READERS) {
  test(name, async (t) => {
    const known = files.filter(({ row }) => opens.includes(row.ending) && supports(row));
    const read = await start(t, known.map((file) => file.path)).catch((error) => {
      if (error instanceof Missing && MAY_SKIP) return error;
      throw error;
    });
    if (read instanceof Missing) return t.skip(read.message);
    for (const { row, path: file, printed } of known) {
      await t.test(`${name} opens ${path.basename(file)}`, async () => {
        const report = await read(file);
        const isBlind = row.baseColour === "colours" && blind.includes(row.ending);
        verify(isBlind ? { ...row, baseColour: "none" } : row, truthOf(await shapeOf(row.shape)), report, printed);
        const size = textures.get(file) ?? report.texture;
        textures.set(file, size);
        assert.deepEqual(report.texture ?? size, size, "another reader decodes the texture to another size");
      });
    }
  });
}

test("Khronos' glTF validator", async (t) => {
  for (const { path: file } of await exported(MATRIX)) {
    await t.test(`Khronos' validator accepts ${path.basename(file)}`, async () => {
      assert.deepEqual((await validateGlb(new Uint8Array(await readFile(file)))).messages, []);
    });
  }
});

test("three.js over the photo", async (t) => {
  const open = await openPage(t);
  for (const file of await exported(ON_THE_PHOTO)) {
    await t.test(`${path.basename(file.path)} matches the photo`, () => assertOnThePhoto(open, file));
  }
});
