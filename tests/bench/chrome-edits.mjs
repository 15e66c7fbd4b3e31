// How long edits take in headless Chrome: the engine by itself (edits.rs, compiled for the web as the page is), and the
// page's own module with everything that a landmark's selection and a slider's tick bring about, up to the GPU.
import path from "node:path";
import { ROOT, inBlankPage, report } from "./blank-page.mjs";

const LEVELS = [0, 1, 2, 3];
/** Where the benchmark's command puts edits.rs. */
const ENGINE = path.join(process.env.CARGO_TARGET_DIR ?? path.join(ROOT, "target"), "bench");

for (const line of await inBlankPage(ENGINE, engine, LEVELS)) report(line.what, line.times_ms);
for (const line of await inBlankPage(path.join(ROOT, "dist"), page, LEVELS)) report(line.what, line.times_ms);

/** Runs in the browser. */
async function engine(levels) {
  const { default: init, Bench } = await import("./edits.js");
  await init();
  const lines = [];
  for (const level of levels) {
    const bench = new Bench(level);
    const steps = { system: bench.system, select: bench.select, tick: bench.tick, preview: bench.preview };
    const paper = { "paper-edit": bench.edit, "paper-edit-bare": bench.edit_from_nothing };
    for (const [name, step] of Object.entries(level === 0 ? { ...steps, ...paper } : steps)) {
      const what = { task: `${name}-chrome`, peer: "rosto in Chrome", vertices: bench.vertices };
      lines.push({ what, times_ms: timesOf((times) => step.call(bench, times)) });
    }
    bench.free();
  }
  return lines;

  /** A step's times; what is too short for the browser's clock is repeated between two looks at it. */
  function timesOf(step) {
    const [BUDGET_MS, LOOK_MS, MOST] = [2000, 4, 200];
    step(1);
    let repeats = 1;
    while (elapsed(() => step(repeats)) < LOOK_MS) repeats *= 2;
    const times = [];
    const until = performance.now() + BUDGET_MS;
    while (times.length < 3 || (performance.now() < until && times.length < MOST)) {
      times.push(elapsed(() => step(repeats)) / repeats);
    }
    return times;
  }

  function elapsed(action) {
    const start = performance.now();
    action();
    return performance.now() - start;
  }
}

/** Runs in the browser. */
async function page(levels) {
  const bytes = async (name) => new Uint8Array(await (await fetch(name)).arrayBuffer());
  const { default: initVision, Vision } = await import("./wasm/rosto-vision-web.js");
  await initVision();
  const vision = new Vision(await bytes("assets/face_detector.onnx"), await bytes("assets/face_landmarks_attention.onnx"));
  const found = vision.find(await bytes("sample.png"), 1, () => {});
  const { default: init, start } = await import("./wasm/rosto-studio-web.js");
  await init();
  const studio = await start(document.createElement("canvas"));
  studio.resize(640, 480, 1);
  studio.choose("triangulation", "canonical");
  studio.openPicture(found.pictureWidth, found.pictureHeight);
  studio.addPictureRows(found.takePicture());
  studio.openFace(found.landmarks(0), found.width, found.height, found.colours(0), "estimated");

  const lines = [];
  for (const level of levels) {
    studio.choose("density", String(level));
    const vertices = studio.state().vertexCount;
    const landmarks = Array.from({ length: 40 }, (_, place) => place * 11 + 1);
    const select = landmarks.map((landmark) => elapsed(() => studio.select(landmark)));
    const tick = landmarks.map((_, place) => elapsed(() => repeat(50, () => studio.preview(0, 0, place / 10))) / 50);
    studio.cancel();
    lines.push({ what: { task: "select-page", peer: "rosto in Chrome", vertices }, times_ms: select });
    lines.push({ what: { task: "tick-page", peer: "rosto in Chrome", vertices }, times_ms: tick });
  }
  return lines;

  function elapsed(action) {
    const start = performance.now();
    action();
    return performance.now() - start;
  }

  function repeat(times, action) {
    for (let time = 0; time < times; time += 1) action();
  }
}
