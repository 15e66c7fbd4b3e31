/** A server that has not sent it all by then is not going to. */
const PATIENCE_MS = 60_000;

/** @type {Promise<Blob> | undefined} */
let sample;

/** The sample portrait, fetched once, or again after a failure. */
export function loadSample() {
  sample ??= fetchSample().catch((error) => {
    sample = undefined;
    throw error;
  });
  return sample;
}

async function fetchSample() {
  try {
    const response = await fetch(new URL("../../assets/sample.png", import.meta.url), { signal: AbortSignal.timeout(PATIENCE_MS) });
    if (!response.ok) throw new Error(`status ${response.status}`);
    return await response.blob();
  } catch (error) {
    throw { code: "not-loaded", message: `sample.png: ${error}`, hint: "" };
  }
}
