import init, { Vision } from "../../wasm/rosto-vision-web.js";
import { fetchFile } from "../files.ts";
import { asPageError } from "../page/page-error.ts";
import { bitmapOf, encoded } from "../work/pixels.ts";
import { readPixels } from "./frames.ts";
import { runPaper } from "./paper.ts";
import { bytesOf, decoded, keepPictures, readFile } from "./source-files.ts";
import type { FaceRequest, FileOptions } from "../../wasm/rosto-vision-web.js";
import type { SourceFile } from "../work/face.ts";
import type { PhotoType, Report } from "./protocol.ts";

const MAX_FACES = 20;

/** Random choices of handles and anchors for each method of the paper. The first equals the command line's first run. */
const PAPER_RUNS = 5;
const PAPER_SEED = 0;

/** A request that reads pictures brings their files, so that a restarted worker can decode them again. */
type WithFiles<T> = T & { files: SourceFile[] };
type OfFace<T = unknown> = WithFiles<{ face: FaceRequest } & T>;
type EditedPhoto = OfFace<{ lead: { picture: string; source: SourceFile }; falloffBand: number; mediaType: PhotoType }>;

let vision: Promise<Vision>;
let networkUrls: string[] = [];
let networks: Promise<void> | undefined;
/** Number of the paper's latest run. */
let paperRun = 0;
/** Queue: a task must not drop the pictures of another one. */
let queue: Promise<unknown> = Promise.resolve();

export type Tasks = typeof tasks;

/** Tasks that the page can request, by the type of the request. */
export const tasks = {
  /** Takes the URLs of the module and of its networks; the page sends this first. */
  load: async ({ module, networks }: { module: string; networks: string[] }) => {
    networkUrls = networks;
    vision = init({ module_or_path: fetchReported(module) }).then(() => new Vision()).catch(notLoaded);
    // Without the networks, faces are still reopened and written; the next photo retries.
    await Promise.all([vision, withNetworks().catch(() => {})]);
  },

  /** Opens a photo, GLB or project under a new key: finds its faces, with the pictures of the first one. */
  open: async ({ file }: { file: Blob }, report: Report) => {
    const module = await vision;
    const { bytes, isSaved } = await readFile(file);
    if (!isSaved) await withNetworks();
    const key = crypto.randomUUID();
    return enqueue(async () => {
      const opened = await decoded(file, bytes, (readable, original) =>
        module.open(key, readable, MAX_FACES, report, original));
      const pictures = opened.faces[0]?.pictures ?? [];
      const bitmaps = await Promise.all(pictures.map((picture) => bitmapOf(module.picture(picture))));
      // In memory, so that the file stays readable.
      return { key, file: new Blob([bytes], { type: file.type }), opened, bitmaps };
    });
  },

  picture: ({ picture, files }: WithFiles<{ picture: string }>) =>
    withPictures([picture], files, (module) => bitmapOf(module.picture(picture))),

  texture: ({ face, size, files }: OfFace<{ size: string }>) =>
    withPictures(face.pictures, files, (module) => bitmapOf(module.texture(face, size))),

  write: ({ face, format, options, name, files }: OfFace<{ format: string; options: FileOptions; name: string }>) =>
    withPictures(face.pictures, files, (module) => module.write(face, format, options, name)),

  "write-project": ({ face, files }: OfFace) =>
    withPictures(face.pictures, files, (module) => module.writeProject(face) as Uint8Array<ArrayBuffer>),

  print: ({ face, options, files }: OfFace<{ options: FileOptions }>) =>
    withPictures([], files, (module) => module.print(face, options)),

  /** Draws the lead photo with the edits at full size, or at the size stored in a saved file. */
  "edited-photo": ({ face, lead: { picture, source }, files, falloffBand, mediaType }: EditedPhoto) =>
    withPictures(source.kind === "saved" ? [picture] : [], files, async (module) => {
      const file = source.kind === "photo" ? source.file : await encoded(module.picture(picture), "image/png");
      const edited = await decoded(file, await bytesOf(file), (bytes) => module.editedPhoto(face, bytes, falloffBand));
      return encoded(edited, mediaType);
    }),

  /** Runs the paper's experiment next to other tasks; undefined if it was stopped. A new run stops the last one. */
  paper: async ({ face }: { face: FaceRequest }, report: Report) => {
    const number = ++paperRun;
    const run = (await vision).paper(face, PAPER_RUNS, PAPER_SEED);
    try {
      return await runPaper(run, (share) => report("paper", share), () => number === paperRun);
    } finally {
      run.free();
    }
  },

  "stop-paper": async (_: object) => {
    paperRun += 1;
  },

  /**
   * Follows a face into the next frame of a camera stream. `landmarks`: 478 × (x/W, y/H, z/W), smoothed over time;
   * absent without a face. `took_ms`: time to read the pixels and to find the landmarks.
   */
  follow: async ({ frame, time_ms }: { frame: ImageBitmap; time_ms: number }) => {
    try {
      const module = await withNetworks();
      const start_ms = performance.now();
      const { data, width, height } = readPixels(frame);
      const read_ms = performance.now() - start_ms;
      const landmarks = module.follow(new Uint8Array(data.buffer), width, height, time_ms);
      const took_ms = { read: read_ms, landmarks: performance.now() - start_ms - read_ms };
      return { time_ms, landmarks, width_px: frame.width, height_px: frame.height, took_ms, frame };
    } catch (error) {
      frame.close();
      throw error;
    }
  },

  /** Forgets the followed face. */
  "stop-following": async (_: object) => (await vision).stopFollowing(),
};

/** Resolves to the module once it has its networks; retries after a failure. */
async function withNetworks() {
  networks ??= loadNetworks().catch((error) => {
    networks = undefined;
    throw error;
  });
  await networks;
  return vision;
}

async function loadNetworks() {
  const responses = networkUrls.map(async (url) => new Uint8Array(await (await fetchReported(url)).arrayBuffer()));
  const [detector, landmarks] = await Promise.all(responses).catch(notLoaded);
  if (detector && landmarks) (await vision).loadNetworks(detector, landmarks);
}

function notLoaded(error: unknown): never {
  throw asPageError(error, "not-loaded");
}

/** Fetches a file, and reports that it is arriving, which resets the page's watchdog on a slow connection. */
async function fetchReported(url: string) {
  const response = await fetchFile(url);
  const reports = new WritableStream({ write: () => postMessage({ type: "loading" }) });
  // A copy. Errors surface where the file is used.
  response.clone().body?.pipeTo(reports).catch(() => {});
  return response;
}

/** Runs `act` after the tasks queued before it, with the pictures that it reads. */
function withPictures<T>(pictures: string[], files: SourceFile[], act: (module: Vision) => T | Promise<T>) {
  return enqueue(async () => {
    const module = await vision;
    await keepPictures(module, pictures, files);
    return act(module);
  });
}

function enqueue<T>(act: () => Promise<T>): Promise<T> {
  const done = queue.then(act);
  queue = done.catch(() => {});
  return done;
}
