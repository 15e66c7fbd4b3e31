import { byId } from "../page/dom.js";

/**
 * A link that shows the face in the room, on devices whose browsers open USDZ files so: Safari on iPhones and iPads. The
 * file is made when it is pressed, and the link is then followed by itself. Safari tells the format by the file's name.
 *
 * @param {() => Promise<File>} make
 * @param {(error: unknown) => void} complain
 */
export function setUpArLink(make, complain) {
  const link = byId("ar-link", HTMLAnchorElement);
  link.hidden = !link.relList.supports?.("ar");
  let isReady = false;
  const follow = (/** @type {File} */ file) => {
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
    make().then(follow).catch(complain);
  });
}
