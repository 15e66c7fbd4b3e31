import { isTyping } from "../page/dom.ts";

/** Whether an element is shown. Without a size, nothing can be drawn. */
export function hasSize({ clientWidth, clientHeight }: Element) {
  return clientWidth > 0 && clientHeight > 0;
}

/** Resolves once an element is shown; rejects when `signal` aborts. */
export function untilShown(element: Element, signal: AbortSignal) {
  return new Promise<void>((resolve, reject) => {
    const observer = new ResizeObserver(() => hasSize(element) && resolve());
    observer.observe(element);
    signal.addEventListener("abort", () => reject(signal.reason));
    // A hidden tab does not observe sizes.
    if (hasSize(element)) resolve();
  });
}

/** Listens to the keys of undo and redo in an element, except while typing. */
export function onUndoKey(root: ShadowRoot, act: (what: "undo" | "redo") => void, signal: AbortSignal) {
  const listener = (event: Event) => {
    if (!(event instanceof KeyboardEvent) || !(event.ctrlKey || event.metaKey) || isTyping(event)) return;
    if (!/^[zy]$/i.test(event.key)) return;
    event.preventDefault();
    act(event.shiftKey || event.key.toLowerCase() === "y" ? "redo" : "undo");
  };
  root.addEventListener("keydown", listener, { signal });
}

/** Fetches a file and names it after its URL. */
export async function fetchedFile(address: string, base: string) {
  try {
    const url = new URL(address, base);
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${response.status} for ${url}`);
    return new File([await response.blob()], nameIn(url));
  } catch (error) {
    throw { code: "unreadable-file", message: String(error), hint: "" };
  }
}

function nameIn({ protocol, pathname }: URL) {
  const name = protocol.startsWith("http") ? (pathname.split("/").at(-1) ?? "") : "";
  try {
    return decodeURIComponent(name);
  } catch {
    // Not encoded, as in 100%.jpg.
    return name;
  }
}
