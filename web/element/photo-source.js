/**
 * A file from an address, with the name that it has there.
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
 * The picture that stands in an element for its photo, once its address is settled.
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
