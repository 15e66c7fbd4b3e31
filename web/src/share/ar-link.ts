import { byId } from "../page/dom.ts";

/**
 * Sets up the link that opens the face in AR Quick Look, in Safari on iPhone and iPad. A click creates the USDZ file
 * and then clicks the link again. Safari detects the format by the file name.
 */
export function setUpArLink(make: () => Promise<File>, onError: (error: unknown) => void) {
  const link = byId("ar-link", HTMLAnchorElement);
  link.hidden = !link.relList.supports?.("ar");
  let isReady = false;
  const follow = (file: File) => {
    if (link.href.startsWith("blob:")) URL.revokeObjectURL(link.href);
    link.href = URL.createObjectURL(file);
    link.download = file.name;
    isReady = true;
    link.click();
    isReady = false;
  };
  link.addEventListener("click", (event) => {
    if (isReady) return;
    event.preventDefault();
    make().then(follow).catch(onError);
  });
}
