// Measurements that browser.mjs runs in the browser. Each export resolves to records without a sample count.
import * as frames from "/tests/e2e/video-frames.mjs";

const PHOTO = "/web/assets/sample.png";
const MEDIAPIPE = "/node_modules/@mediapipe/face_mesh/";
const PACKAGE = "/target/npm/rosto/";
const ROSTO = "rosto";
const FACE_MESH = "@mediapipe/face_mesh";
/** Photos measured after the first. */
const PHOTOS = 10;
const RUNS = 40;
/** Frames of a face at rest before the measured ones, and frames in which it turns and approaches after them. */
const [WARM_UP, TURNING] = [30, 60];
/** Length of the edit history. */
const ENTRIES = 40;
/** Events per clock reading, because browsers round their clocks. */
const EVENTS = 20;

/** A photo's bytes to landmarks in Rosto's worker module. */
export async function photosByRosto() {
  const photo = await bytes(PHOTO);
  const { ms: start_ms, value: vision } = await timed(async () => {
    const { default: init, Vision } = await import("/web/wasm/rosto-vision-web.js");
    await init({ module_or_path: `${PACKAGE}rosto-vision-web_bg.wasm` });
    const vision = new Vision();
    vision.loadNetworks(await bytes(`${PACKAGE}face_detector.onnx`), await bytes(`${PACKAGE}face_landmarks_attention.onnx`));
    return vision;
  });
  return photos(ROSTO, start_ms, async () => {
    const { faces } = vision.open("photo", photo, 1, () => {});
    if (faces.length !== 1) throw new Error(`${faces.length} faces`);
  });
}

/** The same with @mediapipe/face_mesh, which detects the face once and tracks it from photo to photo. */
export async function photosByMediaPipe() {
  const photo = await (await fetch(PHOTO)).blob();
  const { ms: start_ms, value: find } = await timed(() => faceMesh({ maxNumFaces: 1 }));
  return photos(FACE_MESH, start_ms, async () => {
    const image = new Image();
    image.src = URL.createObjectURL(photo);
    await image.decode();
    const faces = await find(image);
    URL.revokeObjectURL(image.src);
    if (faces.length !== 1) throw new Error(`${faces.length} faces`);
  });
}

async function photos(peer, start_ms, find) {
  const { ms: first_ms } = await timed(find);
  const later_ms = await repeated(PHOTOS, find);
  const record = (what, value) => ({ task: "photo in Chrome", what, size: "512 px PNG", peer, unit: "ms", value });
  return [
    record("load program and networks", start_ms),
    record("first photo to landmarks", first_ms),
    record("later photos to landmarks", median(later_ms)),
  ];
}

/** Both networks on their own, alternating between Rosto and onnxruntime-web, on one thread. */
export async function networks() {
  const files = { detector: await bytes("/web/assets/face_detector.onnx"), landmark: await bytes("/web/assets/face_landmarks.onnx") };
  const sides = { detector: 128, landmark: 192 };
  const programs = { [ROSTO]: await networksOfRosto(files), "onnxruntime-web": await networksOfOnnxRuntime(files) };
  const record = (what, peer, value) => ({ task: "networks in Chrome", what, size: "1 thread", peer, unit: "ms", value });
  const records = Object.entries(programs).map(([peer, { ready_ms }]) => record("load both networks", peer, ready_ms));
  for (const [network, side] of Object.entries(sides)) {
    const picture = Float32Array.from({ length: 3 * side * side }, (_, i) => Math.sin(i / 97) / 2 + 0.5);
    const times = Object.fromEntries(Object.keys(programs).map((peer) => [peer, []]));
    for (let run = 0; run < 2 * RUNS; run += 1) {
      for (const [peer, { run: once }] of Object.entries(programs)) times[peer].push((await timed(() => once(network, picture, side))).ms);
    }
    // The browser still optimises during the first half.
    for (const [peer, all_ms] of Object.entries(times)) records.push(record(`${network} network`, peer, median(all_ms.slice(RUNS))));
  }
  return records;
}

async function networksOfRosto(files) {
  const { default: init, Networks } = await import("/target/bench/networks.js");
  await init();
  const { ms: ready_ms, value: made } = await timed(() => new Networks(files.detector, files.landmark));
  return { ready_ms, run: (network, picture) => (network === "detector" ? made.detect(picture) : made.mesh(picture)) };
}

async function networksOfOnnxRuntime(files) {
  const ort = await import("/node_modules/onnxruntime-web/dist/ort.wasm.bundle.min.mjs");
  ort.env.wasm.numThreads = 1;
  ort.env.wasm.wasmPaths = new URL("/node_modules/onnxruntime-web/dist/", location.href).href;
  const session = (network) => ort.InferenceSession.create(files[network]);
  // The first session loads the runtime, which is not measured for Rosto either.
  await session("detector");
  const { ms: ready_ms, value: sessions } = await timed(async () => {
    return { detector: await session("detector"), landmark: await session("landmark") };
  });
  const run = (network, picture, side) => {
    const [input] = sessions[network].inputNames;
    return sessions[network].run({ [input]: new ort.Tensor("float32", picture, [1, 3, side, side]) });
  };
  return { ready_ms, run };
}

/** Tracks a face through the video of the end-to-end tests; the peers alternate on the same frames and timestamps. */
export async function video() {
  const portrait = await portraitPixels();
  const programs = { [ROSTO]: await followRosto(), [FACE_MESH]: await followMediaPipe() };
  const seen = Object.fromEntries(Object.keys(programs).map((peer) => [peer, []]));
  for (let number = -WARM_UP; number < frames.FRAMES + TURNING; number += 1) {
    const pixels = new ImageData(frames.frameOf(portrait, poseIn(number), Math.abs(number)), frames.WIDTH_PX, frames.HEIGHT_PX);
    for (const [peer, follow] of Object.entries(programs)) {
      const answer = await follow(pixels, (1000 / frames.FRAMES_PER_S) * (number + WARM_UP + 1));
      if (number >= 0) seen[peer].push({ number, ...answer });
    }
  }
  return Object.entries(seen).flatMap(([peer, all]) => videoRecords(peer, all));
}

/** Place of the face in a frame: the tests' video, then a face that turns and approaches. */
function poseIn(number) {
  if (number < frames.FRAMES) return frames.poseIn(Math.max(0, number));
  const phase = (2 * Math.PI * (number - frames.FRAMES)) / TURNING;
  return { ...frames.poseIn(0), degrees: 20 * Math.sin(phase), scale: 1.6 - 0.3 * (1 - Math.cos(phase)) / 2 };
}

async function portraitPixels() {
  const bitmap = await createImageBitmap(await (await fetch(PHOTO)).blob());
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height);
}

async function followRosto() {
  globalThis.parts = await import(`${PACKAGE}rosto.js`);
  const { client } = await import("/tests/e2e/following-page.mjs");
  const vision = await client();
  return async (pixels, time_ms) => {
    const bitmap = await createImageBitmap(pixels);
    const { ms, value: { frame, landmarks } } = await timed(() => vision.follow(bitmap, time_ms));
    frame.close();
    return { ms, points: landmarks && Array.from({ length: landmarks.length / 3 }, (_, at) => [landmarks[3 * at], landmarks[3 * at + 1]]) };
  };
}

async function followMediaPipe() {
  const find = await faceMesh({ maxNumFaces: 1, refineLandmarks: true });
  const context = Object.assign(document.createElement("canvas"), { width: frames.WIDTH_PX, height: frames.HEIGHT_PX }).getContext("2d");
  return async (pixels, time_ms) => {
    context.putImageData(pixels, 0, 0);
    const { ms, value: [face] } = await timed(() => find(context.canvas, time_ms));
    return { ms, points: face?.map(({ x, y }) => [x, y]) };
  };
}

/** @param {string} peer @param {{ number: number, ms: number, points?: number[][] }[]} all */
function videoRecords(peer, all) {
  const lost = all.filter(({ points }) => !points).map(({ number }) => number);
  if (lost.length > 0) throw new Error(`${peer} found no face in frames ${lost}`);
  const px = all.map(({ number, points }) => ({ number, points: points.map(([x, y]) => [x * frames.WIDTH_PX, y * frames.HEIGHT_PX]) }));
  const still = px.filter(({ number }) => number < frames.STILL_FRAMES);
  const rest = still[0].points.map((_, at) => [0, 1].map((axis) => mean(still.map(({ points }) => points[at][axis]))));
  const squares = still.flatMap(({ points }) => points.map(([x, y], at) => (x - rest[at][0]) ** 2 + (y - rest[at][1]) ** 2));
  const moving = px.filter(({ number }) => number < frames.FRAMES && frames.speedIn(number) !== 0);
  const lags_ms = moving.map(({ number, points }) => {
    const aside_px = frames.poseIn(number).x - frames.poseIn(0).x;
    const behind_px = mean(points.map(([x], at) => rest[at][0] + aside_px - x));
    return (1000 / frames.FRAMES_PER_S) * (behind_px / frames.speedIn(number));
  });
  const times_ms = all.map(({ ms }) => ms).sort((a, b) => a - b);
  const record = (what, unit, value) => ({ task: "video in Chrome", what, size: "640×480 px", peer, unit, value });
  return [
    record("frame to 478 landmarks", "ms", median(times_ms)),
    record("frame to 478 landmarks, 95th percentile", "ms", times_ms[Math.floor(0.95 * times_ms.length)]),
    record("jitter of a face at rest, RMS", "px", Math.sqrt(mean(squares))),
    record("lag behind a face at 200 px/s", "ms", Math.abs(mean(lags_ms))),
  ];
}

/** The page's start, a photo, and slider ticks from the input event to the end of the last listener. */
export async function editing() {
  await until(() => document.body?.dataset.host === "open");
  const record = (what, size, value) => ({ task: "page in Chrome", what, size, peer: ROSTO, unit: "ms", value });
  const records = [record("navigation to a usable page", null, performance.now())];
  const transfer = new DataTransfer();
  transfer.items.add(new File([await (await fetch(PHOTO)).blob()], "portrait.png"));
  const { ms: face_ms } = await timed(async () => {
    document.getElementById("stage")?.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    await until(() => document.body.dataset.state === "face");
  });
  records.push(record("dropped photo to face on the canvas", "512 px PNG", face_ms));
  await until(() => document.body.dataset.texture === undefined);
  for (let entry = 0; entry < ENTRIES; entry += 1) edit(11 * entry + 1);
  const entries = document.querySelectorAll("#history .check").length;
  if (entries < ENTRIES) throw new Error(`${entries} entries, not ${ENTRIES}`);
  for (const [density, size] of [["0", "468 vertices"], ["3", "28881 vertices"]]) {
    set(document.getElementById("density"), density, "change");
    await new Promise((done) => setTimeout(done, 500));
    const range = document.querySelector("#landmark-offset [data-axis='z'] input[type=range]");
    let tick = 0;
    const ticks_ms = await repeated(RUNS, async () => {
      for (let event = 0; event < EVENTS; event += 1) set(range, String((tick++ % 60) / 10), "input");
    });
    records.push(record(`slider tick with all listeners, ${ENTRIES} edits`, size, median(ticks_ms) / EVENTS));
  }
  return records;
}

/** @param {number} landmark */
function edit(landmark) {
  set(document.getElementById("landmark-search"), String(landmark), "change");
  const number = document.querySelector("#landmark-offset [data-axis='z'] .number-field");
  set(number, "0.5", "input");
  set(number, "0.5", "change");
}

function set(control, value, event) {
  control.value = value;
  control.dispatchEvent(new Event(event, { bubbles: true }));
}

/** Loads MediaPipe's Face Mesh; resolves to a function that returns the faces in a picture. */
async function faceMesh(options) {
  await new Promise((loaded, failed) => {
    const script = document.createElement("script");
    Object.assign(script, { src: `${MEDIAPIPE}face_mesh.js`, onload: loaded, onerror: failed });
    document.head.append(script);
  });
  const mesh = new globalThis.FaceMesh({ locateFile: (name) => MEDIAPIPE + name });
  mesh.setOptions(options);
  let faces;
  mesh.onResults(({ multiFaceLandmarks }) => {
    faces = multiFaceLandmarks ?? [];
  });
  await mesh.initialize();
  return async (image, time_ms) => {
    faces = [];
    await mesh.send({ image }, time_ms);
    return faces;
  };
}

async function bytes(url) {
  return new Uint8Array(await (await fetch(url)).arrayBuffer());
}

async function until(holds) {
  while (!holds()) await new Promise((next) => setTimeout(next, 5));
}

/** Times in ms of repeated work. Each run starts at an animation frame. */
async function repeated(times, work) {
  const all_ms = [];
  for (let time = 0; time < times; time += 1) {
    await new Promise(requestAnimationFrame);
    all_ms.push((await timed(work)).ms);
  }
  return all_ms;
}

async function timed(work) {
  const start = performance.now();
  const value = await work();
  return { ms: performance.now() - start, value };
}

function median(numbers) {
  return numbers.toSorted((a, b) => a - b)[numbers.length >> 1];
}

function mean(numbers) {
  return numbers.reduce((sum, each) => sum + each, 0) / numbers.length;
}
