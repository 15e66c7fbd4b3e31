import assert from "node:assert/strict";
import validator from "gltf-validator";
import { journey } from "./journey.mjs";

/** Vertices at each density, and triangles of the filled face. */
const DENSITIES = [
  { vertices: 468, triangles: 898 },
  { vertices: 1833, triangles: 3592 },
  { vertices: 7257, triangles: 14368 },
  { vertices: 28881, triangles: 57472 },
];

journey("a GLB of every density passes the validator, which says so on the page before the download", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.untilLoaded();
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", 5);
  await visitor.unfold("section-export");
  for (const [density, { vertices, triangles }] of DENSITIES.entries()) {
    await page.selectOption("#export-density", String(density));
    assert.equal(await page.inputValue("#density"), String(density));
    await page.click("[data-action='check-glb']");
    await page.waitForSelector("#verdict[data-verdict='valid']");
    const verdict = await page.innerText("#verdict");
    const { name, json, bytes } = await downloadedGlb(visitor);
    assert.equal(name, density === 2 ? "portrait.glb" : `portrait-${vertices}.glb`);
    const size = bytes < 1e6 ? `${Math.round(bytes / 1000).toLocaleString("en-GB")} KB` : `${(bytes / 1e6).toFixed(1)} MB`;
    assert.equal(verdict, `${name}, ${size}: valid glTF 2.0, 0 errors, 0 warnings, 0 remarks`);
    const [{ attributes, indices }] = json.meshes[0].primitives;
    assert.equal(json.accessors[attributes.POSITION].count, vertices);
    assert.equal(json.accessors[indices].count, 3 * triangles);
  }
});

journey("the verdict goes when the face changes, and a GLB holds what is asked for", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.untilLoaded();
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", 5);
  await visitor.unfold("section-export");
  await page.check("input[name='base-colour'][value='colours']", { force: true });
  await page.check("#export-unlit");
  await page.check("#export-morphs");
  const { json } = await downloadedGlb(visitor);
  assert.ok(await page.isVisible("#verdict[data-verdict='valid']"), "no verdict beside the download");
  assert.deepEqual(json.extensionsUsed, ["KHR_materials_unlit"]);
  assert.ok("COLOR_0" in json.meshes[0].primitives[0].attributes && !json.images);
  assert.equal(json.meshes[0].primitives[0].targets.length, 1);
  assert.match(json.meshes[0].extras.targetNames[0], /nose-tip/);
  await page.click("#toolbar [data-action='undo']");
  assert.ok(await page.isHidden("#verdict"), "the verdict is of another file");
});

journey("OBJ, PLY and STL hold the mesh that is on the screen", async (open) => {
  const visitor = await open();
  await visitor.dropSample();
  await visitor.unfold("section-export");
  await visitor.page.selectOption("#export-density", "1");
  const { vertices, triangles } = DENSITIES[1];
  await visitor.page.check("input[name='base-colour'][value='colours']", { force: true });
  const obj = (await visitor.download("download-obj")).toString().split("\n");
  assert.equal(obj.filter((line) => line.startsWith("v ")).length, vertices);
  assert.equal(obj.filter((line) => line.startsWith("f ")).length, triangles);
  const ply = (await visitor.download("download-ply")).toString("latin1");
  assert.match(ply, new RegExp(`element vertex ${vertices}\\n[^]*element face ${triangles}\\n`));
  const stl = await visitor.download("download-stl");
  // Front and back, and a strip of two triangles for each of the 72 sides of the rim.
  const body = 2 * triangles + 2 * 72;
  assert.deepEqual([stl.readUInt32LE(80), stl.length], [body, 84 + 50 * body]);
});

journey("a painted OBJ comes with its material and its picture, and a face for printing or for a phone as one package", async (open) => {
  const visitor = await open();
  await visitor.dropSample();
  await visitor.unfold("section-export");
  for (const { format, ending, names } of [
    { format: "obj", ending: "zip", names: ["face.obj", "face.mtl", "face.png"] },
    { format: "3mf", ending: "3mf", names: ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"] },
    { format: "usdz", ending: "usdz", names: ["face.usda", "face.jpg"] },
  ]) {
    const coming = visitor.page.waitForEvent("download");
    const archive = await visitor.download(`download-${format}`);
    assert.equal((await coming).suggestedFilename(), `portrait.${ending}`);
    assert.equal(archive.toString("latin1", 0, 4), "PK\x03\x04");
    for (const name of names) assert.ok(archive.includes(name), `no ${name} in the ${format}`);
  }
  const png = await visitor.download("download-png");
  assert.equal(png.toString("latin1", 1, 4), "PNG");
});

/** Downloads the GLB, has it validated here as well, and reads its description. */
async function downloadedGlb(visitor) {
  const coming = visitor.page.waitForEvent("download");
  const bytes = await visitor.download("download-glb");
  const { issues } = await validator.validateBytes(new Uint8Array(bytes));
  const { numErrors, numWarnings, numInfos, numHints } = issues;
  assert.deepEqual([numErrors, numWarnings, numInfos, numHints], [0, 0, 0, 0], JSON.stringify(issues.messages));
  const json = JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());
  return { name: (await coming).suggestedFilename(), json, bytes: bytes.length };
}
