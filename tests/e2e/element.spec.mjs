// <rosto-studio> on otherwise empty pages, served from the installed npm package.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { PAGE_EDIT_OPTIONS, glbByCommandLine } from "./command-line.mjs";
import { test } from "./element-visitor.mjs";
import { tscOutput } from "./package.mjs";
import { faceless } from "./pictures.mjs";
import { difference } from "./pixels.mjs";
import { PAGE_OPTIONS, projectAsCommandLine } from "./same-face.mjs";
import { validateGlb } from "./validate-glb.mjs";
import { SAMPLE } from "./visitor.mjs";

// One worker builds and installs the package once.
test.describe.configure({ mode: "default" });

/** Minimum policy for a page with the element. */
const POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; img-src 'self'";

const ELEMENT_OPTIONS = ["--base-colour", "whole", "--density", "2"];
/** Equal edits of the element and of the command line. */
const EDITS = [
  { edit: (face) => face.setSlider("nose-width", 4), options: [...PAGE_OPTIONS, "--slider", "nose-width:4"] },
  { edit: (face) => face.moveLandmark(1, [0, 0, 6]), options: [...PAGE_EDIT_OPTIONS, "--edit", "1:0,0,6"] },
];

test("on the example page, slider and drag reshape the face, events fire in order, and the GLB is valid", { tag: ["@eyes", "@usual"] }, async ({ openElement }) => {
  const visitor = await openElement();
  const { page } = visitor;
  await visitor.until("rosto-face");
  assert.deepEqual(await visitor.names(), ["rosto-ready", "rosto-face"]);
  const found = await visitor.view();

  await page.click("#wider");
  assert.deepEqual(await visitor.names(), ["rosto-ready", "rosto-face", "rosto-change"]);
  assert.equal(await page.innerText("#edits"), "Edits: 1");
  const wide = await visitor.view();
  assert.ok(difference(found, wide) > 0.0005, "the slider does not show");

  await visitor.dragMiddle({ x: 30, y: 20 });
  assert.deepEqual(await visitor.names(), ["rosto-ready", "rosto-face", "rosto-change", "rosto-change"]);
  assert.ok(difference(wide, await visitor.view()) > 0.001, "the drag does not show");
  await page.click("rosto-studio [data-tool=undo]");
  assert.equal((await visitor.state()).edits, 1);
  await page.keyboard.press("Control+z");
  assert.equal((await visitor.state()).sliders_mm["nose-width"], 0);
  await page.click("rosto-studio [data-tool=redo]");

  const [download] = await Promise.all([page.waitForEvent("download"), page.click("rosto-studio [data-tool=download]")]);
  assert.equal(download.suggestedFilename(), "portrait.glb");
  const glb = await visitor.file();
  assert.ok(glb.equals(await readFile(await download.path())), "the button downloads another file");
  assert.deepEqual(await validateGlb(glb), { clean: true, counts: "0/0/0/0", messages: [] });
});

test("the element's GLB equals the command line's, byte for byte", async ({ openElement, project }) => {
  const visitor = await openElement();
  await visitor.until("rosto-face");
  await visitor.openFile(await projectAsCommandLine(project), "portrait.rosto");
  for (const { edit, options } of EDITS) {
    await visitor.act(edit);
    const theirs = await glbByCommandLine(SAMPLE, [...options, ...ELEMENT_OPTIONS]);
    assert.ok((await visitor.file()).equals(theirs), options);
    await visitor.act((face) => face.undo());
  }
  await visitor.act((face) => face.redo());
  const [glb, json] = [await visitor.file(), await visitor.file("json")];
  await visitor.act((face) => face.reset());
  await visitor.openFile(glb, "face.glb");
  assert.equal((await visitor.state()).edits, 1);
  const positions = (/** @type {Buffer} */ file) => JSON.parse(file.toString()).positions;
  assert.deepEqual(positions(await visitor.file("json")), positions(json), "a saved file does not restore the edits");
});

test("the element reports files it cannot open by event and notice, and opens the next one", async ({ openElement }) => {
  const visitor = await openElement({ body: `<rosto-studio src="nowhere.jpg" lang="pt-BR" shading="clay"></rosto-studio>` });
  const { page } = visitor;
  assert.equal((await visitor.until("rosto-error")).code, "unreadable-file");
  assert.match(await visitor.notice(), /^Não foi possível ler o arquivo/);
  assert.equal(await visitor.refusal((face) => face.getGlb()), "no-face");
  assert.equal(await visitor.refusal((face) => face.setSlider("nose-width", 1)), "no-face");

  await assert.rejects(visitor.openFile(faceless(), "none.png"), /no face in the photo/);
  assert.equal((await visitor.last("rosto-error")).code, "no-face-found");
  await visitor.act((face) => (face.src = "portrait.png"));
  await visitor.until("rosto-face");
  assert.equal(await visitor.notice(), "");
  assert.equal((await visitor.state()).shading, "clay");
  assert.equal(await visitor.refusal((face) => face.setSlider("ears", 1)), "bad-choice");
  await visitor.act((face) => face.setAttribute("shading", "mauve"));
  assert.equal((await visitor.last("rosto-error")).code, "bad-choice");
  await visitor.act((face) => face.apply({ shading: "normals" }));
  assert.equal(await page.getAttribute("rosto-studio", "shading"), "normals");
});

test("a link whose name is not encoded opens", async ({ openElement }) => {
  const visitor = await openElement({ body: "<rosto-studio></rosto-studio>" });
  await visitor.page.route(/100%\.jpg$/, (route) => route.fulfill({ path: SAMPLE }));
  await visitor.act((face) => face.open("100%.jpg"));
  assert.deepEqual(await visitor.names(), ["rosto-ready", "rosto-face"]);
});

test("the element shows the photo requested last, even if an earlier one arrives later", async ({ openElement }) => {
  const visitor = await openElement({ body: "<rosto-studio></rosto-studio>" });
  const { page } = visitor;
  let deliver = () => {};
  const held = new Promise((resolve) => (deliver = () => resolve(undefined)));
  await page.route("**/late.png", async (route) => {
    await held;
    const response = await route.fetch({ url: new URL("portrait.png", route.request().url()).href });
    await route.fulfill({ response });
  });
  const late = visitor.act((face) => face.open("late.png"));
  await page.waitForRequest("**/late.png");
  await visitor.act((face) => face.open("portrait.png"));
  deliver();
  await late;
  assert.deepEqual(await visitor.names(), ["rosto-ready", "rosto-face"]);
});

test("two elements share a page and its worker under a strict policy, and free everything when removed", async ({ openElement }) => {
  const body = `<rosto-studio src="portrait.png"></rosto-studio><rosto-studio density="0"><img src="portrait.png" alt=""></rosto-studio>`;
  const visitor = await openElement({ body, policy: POLICY });
  const { page } = visitor;
  await visitor.until("rosto-face", 2);
  assert.equal(page.workers().length, 1);
  await visitor.act((first) => first.setSlider("nose-width", 3));
  const [one, other] = await page.evaluate(() => [...document.querySelectorAll("rosto-studio")].map(({ state }) => state));
  assert.deepEqual([one.edits, other.edits, one.vertices, other.vertices], [1, 0, 7257, 468]);

  // Moving the element within the page keeps its state.
  await visitor.act((first) => document.body.append(first));
  await visitor.visitor.frames(2);
  assert.equal(await page.evaluate(() => document.querySelector("rosto-studio:last-of-type").state.edits), 1);

  await visitor.act((face) => face.remove());
  await visitor.act((left) => left.undo());
  assert.equal(page.workers().length, 1);
  // The peak for two parallel loads varies; sequential loads must not need more memory.
  const memory = () => page.evaluate("hooked.memories.at(-1).buffer.byteLength");
  let before_bytes = Infinity;
  for (let time = 0; time < 6; time++) {
    if (time === 2) before_bytes = await memory();
    await page.evaluate(() => {
      document.querySelector("rosto-studio")?.remove();
      const next = document.createElement("rosto-studio");
      next.src = "portrait.png";
      document.body.append(next);
    });
    await visitor.until("rosto-face", 3 + time);
  }
  assert.ok((await memory()) <= before_bytes, "the module's memory grows");
  await visitor.act((face) => face.remove());
  await page.waitForFunction(() => window.gpus.every(({ isGone }) => isGone));
  assert.ok((await page.evaluate(() => window.gpus.length)) >= 8);
  if (page.workers().length > 0) await page.workers()[0].waitForEvent("close");
});

test("without 3D the element shows the photo and a notice", { tag: "@no-gpu" }, async ({ openElement }) => {
  const visitor = await openElement();
  assert.equal((await visitor.until("rosto-error")).code, "no-webgl");
  assert.match(await visitor.notice(), /can’t show 3D here\. Turn on/);
  assert.ok(await visitor.page.isVisible("rosto-studio img"));
});

const CONSUMER = `
import { FaceSession, RostoStudio, VisionClient, init, type StudioSnapshot } from "rosto";
init("/files/");
document.addEventListener("rosto-change", ({ detail }: CustomEvent<StudioSnapshot>) => console.log(detail.edits));
const face: RostoStudio = document.createElement("rosto-studio");
face.moveLandmark(1, [0, 0, 5]);
export const glb: Promise<Blob> = face.getGlb();
export const found = new VisionClient().open(new Blob()).then(({ opened }) => opened.faces[0]?.landmarks.length);
export const session = FaceSession.open(document.createElement("canvas")).then((session) => session.apply("undo"));
`;

test("TypeScript finds the package's types with both module resolutions", async () => {
  const strict = ["--ignoreConfig", "--strict", "--noEmit", "--target", "es2023", "--lib", "es2023,esnext.disposable,dom,dom.iterable"];
  const ways = [["--module", "esnext", "--moduleResolution", "bundler"], ["--module", "nodenext", "--moduleResolution", "nodenext"]];
  for (const way of ways) {
    assert.equal(await tscOutput("consumer.ts", CONSUMER, [...strict, ...way]), "");
    const wrong = CONSUMER.replace("[0, 0, 5]", "[0, 5]");
    assert.match(await tscOutput("wrong.ts", wrong, [...strict, ...way]), /TS2345/);
  }
});
