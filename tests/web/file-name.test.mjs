/** Names of saved files. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";

const { fileName, numberedName, stemOf, stemOfMesh } = await load("work/file-name.ts");

const file = (name) => new File([], name);

test("a file is named after its photo, without what file systems reject", () => {
  const stems = {
    'ana: "Rio" 7.2.png': "ana Rio 7.2",
    "me & you.png": "me & you",
    "María\u202egnp.exe.png": "Maríagnp.exe",
    " .hidden. .png": "hidden",
  };
  for (const [name, stem] of Object.entries(stems)) assert.equal(stemOf(file(name)), stem, name);
});

test("generic and reserved names become face", () => {
  for (const name of ["image.png", "IMAGE.JPG", "..", ".png", "", "CON.png", "lpt1.jpg", "???.png"]) assert.equal(stemOf(file(name)), "face", name);
  assert.equal(stemOf(new Blob([])), "face");
});

test("a long name is cut between characters and fits file systems", () => {
  for (const [character, count] of /** @type {const} */ ([["👍🏽", 20], ["面", 53], ["a", 160], ["é", 80]])) {
    const stem = stemOf(file(`${character.repeat(200)}.png`));
    assert.equal(stem, character.repeat(count));
    assert.ok(Buffer.byteLength(fileName({ name: stem }, "png", "before-after")) <= 200);
  }
});

test("a mesh keeps its name without the number of points", () => {
  assert.deepEqual(["clara-1833.glb", "clara.glb", "-1833.glb", "clara-7.glb"].map((name) => stemOfMesh(file(name))), ["clara", "clara", "face", "clara-7"]);
});

test("further pictures of a face are numbered, and faces are not", () => {
  const ana = { name: "ana" };
  const names = ["view", "edited", "view", "view"].map((content) => numberedName(ana, "png", content));
  assert.deepEqual(names, ["ana-view.png", "ana-edited.png", "ana-view-2.png", "ana-view-3.png"]);
  assert.equal(numberedName(ana, "jpg", "edited"), "ana-edited.jpg");
  assert.deepEqual([fileName(ana, "glb"), fileName(ana, "glb"), fileName(undefined, "rosto")], ["ana.glb", "ana.glb", "face.rosto"]);
});
