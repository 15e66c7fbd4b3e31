// How long it takes from a photo's bytes to its landmarks in headless Chrome: Rosto's worker module and, in the same
// browser, the published @mediapipe/face_mesh. Prints one JSON object a line, as peers.py does.
//
// Both decode the photo anew each time. The peer keeps tracking the face between pictures, so it looks for it only
// once; Rosto looks for it in every picture.
import path from "node:path";
import { launch } from "../journeys/browser.mjs";
import { serve } from "../journeys/server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const RUNS = 40;

const browser = await launch();
try {
  await measure(path.join(ROOT, "dist"), "rosto", rosto);
  await measure(path.join(ROOT, "node_modules/@mediapipe/face_mesh"), "@mediapipe/face_mesh", peer);
} finally {
  await browser.close();
}

/** Runs `work` in an empty page beside the files of `folder`. */
async function measure(folder, name, work) {
  const server = await serve(folder, "/");
  const page = await browser.newPage();
  try {
    const blank = { contentType: "text/html", body: "<!doctype html><title>bench</title>" };
    await page.route("**/blank.html", (route) => route.fulfill(blank));
    await page.route("**/sample.png", (route) => route.fulfill({ path: path.join(ROOT, "web/assets/sample.png") }));
    await page.goto(`${server.url}blank.html`);
    const { start_ms, first_ms, times_ms } = await page.evaluate(work, RUNS);
    report("networks-start-chrome", name, [start_ms]);
    report("first-landmarks-chrome", name, [first_ms]);
    report("photo-to-landmarks-chrome", name, times_ms);
  } finally {
    await page.close();
    server.close();
  }
}

function report(task, peer, times_ms) {
  const sorted = times_ms.toSorted((a, b) => a - b);
  console.log(JSON.stringify({ task, peer, ms: sorted[sorted.length >> 1], runs: sorted.length }));
}

/** Runs in the browser. */
async function rosto(runs) {
  const bytes = async (name) => new Uint8Array(await (await fetch(name)).arrayBuffer());
  const photo = await bytes("sample.png");
  const before = performance.now();
  const { default: init, Vision } = await import("./wasm/rosto-vision-web.js");
  await init();
  const vision = new Vision(await bytes("assets/face_detector.onnx"), await bytes("assets/face_landmarks.onnx"));
  const start_ms = performance.now() - before;
  const find = async () => {
    const started = performance.now();
    const found = vision.find(photo, 1, () => {});
    if (found.faceCount !== 1) throw new Error(`${found.faceCount} faces`);
    found.free();
    return performance.now() - started;
  };
  const first_ms = await find();
  const times_ms = [];
  for (let run = 0; run < runs; run += 1) times_ms.push(await find());
  return { start_ms, first_ms, times_ms };
}

/** Runs in the browser. */
async function peer(runs) {
  const photo = await (await fetch("sample.png")).blob();
  const before = performance.now();
  await new Promise((loaded, failed) => {
    const script = document.createElement("script");
    Object.assign(script, { src: "face_mesh.js", onload: loaded, onerror: failed });
    document.head.append(script);
  });
  const mesh = new globalThis.FaceMesh({ locateFile: (name) => name });
  mesh.setOptions({ maxNumFaces: 1 });
  let faces;
  mesh.onResults((results) => (faces = results.multiFaceLandmarks?.length ?? 0));
  await mesh.initialize();
  const start_ms = performance.now() - before;
  const find = async () => {
    const started = performance.now();
    const image = new Image();
    image.src = URL.createObjectURL(photo);
    await image.decode();
    await mesh.send({ image });
    URL.revokeObjectURL(image.src);
    if (faces !== 1) throw new Error(`${faces} faces`);
    return performance.now() - started;
  };
  const first_ms = await find();
  const times_ms = [];
  for (let run = 0; run < runs; run += 1) times_ms.push(await find());
  return { start_ms, first_ms, times_ms };
}
