// Opens every file of the table in every program that is not ours: node --test tests/readers/*.test.mjs
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { validateGlb } from "../e2e/validate-glb.mjs";
import { openPage } from "./chromium.mjs";
import { shapeOf, written } from "./files.mjs";
import { judge, truthOf } from "./judge.mjs";
import { assertOnThePhoto } from "./on-the-photo.mjs";
import { Missing } from "./programs.mjs";
import { READERS } from "./readers.mjs";
import { MATRIX, ON_THE_PHOTO, ROWS } from "./table.mjs";

/** On CI every program must be there; elsewhere a missing one is skipped. */
const MAY_SKIP = process.env.CI !== "true";

const files = await written(ROWS);
/** Sizes of textures by file. @type {Map<string, import("./judge.mjs").Seen["texture"]>} */
const textures = new Map();

for (const { name, opens, blind = [], knows = () => true, start } of READERS) {
  test(name, async (t) => {
    const known = files.filter(({ row }) => opens.includes(row.ending) && knows(row));
    const see = await start(t, known.map((file) => file.path)).catch((error) => {
      if (error instanceof Missing && MAY_SKIP) return error;
      throw error;
    });
    if (see instanceof Missing) return t.skip(see.message);
    for (const { row, path: file, said } of known) {
      await t.test(`${name} opens ${path.basename(file)}`, async () => {
        const seen = await see(file);
        const isBlind = row.skin === "colours" && blind.includes(row.ending);
        judge(isBlind ? { ...row, skin: "none" } : row, truthOf(await shapeOf(row.shape)), seen, said);
        const size = textures.get(file) ?? seen.texture;
        textures.set(file, size);
        assert.deepEqual(seen.texture ?? size, size, "another reader decodes the texture to another size");
      });
    }
  });
}

test("Khronos' validator", async (t) => {
  for (const { path: file } of await written(MATRIX)) {
    await t.test(`the validator passes ${path.basename(file)}`, async () => {
      assert.deepEqual((await validateGlb(new Uint8Array(await readFile(file)))).messages, []);
    });
  }
});

test("on the photo", async (t) => {
  const open = await openPage(t);
  for (const file of await written(ON_THE_PHOTO)) {
    await t.test(`${path.basename(file.path)} lies on the photo`, () => assertOnThePhoto(open, file));
  }
});
