import { pageOpening } from "./page-opening.ts";
import { setUpLivePreview } from "./live/live-preview.ts";
import { announce } from "./page/announce.ts";
import { setUpDialogs } from "./page/dialogs.ts";
import { byId, onAction } from "./page/dom.ts";
import { completeHint, setUpHints } from "./page/hint.ts";
import { hideNotice, setUpNotice, showError } from "./page/notice.ts";
import { setUpExport } from "./panel/export.ts";
import { setUpPanels } from "./panel/page-panels.ts";
import { textOf } from "./panel/phrase.ts";
import { storeOffline, useVersion } from "./offline.ts";
import { countRequests } from "./page/privacy.ts";
import { setUpProgress } from "./page/progress.ts";
import { remember, remembered } from "./page/remember.ts";
import { setUpTabs } from "./page/tabs.ts";
import { afterNextFrame } from "./page/tasks.ts";
import { setUpTheme } from "./page/theme.ts";
import { Validator } from "./page/validator.ts";
import { PaperPanel } from "./panel/paper-panel.ts";
import { PhotosPanel } from "./panel/photos-panel.ts";
import { setUpCamera } from "./photo/camera.ts";
import { FaceChoice } from "./photo/face-choice.ts";
import { setUpPhotoInput } from "./photo/photo-input.ts";
import { PhotoOverlay } from "./photo/photo-overlay.ts";
import { loadSample, showSample } from "./photo/sample.ts";
import { VisionClient } from "./photo/vision-client.ts";
import { setUpBeforeAfter } from "./viewport/before-after.ts";
import { setUpSplitView } from "./viewport/split-view.ts";
import { setUpBrushMarks } from "./viewport/brush-marks.ts";
import { setUpViewportInsets } from "./viewport/viewport-insets.ts";
import { LandmarkMarks } from "./viewport/landmark-marks.ts";
import { setUpPulse } from "./viewport/pulse.ts";
import { setUpScene } from "./viewport/scene-switch.ts";
import { setUpEditKeys, setUpViewKeys } from "./viewport/shortcuts.ts";
import { WholeTexture } from "./viewport/whole-texture.ts";
import { Host } from "./viewport/host.ts";
import { onLocaleChange, language, languages, loadWords, setLanguage, translatePage } from "./words/words.ts";
import { Autosave } from "./work/autosave.ts";
import { FaceFiles } from "./work/face-files.ts";

useVersion();
await loadWords(remembered("language") ?? navigator.language);
setUpLanguage();
setUpNotice();
setUpProgress();
setUpHints();
setUpTabs();
setUpDialogs();

const vision = new VisionClient();
const overlay = new PhotoOverlay();
const autosave = new Autosave(() => opening.remember());
const validator = new Validator();
let paper: PaperPanel | undefined;
const host = openHost();
const faceChoice = new FaceChoice((face) => opening.openFace(face));
const opening = pageOpening({ host, vision, overlay, faceChoice, autosave, onOpened: (extraction_ms) => paper?.forget(extraction_ms) });

setUpTheme((theme) => host.then((opened) => opened?.apply({ theme })));
setUpPhotoInput((file) => opening.openFile(file));
setUpCamera((photo) => opening.openFile(photo, "selfie"));
setUpLivePreview({ host, vision, opening });
onAction("sample", () => opening.openFile(loadSample(), "sample"));
autosave.offer((read) => opening.openWork(read));
countRequests(loadInBackground());
dispatchEvent(new Event("started"));

/** Sets up the 3D view and the panels that use it. Resolves to undefined if the browser cannot draw in 3D. */
async function openHost() {
  try {
    const opened = await Host.open(byId("viewport", HTMLCanvasElement), { show: showError, hide: hideNotice });
    overlay.follow(opened);
    opened.onSaid((said) => announce(textOf(said)));
    setUpPanels(opened);
    setUpEditKeys({ undo: () => opened.apply("undo"), redo: () => opened.apply("redo"), cancel: () => opened.apply("cancel") });
    followMotionSetting(opened);
    new LandmarkMarks(opened, { tag: byId("landmark-tag", HTMLOutputElement), overlay, onGesture: completeHint, announce });
    setUpBeforeAfter(opened);
    setUpPulse(opened);
    setUpViewportInsets(opened);
    setUpViewKeys(opened, completeHint);
    setUpScene(opened);
    setUpSplitView(opened);
    setUpBrushMarks(opened);
    new PhotosPanel(opened, opening, vision);
    const files = new FaceFiles(opened, vision, opening);
    new WholeTexture(opened, files, (isMaking) => document.body.toggleAttribute("data-texture", isMaking));
    setUpExport({ host: opened, opening, validator, files, pictureSize: () => overlay.pictureSize });
    paper = new PaperPanel(opened);
    autosave.follow(opened);
    opened.onRestart(() => resetView(opened));
    opened.apply("close");
    document.body.dataset["host"] = "open";
    return opened;
  } catch (error) {
    document.body.dataset["host"] = "closed";
    showError(error);
    return undefined;
  }
}

/** Loads what the first view does not need: workers, sample photo and offline copy. */
async function loadInBackground() {
  await afterNextFrame();
  vision.start();
  await vision.ready;
  await host;
  await Promise.allSettled([showSample(), validator.start(), storeOffline()]);
}

/** Sets up a restarted studio, which then gets its face again. */
async function resetView(opened: Host) {
  const theme = document.documentElement.dataset["theme"] === "dark" ? "dark" : "light";
  opened.apply({ theme });
  opened.apply({ "reduced-motion": matchMedia("(prefers-reduced-motion: reduce)").matches });
  opened.apply("close");
  paper?.forget(undefined);
}

function followMotionSetting(opened: Host) {
  const setting = matchMedia("(prefers-reduced-motion: reduce)");
  const apply = () => opened.apply({ "reduced-motion": setting.matches });
  setting.addEventListener("change", apply);
  apply();
}

function setUpLanguage() {
  const choice = byId("language", HTMLSelectElement);
  choice.replaceChildren(...languages().map(({ id, name }) => new Option(name, id)));
  choice.value = language();
  choice.addEventListener("change", () => {
    setLanguage(choice.value).then(() => remember("language", language()), () => (choice.value = language()));
  });
  onLocaleChange(translatePage);
}
