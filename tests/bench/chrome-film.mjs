// How long it takes from a frame of a film to its landmarks in headless Chrome, how much they tremble on a face that rests,
// and how far they are behind one that moves: Rosto's worker, asked as the page asks it, and the published
// @mediapipe/face_mesh, which follows too. Frame by frame in turn, in one page, on the same pixels and the same times.
//
// The film is that of the journeys: at rest with a camera's noise, then to and fro; and then turning and nearing.
import path from "node:path";
import { ROOT, inBlankPage, report } from "./blank-page.mjs";

const BESIDE = {
  film: path.join(ROOT, "tests/journeys"),
  face_mesh: path.join(ROOT, "node_modules/@mediapipe/face_mesh"),
};

for (const { peer, times_ms, jitter_px, lag_ms } of await inBlankPage(path.join(ROOT, "dist"), follow, 60, BESIDE)) {
  const sorted = times_ms.toSorted((a, b) => a - b);
  report({ task: "film-frame-chrome", peer }, times_ms);
  report({ task: "film-frame-least-chrome", peer }, [sorted[0]]);
  report({ task: "film-frame-95th-chrome", peer }, [sorted[Math.floor(0.95 * sorted.length)]]);
  report({ task: "film-jitter-chrome", peer }, [jitter_px], "px");
  report({ task: "film-lag-chrome", peer }, [lag_ms]);
}

/** Runs in the browser. `turning`: so many frames in which the face turns and nears. */
async function follow(turning) {
  const film = await import("./film/film-frames.mjs");
  const { WIDTH_PX, HEIGHT_PX, FRAMES, FRAMES_PER_S, STILL_FRAMES } = film;
  /** So many frames of the face at rest come before those that count. */
  const WARM_UP = 30;
  const portrait = await portraitPixels();
  const programs = { rosto: await ofRosto(), "@mediapipe/face_mesh": await ofMediaPipe() };
  const seen = Object.fromEntries(Object.keys(programs).map((peer) => [peer, []]));
  for (let number = -WARM_UP; number < FRAMES + turning; number += 1) {
    const pixels = new ImageData(film.frameOf(portrait, placeIn(number), Math.abs(number)), WIDTH_PX, HEIGHT_PX);
    for (const [peer, follow] of Object.entries(programs)) {
      const answer = await follow(pixels, (1000 / FRAMES_PER_S) * (number + WARM_UP + 1));
      if (number >= 0) seen[peer].push({ number, ...answer });
    }
  }
  return Object.entries(seen).map(([peer, frames]) => ({ peer, ...figures(frames) }));

  function placeIn(number) {
    if (number < FRAMES) return film.placeIn(Math.max(0, number));
    const phase = (2 * Math.PI * (number - FRAMES)) / turning;
    return { ...film.placeIn(0), degrees: 20 * Math.sin(phase), scale: 1.6 - 0.3 * (1 - Math.cos(phase)) / 2 };
  }

  async function portraitPixels() {
    const bitmap = await createImageBitmap(await (await fetch("sample.png")).blob());
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height);
  }

  async function ofRosto() {
    const { VisionClient } = await import("./js/photo/vision-client.js");
    const vision = new VisionClient();
    vision.start();
    await vision.ready;
    return async (pixels, time_ms) => {
      const bitmap = await createImageBitmap(pixels);
      const started = performance.now();
      const { landmarks, frame } = await vision.follow(bitmap, time_ms);
      const ms = performance.now() - started;
      frame.close();
      const points = landmarks && Array.from({ length: landmarks.length / 3 }, (_, at) => [landmarks[3 * at], landmarks[3 * at + 1]]);
      return { ms, points };
    };
  }

  async function ofMediaPipe() {
    await new Promise((loaded, failed) => {
      const script = document.createElement("script");
      Object.assign(script, { src: "face_mesh/face_mesh.js", onload: loaded, onerror: failed });
      document.head.append(script);
    });
    const mesh = new globalThis.FaceMesh({ locateFile: (name) => `face_mesh/${name}` });
    mesh.setOptions({ maxNumFaces: 1, refineLandmarks: true });
    let points;
    mesh.onResults(({ multiFaceLandmarks: [face] = [] }) => (points = face?.map(({ x, y }) => [x, y])));
    await mesh.initialize();
    const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH_PX, height: HEIGHT_PX });
    const context = canvas.getContext("2d");
    return async (pixels, time_ms) => {
      context.putImageData(pixels, 0, 0);
      points = undefined;
      const started = performance.now();
      await mesh.send({ image: canvas }, time_ms);
      return { ms: performance.now() - started, points };
    };
  }

  /** @param {{ number: number, ms: number, points?: number[][] }[]} frames */
  function figures(frames) {
    const lost = frames.filter(({ points }) => !points);
    if (lost.length > 0) throw new Error(`no face in frames ${lost.map(({ number }) => number)}`);
    const px = frames.map(({ number, points }) => ({ number, points: points.map(([x, y]) => [x * WIDTH_PX, y * HEIGHT_PX]) }));
    const still = px.filter(({ number }) => number < STILL_FRAMES);
    const rest = still[0].points.map((_, at) => [0, 1].map((axis) => mean(still.map(({ points }) => points[at][axis]))));
    const squares = still.flatMap(({ points }) => points.map(([x, y], at) => (x - rest[at][0]) ** 2 + (y - rest[at][1]) ** 2));
    const lags = px.filter(({ number }) => number < FRAMES && film.speedIn(number) !== 0).map(({ number, points }) => {
      const aside = film.placeIn(number).x - film.placeIn(0).x;
      const behind_px = mean(points.map(([x], at) => rest[at][0] + aside - x));
      return (1000 / FRAMES_PER_S) * (behind_px / film.speedIn(number));
    });
    return { times_ms: frames.map(({ ms }) => ms), jitter_px: Math.sqrt(mean(squares)), lag_ms: Math.abs(mean(lags)) };
  }

  function mean(numbers) {
    return numbers.reduce((sum, each) => sum + each, 0) / numbers.length;
  }
}
