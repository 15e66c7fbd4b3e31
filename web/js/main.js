import { byId, onAction } from "./page/dom.js";
import { hideNotice, setUpNotice, showPhotoTrouble, showTrouble } from "./page/notice.js";
import { keepOffline } from "./page/offline.js";
import { countRequests } from "./page/privacy.js";
import { hideProgress, setUpProgress, showLoading, showStage } from "./page/progress.js";
import { setUpTabs } from "./page/tabs.js";
import { setUpTheme } from "./page/theme.js";
import { setUpExportPanel } from "./panel/export-panel.js";
import { setUpHistoryPanel } from "./panel/history-panel.js";
import { LandmarkPanel } from "./panel/landmark-panel.js";
import { setUpViewPanel } from "./panel/view-panel.js";
import { setUpPhotoInput } from "./photo/photo-input.js";
import { PhotoOverlay } from "./photo/photo-overlay.js";
import { LandmarkMarks } from "./viewport/landmark-marks.js";
import { setUpViewKeys } from "./viewport/shortcuts.js";
import { Workbench } from "./viewport/workbench.js";
import { inEveryLanguage, language, speak, writeWords } from "./words/words.js";
import { Replaced, VisionClient } from "./photo/vision-client.js";

/** @typedef {import("./worker/protocol.js").FoundFaces} FoundFaces */

setUpWords();
setUpNotice();
setUpProgress();
setUpTabs();
setUpCredits();

const vision = new VisionClient();
const overlay = new PhotoOverlay();
const bench = openBench();
/** @type {Promise<Blob> | undefined} */
let sample;

setUpTheme((theme) => bench.then((opened) => opened?.look((studio) => studio.setTheme(theme))));
setUpPhotoInput(openPhoto);
onAction("sample", async () => {
  try {
    await openPhoto(await loadSample());
  } catch (error) {
    showTrouble(error);
  }
});
countRequests(loadTheRest());

/** The 3D view and every panel that works on it; nothing where there is no WebGPU. */
async function openBench() {
  try {
    const opened = await Workbench.open(byId("viewport", HTMLCanvasElement));
    new LandmarkMarks(opened, overlay);
    setUpViewKeys(opened);
    new LandmarkPanel(opened);
    setUpViewPanel(opened);
    setUpHistoryPanel(opened);
    setUpExportPanel(opened);
    opened.look((studio) => studio.showCanonical());
    document.body.dataset["bench"] = "open";
    return opened;
  } catch (error) {
    document.body.dataset["bench"] = "closed";
    showTrouble(error);
    return undefined;
  }
}

/** What is not needed for the first look: the worker, the sample, and the copy for use offline. */
async function loadTheRest() {
  await afterFirstPaint();
  vision.start();
  await vision.ready;
  await Promise.allSettled([loadSample(), keepOffline()]);
}

/** @param {Blob} photo */
async function openPhoto(photo) {
  hideNotice();
  showLoading();
  try {
    const found = await vision.find(photo, 1, showStage);
    await openFace(found, 0);
    hideProgress();
  } catch (error) {
    // The newer photo now has the progress to itself.
    if (error instanceof Replaced) return;
    hideProgress();
    showPhotoTrouble(error);
  }
}

/**
 * @param {FoundFaces} found
 * @param {number} index
 */
async function openFace(found, index) {
  const face = found.faces[index];
  if (!face) throw { code: "no-face", message: "no face in the photo", hint: "" };
  await overlay.show(found, face);
  const opened = await bench;
  opened?.act((studio) =>
    studio.openFace(
      face.landmarks,
      found.width_px,
      found.height_px,
      face.colours,
      found.picture,
      found.pictureWidth_px,
      found.pictureHeight_px,
    ),
  );
  document.body.dataset["state"] = opened ? "face" : "photo";
  byId("welcome", HTMLElement).hidden = true;
  byId("toolbar", HTMLDivElement).hidden = !opened;
}

function loadSample() {
  sample ??= fetchSample().catch((error) => {
    sample = undefined;
    throw error;
  });
  return sample;
}

async function fetchSample() {
  const response = await fetch(new URL("../assets/sample.png", import.meta.url));
  if (!response.ok) throw { code: "not-loaded", message: `sample.png: ${response.status}`, hint: "" };
  return response.blob();
}

function afterFirstPaint() {
  return new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}

function setUpWords() {
  const choice = byId("language", HTMLSelectElement);
  choice.value = language();
  choice.addEventListener("change", () => speak(choice.value));
  inEveryLanguage(writeWords);
}

function setUpCredits() {
  const dialog = byId("credits", HTMLDialogElement);
  byId("credits-open", HTMLButtonElement).addEventListener("click", () => dialog.showModal());
  onAction("close-credits", () => dialog.close());
}
