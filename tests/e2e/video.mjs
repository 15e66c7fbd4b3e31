// Video files for a fake camera.
import { createHash } from "node:crypto";
import { existsSync } from "node:fs";
import { mkdir, readFile, rename, writeFile } from "node:fs/promises";
import path from "node:path";
import { PNG } from "pngjs";
import { FRAMES, FRAMES_PER_S, HEIGHT_PX, WIDTH_PX, frameOf, poseIn } from "./video-frames.mjs";
import { yuvOf } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

const HERE = import.meta.dirname;
const FOLDER = path.join(process.env.CARGO_TARGET_DIR ?? path.join(HERE, "../../target"), "videos");

/** The video of `poseIn` as .y4m, cached by a hash of its sources. */
export async function movingVideo() {
  const sources = [SAMPLE, ...["video.mjs", "video-frames.mjs", "pictures.mjs"].map((name) => path.join(HERE, name))];
  const hash = createHash("sha256");
  for (const source of sources) hash.update(await readFile(source));
  const file = path.join(FOLDER, `moving-${hash.digest("hex").slice(0, 16)}.y4m`);
  if (existsSync(file)) return file;
  await mkdir(FOLDER, { recursive: true });
  // Another test may write the same file, so rename it when complete.
  const unfinished = `${file}.${process.pid}`;
  await writeFile(unfinished, frames(PNG.sync.read(await readFile(SAMPLE))));
  await rename(unfinished, file);
  return file;
}

function* frames(portrait) {
  yield `YUV4MPEG2 W${WIDTH_PX} H${HEIGHT_PX} F${FRAMES_PER_S}:1 Ip A1:1 C420\n`;
  for (let number = 0; number < FRAMES; number += 1) {
    yield yuvOf({ width: WIDTH_PX, height: HEIGHT_PX, data: frameOf(portrait, poseIn(number), number) });
  }
}

/** The portrait's landmarks as found by MediaPipe: x and y, px. */
export async function portraitLandmarks() {
  const { portrait } = JSON.parse(await readFile(path.join(HERE, "../golden/refined_landmarks.json"), "utf8"));
  const [face] = portrait.faces;
  return Array.from({ length: face.length / 3 }, (_, point) => [face[3 * point] / 1000, face[3 * point + 1] / 1000]);
}
