// Opens every file of the table in every program that is not ours: node --test tests/readers/*.test.mjs
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { validateGlb } from "../journeys/validate-glb.mjs";
import { emptyFolder, shapeOf, written } from "./files.mjs";
import { findings, truthOf } from "./judge.mjs";
import { faultsOnThePhoto } from "./on-the-photo.mjs";
import { Missing } from "./programs.mjs";
import { READERS } from "./readers.mjs";
import { MATRIX, ON_THE_PHOTO, ROWS } from "./table.mjs";

/** On CI every program must be there; elsewhere a missing one is skipped. */
const MAY_SKIP = process.env.CI !== "true";

await emptyFolder();
const files = await written(ROWS);
/** Texture sizes by file. @type {Map<string, Set<string>>} */
const textures = new Map(files.map(({ path: file }) => [file, new Set()]));

for (const reader of READERS) {
  test(reader.name, async (t) => {
    const known = files.filter(({ row }) => reader.opens.includes(row.ending) && (reader.knows?.(row) ?? true));
    const seen = await reader.read(known.map((file) => file.path)).catch((error) => {
      if (error instanceof Missing && MAY_SKIP) return error;
      throw error;
    });
    if (seen instanceof Missing) return t.skip(seen.message);
    assert.equal(seen.length, known.length, "files reported");
    for (const [at, file] of known.entries()) {
      await t.test(`${reader.name} opens ${path.basename(file.path)}`, () => opens(reader, file, seen[at]));
    }
  });
}

/** @param {import("./readers.mjs").Reader} reader @param {import("./files.mjs").Written} file @param {import("./judge.mjs").Seen} seen */
async function opens(reader, { row, path: file, said }, seen) {
  if (seen.texture) textures.get(file)?.add(`${seen.texture.width} × ${seen.texture.height}`);
  const asked = reader.blind?.(row) ? { ...row, skin: /** @type {const} */ ("none") } : row;
  assert.deepEqual(findings(asked, truthOf(await shapeOf(row.shape)), seen, said), []);
}

test("all readers decode a texture to one size", () => {
  for (const [file, sizes] of textures) assert.ok(sizes.size < 2, `${file}: ${[...sizes].join(" or ")} px`);
});

test("Khronos' validator", async (t) => {
  for (const { path: file } of await written(MATRIX)) {
    await t.test(`the validator passes ${path.basename(file)}`, async () => {
      assert.deepEqual((await validateGlb(new Uint8Array(await readFile(file)))).messages, []);
    });
  }
});

test("on the photo", async (t) => {
  for await (const { name, faults } of faultsOnThePhoto(ON_THE_PHOTO)) {
    await t.test(`${name} lies on the photo`, () => assert.deepEqual(faults, []));
  }
});
