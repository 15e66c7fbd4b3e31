// How long it takes from a photo's bytes to its landmarks in headless Chrome: Rosto's worker module and, in the same
// browser, the published @mediapipe/face_mesh.
//
// Both decode the photo anew each time. The peer keeps tracking the face between pictures, so it looks for it only
// once; Rosto looks for it in every picture.
import path from "node:path";
import { ROOT, inBlankPage, report } from "./blank-page.mjs";

const RUNS = 40;

await measure("rosto", path.join(ROOT, "dist"), rosto);
await measure("@mediapipe/face_mesh", path.join(ROOT, "node_modules/@mediapipe/face_mesh"), peer);

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
