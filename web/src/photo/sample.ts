import { fetchFile } from "../files.ts";
import { byId } from "../page/dom.ts";

const TIMEOUT_MS = 60_000;

/** The head in the sample photo, px. */
const HEAD = { left: 120, top: 16, side: 208 };

let sample: Promise<Blob> | undefined;

/** Fetches the sample photo once; retries after a failure. */
export function loadSample() {
  sample ??= fetchSample().catch((error) => {
    sample = undefined;
    throw error;
  });
  return sample;
}

/** Shows the sample photo as a thumbnail on its button. */
export async function showSample() {
  const canvas = byId("sample-thumbnail", HTMLCanvasElement);
  const { left, top, side } = HEAD;
  const face = await createImageBitmap(await loadSample(), left, top, side, side);
  const context = canvas.getContext("2d");
  if (context) context.imageSmoothingQuality = "high";
  context?.drawImage(face, 0, 0, canvas.width, canvas.height);
  face.close();
}

async function fetchSample() {
  try {
    const response = await fetchFile(new URL("./sample.png", import.meta.url), { signal: AbortSignal.timeout(TIMEOUT_MS) });
    return await response.blob();
  } catch (error) {
    throw { code: "not-loaded", message: `sample.png: ${error}`, hint: "" };
  }
}
