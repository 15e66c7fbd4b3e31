import { fetchFile } from "../files.ts";
import { text } from "./checks.ts";

/** Whether an element is shown. Without a size, nothing can be drawn. */
export function hasSize({ clientWidth, clientHeight }: Element) {
  return clientWidth > 0 && clientHeight > 0;
}

/** Resolves once an element is shown; rejects when `signal` aborts. */
export function untilShown(element: Element, signal: AbortSignal) {
  return new Promise<void>((resolve, reject) => {
    const observer = new ResizeObserver(() => {
      if (!hasSize(element)) return;
      observer.disconnect();
      resolve();
    });
    observer.observe(element);
    signal.addEventListener("abort", () => reject(signal.reason));
    // A hidden tab does not observe sizes.
    if (hasSize(element)) resolve();
  });
}

/** The file of a photo; an address is fetched, and names the file. */
export function photoFile(photo: unknown, base: string) {
  if (photo instanceof Blob) return Promise.resolve(photo);
  return fetched(text("photo", photo, "a Blob or an address"), base).catch((error) => {
    throw { code: "unreadable-file", message: String(error), hint: "" };
  });
}

async function fetched(address: string, base: string) {
  const url = new URL(address, base);
  const blob = await (await fetchFile(url)).blob();
  const name = url.protocol.startsWith("http") ? url.pathname.split("/").at(-1) : "";
  // Unlike decodeURIComponent, this accepts 100%.jpg.
  const decoded = new URLSearchParams(`name=${name?.replaceAll(/[&+]/g, encodeURIComponent)}`).get("name");
  return new File([blob], decoded ?? "");
}
