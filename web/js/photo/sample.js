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
  const response = await fetch(new URL("../../assets/sample.png", import.meta.url));
  if (!response.ok) throw { code: "not-loaded", message: `sample.png: ${response.status}`, hint: "" };
  return response.blob();
}
