/**
 * The worker that decodes photos and saved files, finds and follows faces, and writes files. It holds no user data that
 * the page cannot send again, so the page can terminate and restart it at any time.
 */

import init, { Vision } from "../../wasm/rosto-vision-web.js";
import { fetchFile } from "../files.ts";
import { asPageError } from "../page/page-error.ts";
import { bytesOf } from "../work/bytes.ts";
import { bitmapOf, encoded } from "../work/pixels.ts";
import { follow } from "./frames.ts";
import { decoded, keepPictures, readFile } from "./source-files.ts";
import type { FaceTask, FollowRequest, OpenRequest, Reply, Request, Stage } from "./protocol.ts";
import type { SourceFile } from "../work/face.ts";
import type { Picture } from "../work/pixels.ts";

export type LoadRequest = Extract<Request, { type: "load"; }>;

const page = ((self as unknown) as DedicatedWorkerGlobalScope);

/** Held for the life of this worker. The browser releases it even after a crash, which the page detects. */
const lock = `rosto-vision-${crypto.randomUUID()}`;
navigator.locks.request(lock, () => {
  post({ type: "alive", lock });
  return new Promise(() => {});
});

const MAX_FACES = 20;

/** Minimum interval between loading reports. */
const REPORT_EVERY_MS = 1000;

let onLoadRequest: (place: LoadRequest) => void = (): void => {};
/** The page's first message, with the URLs of the files. */
const loadRequest: Promise<LoadRequest> = new Promise((resolve) => (onLoadRequest = resolve));
const vision = loadRequest.then(load);
let networks: Promise<void> | undefined;
/** Queue: a task must not drop the pictures of another one. */
let queue: Promise<unknown> = Promise.resolve();

page.addEventListener("message", (event) => handle(event.data));
reportLoaded();

async function reportLoaded() {
  try {
    await vision;
    // Without the networks, faces are still reopened and written; the next photo retries.
    await withNetworks().catch(() => {});
    post({ type: "ready" });
  } catch (error) {
    post({ type: "unusable", error: asPageError(error, "not-loaded") });
  }
}

function handle(request: Request) {
  switch (request.type) {
    case "load":
      return onLoadRequest(request);
    case "open":
      return answer(request, () => open(request));
    case "follow":
      return handleFollow(request);
    case "stop-following":
      // A failure to load was already posted as unusable.
      return vision.then((vision) => vision.stopFollowing(), () => {});
    default:
      return answer(request, () => enqueue(() => perform(request)));
  }
}

async function load({ module }: LoadRequest) {
  // In parallel. Errors surface where the networks are used.
  withNetworks().catch(() => {});
  await init({ module_or_path: fetchReported(module) });
  return new Vision();
}

/** Resolves once the module has its networks. */
function withNetworks() {
  networks ??= loadNetworks().catch((error) => {
    networks = undefined;
    throw error;
  });
  return networks;
}

async function loadNetworks() {
  const { detector, landmarks } = await loadRequest;
  const files = [detector, landmarks].map(async (url) => new Uint8Array(await (await fetchReported(url)).arrayBuffer()));
  const networks = await Promise.all(files).catch((error) => Promise.reject(asPageError(error, "not-loaded")));
  const [detectorBytes = new Uint8Array(), landmarksBytes = new Uint8Array()] = networks;
  (await vision).loadNetworks(detectorBytes, landmarksBytes);
}

/** Fetches a file, and reports that it is arriving, which resets the page's watchdog on a slow connection. */
async function fetchReported(url: string) {
  const response = await fetchFile(url);
  // Errors surface where the file is used.
  readAndReport(response.clone()).catch(() => {});
  return response;
}

/** @param response a copy, read only to observe its progress */
async function readAndReport(response: Response) {
  const reader = response.body?.getReader();
  let reported_ms = -Infinity;
  while (reader && !(await reader.read()).done) {
    if (performance.now() - reported_ms < REPORT_EVERY_MS) continue;
    reported_ms = performance.now();
    post({ type: "loading" });
  }
}

/** Runs `act` after the tasks queued before it. */
function enqueue<T>(act: () => Promise<T>): Promise<T> {
  const done = queue.then(act);
  queue = done.catch(() => {});
  return done;
}

/** Posts the result of a request, or its error. */
async function answer({ type, id }: OpenRequest | (FaceTask & { id: number; }), act: () => Promise<{ answer: unknown; transfer?: Transferable[]; }>) {
  try {
    const { answer, transfer } = await act();
    post({ type, id, answer }, transfer);
  } catch (error) {
    postFailure("failed", id, error);
  }
}

async function open({ id, key, file }: OpenRequest) {
  const module = await vision;
  const { bytes, isSaved } = await readFile(file);
  if (!isSaved) await withNetworks();
  const report: (stage: Stage, fraction: number) => void = (stage, fraction): void => post({ type: "progress", id, stage, fraction });
  return enqueue(async () => {
    const opened = await decoded(file, bytes, (readable, original) => module.open(key, readable, MAX_FACES, report, original));
    const bitmaps = await Promise.all((opened.faces[0]?.pictures ?? []).map((picture) => bitmapOf(module.picture(picture))));
    const answer = { key, file: new Blob([bytes], { type: file.type }), opened, bitmaps };
    return { answer, transfer: bitmaps };
  });
}

async function perform(task: FaceTask & { files: SourceFile[]; }): Promise<{ answer: unknown; transfer?: Transferable[]; }> {
  const module = await vision;
  await keepPictures(module, picturesFor(task), task.files);
  switch (task.type) {
    case "picture":
      return withBitmap(module.picture(task.picture));
    case "texture":
      return withBitmap(module.texture(task.face, task.size));
    case "write": {
      const written = module.write(task.face, task.format, task.options, task.name);
      return { answer: written, transfer: [written.bytes.buffer] };
    }
    case "write-project": {
      const bytes = module.writeProject(task.face);
      return { answer: bytes, transfer: [bytes.buffer] };
    }
    case "solid-facts":
      return { answer: module.solidFacts(task.face, task.options) };
    case "edited-photo":
      return { answer: await editedPhoto(module, task) };
  }
}

/** The pictures that a task reads. */
function picturesFor(task: FaceTask & { files: SourceFile[]; }) {
  switch (task.type) {
    case "picture":
      return [task.picture];
    case "solid-facts":
      return [];
    case "edited-photo":
      return task.lead.source.kind === "saved" ? [task.lead.picture] : [];
    default:
      return task.face.pictures;
  }
}

async function withBitmap(picture: Picture) {
  const bitmap = await bitmapOf(picture);
  return { answer: bitmap, transfer: [bitmap] };
}

/** Draws the lead photo with the edits at full size, or at the size stored in a saved file. */
async function editedPhoto(module: Vision, { face, lead: { picture, source }, falloffBand, mediaType }: Extract<FaceTask, { type: "edited-photo"; }>) {
  const file = source.kind === "photo" ? source.file : await encoded(module.picture(picture), "image/png");
  const edited = await decoded(file, await bytesOf(file), (bytes) => module.editedPhoto(face, bytes, falloffBand));
  return encoded(edited, mediaType);
}

async function handleFollow({ id, frame, time_ms }: FollowRequest) {
  try {
    const module = await vision;
    await withNetworks();
    const followed = follow(module, frame, time_ms);
    const { landmarks } = followed;
    post({ type: "followed", id, followed }, landmarks ? [frame, landmarks.buffer] : [frame]);
  } catch (error) {
    frame.close();
    postFailure("not-followed", id, error);
  }
}

function postFailure(type: "failed" | "not-followed", id: number, error: unknown) {
  // A trap leaves the module's memory in an undefined state, so the page restarts the worker.
  if (error instanceof WebAssembly.RuntimeError) post({ type: "trapped", id, message: error.message });
  else post({ type, id, error: asPageError(error) });
}

function post(reply: Reply, transfer: Transferable[] = []) {
  page.postMessage(reply, transfer);
}
