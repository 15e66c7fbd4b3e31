import { fetchFile } from "../files.ts";
import { byId } from "../page/dom.ts";
import { fill } from "./photo-drawing.ts";

const TIMEOUT_MS = 60_000;

/** The head in the sample photo, px. */
const HEAD = { left: 120, top: 16, side: 208 };

let sample: Promise<Blob> | undefined;

/** Fetches the sample photo once; retries after a failure. */
export function loadSample() {
  sample ??= fetchSample().catch((error) => {
    sample = undefined;
    throw { code: "not-loaded", message: `sample.png: ${error}`, hint: "" };
  });
  return sample;
}

/** Shows the sample photo as a thumbnail on its button. */
export async function showSample() {
  const { left, top, side } = HEAD;
  const face = await createImageBitmap(await loadSample(), left, top, side, side);
  fill(byId("sample-thumbnail", HTMLCanvasElement), face);
  face.close();
}

async function fetchSample() {
  const signal = AbortSignal.timeout(TIMEOUT_MS);
  return (await fetchFile(new URL("./sample.png", import.meta.url), { signal })).blob();
}
