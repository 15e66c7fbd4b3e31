// How long it takes from a photo's bytes to its landmarks in headless Chrome: Rosto's worker module and, in the same
// browser, the published @mediapipe/face_mesh; and how long each network takes by itself, here (networks.rs, compiled for
// the web as the worker is) and in onnxruntime-web, on the same files and one thread.
//
// Rosto and MediaPipe decode the photo anew each time. MediaPipe keeps tracking the face between pictures, so it looks
// for it only once; Rosto looks for it in every picture.
import path from "node:path";
import { ROOT, inBlankPage, report } from "./blank-page.mjs";

const RUNS = 40;

await measure("rosto", path.join(ROOT, "dist"), rosto);
await measure("@mediapipe/face_mesh", path.join(ROOT, "node_modules/@mediapipe/face_mesh"), peer);

const BUILT = path.join(process.env.CARGO_TARGET_DIR ?? path.join(ROOT, "target"), "bench");
const BESIDE = { assets: path.join(ROOT, "web/assets"), ort: path.join(ROOT, "node_modules/onnxruntime-web/dist") };
for (const { what, times_ms } of await inBlankPage(BUILT, networksAlone, RUNS, BESIDE)) report(what, times_ms);

async function measure(name, folder, work) {
  const { start_ms, first_ms, times_ms } = await inBlankPage(folder, work, RUNS);
  report({ task: "networks-start-chrome", peer: name }, [start_ms]);
  report({ task: "first-landmarks-chrome", peer: name }, [first_ms]);
  report({ task: "photo-to-landmarks-chrome", peer: name }, times_ms);
}

/** Runs in the browser. */
async function rosto(runs) {
  const bytes = async (name) => new Uint8Array(await (await fetch(name)).arrayBuffer());
  const photo = await bytes("sample.png");
  const before = performance.now();
  const { default: init, Vision } = await import("./wasm/rosto-vision-web.js");
  await init();
  const vision = new Vision(await bytes("assets/face_detector.onnx"), await bytes("assets/face_landmarks_attention.onnx"));
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

/** Runs in the browser: both networks in both programs, turn by turn, so that what else the machine does meets all. */
async function networksAlone(runs) {
  const bytes = async (name) => new Uint8Array(await (await fetch(`assets/${name}.onnx`)).arrayBuffer());
  const files = { detector: await bytes("face_detector"), landmark: await bytes("face_landmarks") };
  const planes = (side) => Float32Array.from({ length: 3 * side * side }, (_, i) => Math.sin(i / 97) / 2 + 0.5);
  const pictures = { detector: planes(128), landmark: planes(192) };
  const lines = [];
  const programs = { rosto: await ofRosto(), "onnxruntime-web": await ofOnnxRuntime() };
  for (const network of ["detector", "landmark"]) {
    const times = Object.fromEntries(Object.keys(programs).map((peer) => [peer, []]));
    for (let run = 0; run < 2 * runs; run += 1) {
      for (const [peer, program] of Object.entries(programs)) {
        const ms = await elapsed(() => program[network]());
        // The first half is the browser's, to find out what is worth compiling well.
        if (run >= runs) times[peer].push(ms);
      }
    }
    for (const [peer, times_ms] of Object.entries(times)) {
      lines.push({ what: { task: `${network}-network-chrome`, peer }, times_ms });
      lines.push({ what: { task: `${network}-network-least-chrome`, peer }, times_ms: [Math.min(...times_ms)] });
    }
  }
  return lines;

  async function ofRosto() {
    const { default: init, Networks } = await import("./networks.js");
    await init();
    let networks;
    const make = () => (networks = new Networks(files.detector, files.landmark));
    lines.push({ what: { task: "networks-make-chrome", peer: "rosto" }, times_ms: [await elapsed(make)] });
    return { detector: () => networks.detect(pictures.detector), landmark: () => networks.mesh(pictures.landmark) };
  }

  async function ofOnnxRuntime() {
    const ort = await import("./ort/ort.wasm.bundle.min.mjs");
    ort.env.wasm.numThreads = 1;
    ort.env.wasm.wasmPaths = new URL("ort/", location.href).href;
    const session = async (network) => await ort.InferenceSession.create(files[network]);
    // The first session loads the program, which is not counted, as it is not above.
    await session("detector");
    let sessions;
    const make = async () => (sessions = { detector: await session("detector"), landmark: await session("landmark") });
    lines.push({ what: { task: "networks-make-chrome", peer: "onnxruntime-web" }, times_ms: [await elapsed(make)] });
    return { detector: () => run("detector", 128), landmark: () => run("landmark", 192) };

    async function run(network, side) {
      const input = new ort.Tensor("float32", pictures[network], [1, 3, side, side]);
      return await sessions[network].run({ [sessions[network].inputNames[0]]: input });
    }
  }

  async function elapsed(action) {
    const start = performance.now();
    await action();
    return performance.now() - start;
  }
}
