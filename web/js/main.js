import { setUpDialogs } from "./page/dialogs.js";
import { byId, onAction } from "./page/dom.js";
import { hint, setUpHints } from "./page/hint.js";
import { hideNotice, setUpNotice, showPhotoTrouble, showTrouble } from "./page/notice.js";
import { keepOffline } from "./page/offline.js";
import { countRequests } from "./page/privacy.js";
import { hideProgress, setUpProgress, showLoading, showStage } from "./page/progress.js";
import { setUpTabs } from "./page/tabs.js";
import { afterNextFrame, nextTask } from "./page/tasks.js";
import { setUpTheme } from "./page/theme.js";
import { Validator } from "./page/validator.js";
import { EditOptions } from "./panel/edit-options.js";
import { setUpExportPanel } from "./panel/export-panel.js";
import { FacePanel } from "./panel/face-panel.js";
import { setUpHandChoice } from "./panel/hand-choice.js";
import { setUpHistoryPanel } from "./panel/history-panel.js";
import { LandmarkPanel } from "./panel/landmark-panel.js";
import { PaperPanel } from "./panel/paper-panel.js";
import { chooseDensity, chooseTriangulation, setUpViewPanel } from "./panel/view-panel.js";
import { setUpCamera } from "./photo/camera.js";
import { FaceChoice } from "./photo/face-choice.js";
import { setUpPhotoInput } from "./photo/photo-input.js";
import { openPicture } from "./photo/open-picture.js";
import { PhotoOverlay } from "./photo/photo-overlay.js";
import { loadSample } from "./photo/sample.js";
import { Replaced, VisionClient } from "./photo/vision-client.js";
import { LandmarkMarks } from "./viewport/landmark-marks.js";
import { setUpViewKeys } from "./viewport/shortcuts.js";
import { isFallback } from "./viewport/studio-module.js";
import { Workbench } from "./viewport/workbench.js";
import { inEveryLanguage, language, speak, writeWords } from "./words/words.js";
import { isGlbFile, readGlbFile } from "./work/glb-file.js";
import { isProjectFile, readProjectFile } from "./work/project-file.js";
import { WorkKeeper } from "./work/work-keeper.js";
import { bitmapOf, faceOf } from "./work/work.js";

/** A group photo offers this many faces at most. */
const MAX_FACES = 8;

setUpWords();
setUpNotice();
setUpProgress();
setUpHints();
setUpTabs();
setUpDialogs();

const vision = new VisionClient();
const overlay = new PhotoOverlay();
const keeper = new WorkKeeper();
const validator = new Validator();
/** @type {PaperPanel | undefined} */
let paper;
const bench = openBench();
/** @type {import("./worker/protocol.js").FoundFaces | undefined} */
let found;
let lastOpened = Promise.resolve();
const faceChoice = new FaceChoice((index) => {
  if (found) openFace(faceOf(found, index), found.bitmap).catch(showPhotoTrouble);
});

setUpTheme((theme) => bench.then((opened) => opened?.look((studio) => studio.setTheme(theme))));
setUpPhotoInput(openFile);
setUpCamera(openFile);
onAction("sample", () => loadSample().then(openFile, showPhotoTrouble));
keeper.offer((work) => openWork(work));
countRequests(loadTheRest());
dispatchEvent(new Event("started"));

/** The 3D view and every panel that works on it; nothing where the browser cannot draw in 3D. */
async function openBench() {
  try {
    const opened = await Workbench.open(byId("viewport", HTMLCanvasElement));
    const options = new EditOptions(opened);
    new LandmarkMarks(opened, overlay, (factor) => options.widen(factor));
    setUpViewKeys(opened);
    new LandmarkPanel(opened);
    setUpHandChoice(opened);
    new FacePanel(opened);
    setUpViewPanel(opened);
    setUpHistoryPanel(opened);
    setUpExportPanel(opened, keeper, validator);
    paper = new PaperPanel(opened);
    keeper.follow(opened);
    opened.look((studio) => studio.showCanonical());
    document.body.dataset["bench"] = "open";
    return opened;
  } catch (error) {
    document.body.dataset["bench"] = "closed";
    showTrouble(error);
    return undefined;
  }
}

/** What is not needed for the first look: the workers, the sample, and the copy for use offline. */
async function loadTheRest() {
  await afterNextFrame();
  vision.start();
  await vision.ready;
  await bench;
  await Promise.allSettled([loadSample(), validator.start(), keepOffline(isFallback())]);
}

/**
 * A photo, or a project or GLB that was saved before.
 *
 * @param {Blob} file
 */
async function openFile(file) {
  hideNotice();
  try {
    if (await isProjectFile(file)) await openWork(await readProjectFile(file));
    else if (await isGlbFile(file)) await openGlb(file);
    else await openPhoto(file);
  } catch (error) {
    // The newer photo now has the progress to itself.
    if (error instanceof Replaced) return;
    hideProgress();
    showPhotoTrouble(error);
  }
}

/** @param {Blob} photo */
async function openPhoto(photo) {
  showLoading();
  // The worker may have to load before it begins.
  let begun_ms = NaN;
  const faces = await vision.find(photo, MAX_FACES, (stage, fraction) => {
    if (Number.isNaN(begun_ms)) begun_ms = performance.now();
    showStage(stage, fraction);
  });
  await openFace(faceOf(faces, 0), faces.bitmap, performance.now() - begun_ms);
  found = faces;
  await faceChoice.show(faces);
  hideProgress();
}

/** @param {Blob} file a GLB, which the page's own module reads */
async function openGlb(file) {
  await bench;
  await openWork(await readGlbFile(file));
}

/** @param {import("./work/work.js").Work} work */
async function openWork({ face, edits, triangulation, density = 0 }) {
  const opened = await bench;
  if (opened) {
    chooseTriangulation(opened, triangulation);
    chooseDensity(opened, density);
  }
  await openFace(face, await bitmapOf(face));
  found = undefined;
  faceChoice.hide();
  opened?.act((studio) => studio.openEdits(edits));
}

/**
 * One face after the other: each takes several tasks to come in.
 *
 * @param {import("./work/work.js").OpenedFace} face
 * @param {ImageBitmap} bitmap its picture
 * @param {number} [extraction_ms] how long finding its landmarks took
 */
function openFace(face, bitmap, extraction_ms) {
  const opened = lastOpened.then(() => bringIn(face, bitmap, extraction_ms));
  lastOpened = opened.catch(() => {});
  return opened;
}

/**
 * @param {import("./work/work.js").OpenedFace} face
 * @param {ImageBitmap} bitmap
 * @param {number} [extraction_ms]
 */
async function bringIn(face, bitmap, extraction_ms) {
  overlay.show(face, bitmap);
  const opened = await bench;
  // The photo on the panel, its pixels and the face each have a task of their own, so that none keeps the page waiting.
  await nextTask();
  if (opened) await openPicture(opened.studio, face);
  opened?.act((studio) => {
    studio.openFace(face.landmarks, face.width_px, face.height_px, face.colours);
  });
  document.body.dataset["state"] = opened ? "face" : "photo";
  byId("welcome", HTMLElement).hidden = true;
  byId("toolbar", HTMLDivElement).hidden = !opened;
  // A phone's sheet has no room for the photo beside the tools.
  if (matchMedia("(width < 720px)").matches) byId("section-photo", HTMLDetailsElement).open = false;
  if (!opened) return;
  paper?.forget(extraction_ms);
  keeper.take(face);
  hint("drag", "turn");
}

function setUpWords() {
  const choice = byId("language", HTMLSelectElement);
  choice.value = language();
  choice.addEventListener("change", () => speak(choice.value));
  inEveryLanguage(writeWords);
}
