/** Fetches a file and names it after its URL. */
export async function fetchedFile(url: string) {
  try {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${response.status} for ${url}`);
    return new File([await response.blob()], nameIn(url));
  } catch (error) {
    throw { code: "unreadable-file", message: String(error), hint: "" };
  }
}

/** URL of the `img` child, once the browser has chosen its source. */
export function pictureIn(element: HTMLElement) {
  const image = element.querySelector("img");
  return image?.complete || image?.currentSrc ? image.currentSrc || image.src : undefined;
}

function nameIn(url: string) {
  const { protocol, pathname } = new URL(url, location.href);
  const name = protocol.startsWith("http") ? (pathname.split("/").at(-1) ?? "") : "";
  try {
    return decodeURIComponent(name);
  } catch {
    // Not encoded, as in 100%.jpg.
    return name;
  }
}
