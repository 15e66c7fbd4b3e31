import { byId, make, onAction } from "../page/dom.ts";
import { asPageError } from "../page/page-error.ts";
import { toast } from "../page/toast.ts";
import { validate } from "../page/validator.ts";
import { setUpClip } from "../share/clip-button.ts";
import { canCopyPictures, canShare, copyPicture, save, share } from "../share/share.ts";
import { isWord, t } from "../words/words.ts";
import { leadPhotoOf } from "../work/face.ts";
import { fileName, numberedName } from "../work/file-name.ts";
import type { Opening } from "../opening.ts";
import type { Host } from "../viewport/host.ts";
import type { FaceFiles } from "../work/face-files.ts";
import type { Report } from "../../wasm/rosto-studio-web.js";
import type { PrintedBody } from "../../wasm/rosto-vision-web.js";

/** Debounce delay: computing a body takes time. */
const DEBOUNCE_MS = 250;

/** A file that takes longer is shown, and can be cancelled. */
const BUSY_MS = 300;

interface Context {
  host: Host;
  opening: Opening;
  files: FaceFiles;
  /** Size in px of the lead photo's picture. */
  pictureSize: () => { width: number; height: number };
}

/** Loads the parts that make pictures and clips, before their first use would count as a request. */
export function loadPictures() {
  return Promise.all([import("../share/pictures.ts"), import("../share/clip.ts")]);
}

/** Performs the actions of the export panel: files, pictures and sharing. */
export function setUpExport(context: Context) {
  offerMeshes(context);
  const makePhoto = offerPhoto(context);
  const makePicture = offerPictures(context);
  setUpClip(context.host, context.opening);
  setUpSaving(context.host);
  perform(context.host, "save.share", async () => {
    const [isPhoto, isEdited] = context.host.read(({ chosen, canUndo }) => [chosen["scene"] === "picture", canUndo]) ?? [];
    const file = isPhoto ? await makePhoto("image/jpeg", "jpg") : await makePicture(isEdited ? "before-after" : "view");
    if (file) await share(file);
  });
}

/** The main button saves what the stage shows; the other one opens the menu. */
function setUpSaving(host: Host) {
  const menu = byId("save-popover", HTMLDivElement);
  const press = (id: string) => byId(id, HTMLButtonElement).click();
  onAction("save.main", () => {
    const isPhoto = host.read(({ chosen }) => chosen["scene"] === "picture");
    press(isPhoto ? "download-photo-jpeg" : "download-glb");
  });
  onAction("save.more", () => menu.togglePopover());
  menu.addEventListener("toggle", () => {
    const isOpen = menu.matches(":popover-open");
    byId("save-more", HTMLButtonElement).ariaExpanded = String(isOpen);
    if (isOpen) menu.querySelector<HTMLButtonElement>("button:enabled")?.focus();
  });
  // The clip shows its progress in the menu.
  menu.addEventListener("click", ({ target }) => target instanceof Element && !target.closest(".clip") && menu.hidePopover());
  onAction("open-print", () => {
    press("tab-export");
    const fold = byId("print", HTMLDetailsElement);
    fold.open = true;
    fold.scrollIntoView({ block: "start" });
    fold.querySelector("summary")?.focus();
  });
}

/** Meshes, for other programs, for printing and for AR, and the project. */
function offerMeshes({ host, opening, files }: Context) {
  const report = (about: Report) => host.applyShown({ report: about });
  const makeMesh = async (format: string) => {
    // The face and its density may change meanwhile.
    const [options, name] = host.answer((studio) => [studio.fileOptions(), studio.fileName("")]);
    const { face } = opening;
    const { bytes, extension, mediaType } = await files.mesh(format, options);
    // The texture is the same at each density, and the view is saved as PNG, too.
    const fullName = format === "png" ? fileName(face, extension, "texture") : name + extension;
    return new File([bytes], fullName, { type: mediaType });
  };
  const makeGlb = async (isValidated: boolean) => {
    report({ "glb-started": { isValidated } });
    try {
      const file = await makeMesh("glb");
      const validated = isValidated ? await validate(new Uint8Array(await file.arrayBuffer())) : undefined;
      const verdict = validated ? { validated } : "unchecked";
      report({ "glb-made": { bytes: file.size, verdict: isValidated ? verdict : undefined } });
      return file;
    } catch (error) {
      report("glb-failed");
      throw error;
    }
  };
  perform(host, "check-glb", () => makeGlb(true));
  perform(host, "download-glb", async () => save(await makeGlb(true)));
  perform(host, "share-glb", async () => share(await makeGlb(false)));
  const shownWhileMaking = async (format: string) => {
    const name = host.answer((studio) => studio.fileName(format));
    const timer = setTimeout(() => report({ making: name }), BUSY_MS);
    try {
      return await makeMesh(format);
    } finally {
      clearTimeout(timer);
      report({ making: undefined });
    }
  };
  onAction("cancel-file", () => files.cancel());
  const print = setUpPrint(host, files);
  const { formats, printedFormats } = host.catalogue;
  for (const id of formats.filter((id) => id !== "glb")) {
    const download = async () => save(await shownWhileMaking(id));
    perform(host, `download-${id}`, printedFormats.includes(id) ? () => print(download) : download);
  }
  perform(host, "save-project", async () => {
    const name = fileName(opening.face, "rosto");
    save(new File([await files.project()], name, { type: "application/octet-stream" }));
  });
  const link = byId("ar-link", HTMLAnchorElement);
  link.hidden = !link.relList.supports?.("ar");
  link.addEventListener("click", (event) => {
    event.preventDefault();
    makeMesh("usdz").then(viewInAr).catch((error) => host.fail(error));
  });
}

/** Performs the action of a button. */
function perform(host: Host, name: string, act: () => Promise<unknown>) {
  onAction(name, () => act().catch((error) => isCancelled(error) || host.fail(error)));
}

function isCancelled(error: unknown) {
  return asPageError(error).code === "cancelled";
}

/** Opens a USDZ in AR Quick Look, which detects the format by the file name and expects a picture in the link. */
function viewInAr(file: File) {
  const link = make("a", "", make("img"));
  Object.assign(link, { rel: "ar", href: URL.createObjectURL(file), download: file.name });
  link.click();
  // The browser reads the file after this task.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/**
 * Measures the printed body while its panel is visible, and shows it in place of the 3D face; the worker computes it.
 * Returns a function that makes a file of the body, and shows in the panel why it could not.
 */
function setUpPrint(host: Host, files: FaceFiles) {
  const fold = byId("print", HTMLDetailsElement);
  let timer = 0;
  /** Numbers of the last change, and of the one whose body was last asked for. */
  let [changed, measured] = [1, 0];
  /** The body of the last measured change. */
  let body: PrintedBody | undefined;
  let isVisible = false;
  const show = (report: Report) => host.applyShown({ report });
  const showBody = () => {
    if (!isVisible || !body || changed !== measured) return;
    const { positionsM, triangles, colours } = body;
    host.act((studio) => studio.showPrint(positionsM, triangles, colours));
  };
  const refusal = (error: unknown): Report => {
    const { code, maxMm } = asPageError(error);
    return { "body-failed": { code: isWord(`error.${code}`) ? code : "other", maxMm } };
  };
  const print = async () => files.print(host.answer((studio) => studio.fileOptions()));
  const measure = async () => {
    const number = changed;
    measured = number;
    const made = await print().then(
      (printed): [Report, PrintedBody?] => [{ "body-measured": printed?.facts }, printed],
      (error): [Report] | undefined => (isCancelled(error) ? undefined : [refusal(error)]),
    );
    if (!made) changed += 1;
    if (!made || number !== changed) return;
    const [report, printed] = made;
    body = printed;
    if (body) showBody();
    else host.act((studio) => studio.hidePrint());
    show(report);
  };
  const measureSoon = () => {
    clearTimeout(timer);
    if (measured !== changed && isVisible) timer = setTimeout(measure, DEBOUNCE_MS);
  };
  const follow = () => {
    const wasVisible = isVisible;
    isVisible = fold.open && fold.checkVisibility();
    measureSoon();
    if (isVisible === wasVisible) return;
    if (isVisible) showBody();
    else host.act((studio) => studio.hidePrint());
  };
  host.on("change", () => {
    changed += 1;
    measureSoon();
  });
  // The fold or its tab opens or closes.
  new ResizeObserver(follow).observe(fold);
  return async (make: () => Promise<void>) => {
    const number = changed;
    await make().catch((error) => {
      if (isCancelled(error)) return;
      // A pending result would hide the reason, unless the body has changed since.
      if (number === changed) {
        clearTimeout(timer);
        changed += 1;
        measured = changed;
        body = undefined;
      }
      show(refusal(error));
    });
  };
}

/** The edited photo, at full size if its own file was opened. Returns a function that makes it, unless it is being made. */
function offerPhoto({ host, opening, files, pictureSize }: Context) {
  const report = (about: Report) => host.applyShown({ report: about });
  let isWriting = false;
  const make = async (type: "image/png" | "image/jpeg", extension: string) => {
    const { face } = opening;
    if (!face || isWriting) return undefined;
    isWriting = true;
    report({ "writing-photo": true });
    try {
      const photo = await files.editedPhoto(type);
      return new File([photo], numberedName(face, extension, "edited"), { type });
    } finally {
      isWriting = false;
      report({ "writing-photo": false });
    }
  };
  const write = async (...format: Parameters<typeof make>) => {
    const file = await make(...format);
    if (file) save(file);
  };
  perform(host, "download-photo-png", () => write("image/png", "png"));
  perform(host, "download-photo-jpeg", () => write("image/jpeg", "jpg"));
  host.on("change", () => {
    const { face } = opening;
    if (!face) return;
    const { width, height } = pictureSize();
    const isSaved = leadPhotoOf(face).source.kind === "saved";
    report({ face: { stem: face.name, savedPx: isSaved ? [width, height] : undefined } });
  });
  return make;
}

/** Pictures of the view, alone or before and after the edits. Returns a function that makes one. */
function offerPictures({ host, opening }: Context) {
  const sharesModels = canShare("model/gltf-binary", "face.glb");
  const sharesPictures = canShare("image/png", "face.png");
  host.applyShown({ report: { abilities: { sharesModels, sharesPictures, copiesPictures: canCopyPictures() } } });
  const draw = async (content: "view" | "before-after") => {
    const { drawPair, drawView } = await import("../share/pictures.ts");
    return content === "view" ? drawView(host) : drawPair(host, [t("before"), t("after")]);
  };
  const make = async (content: "view" | "before-after") => {
    // The face may change meanwhile.
    const { face } = opening;
    const picture = await draw(content);
    return new File([picture], numberedName(face, "png", content), { type: picture.type });
  };
  perform(host, "download-picture", async () => save(await make("view")));
  perform(host, "copy-picture", () => copyPicture(draw("view")).then(() => toast(t("export.copied"))));
  perform(host, "download-pair", async () => save(await make("before-after")));
  return make;
}
