// In the browser: a GLB in <model-viewer>, as a page on the web shows it.
import "/node_modules/@google/model-viewer/dist/model-viewer.min.js";

/** Shows a file; returns its size in metres once it is drawn. @param {string} url */
export async function show(url) {
  document.querySelector("model-viewer")?.remove();
  const viewer = document.createElement("model-viewer");
  const shown = new Promise((resolve, reject) => {
    viewer.addEventListener("load", resolve, { once: true });
    viewer.addEventListener("error", ({ detail }) => reject(new Error(JSON.stringify(detail))), { once: true });
  });
  Object.assign(viewer, { src: url, loading: "eager", interactionPrompt: "none" });
  document.body.append(viewer);
  await shown;
  await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  const { x, y, z } = viewer.getDimensions();
  return [x, y, z];
}
