/**
 * Fetches a file and names it after its URL.
 *
 * @param {string} url
 */
export async function fetchedFile(url) {
  try {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${response.status} for ${url}`);
    return new File([await response.blob()], nameIn(url));
  } catch (error) {
    throw { code: "unreadable-file", message: String(error), hint: "" };
  }
}

/**
 * URL of the `img` child, once the browser has chosen its source.
 *
 * @param {HTMLElement} element
 */
export function pictureIn(element) {
  const image = element.querySelector("img");
  return image?.complete || image?.currentSrc ? image.currentSrc || image.src : undefined;
}

/** @param {string} url */
function nameIn(url) {
  const { protocol, pathname } = new URL(url, location.href);
  return protocol.startsWith("http") ? decodeURIComponent(pathname.split("/").at(-1) ?? "") : "";
}
