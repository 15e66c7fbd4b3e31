import { mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

/** @typedef {{ picture: Uint8Array, caption: string, note?: string, pointer?: { left: number, top: number } }} Cell a PNG and what is said below it; where the pointer is, in shares of its size */
/** @typedef {{ rows: (Cell | undefined)[][], width: number, height: number, theme?: "light" | "dark", most_bytes?: number }} Sheet `width` and `height`: the room for each picture, px */

const QUALITIES = [86, 78, 70, 60, 50];

const COLOURS = { light: { ground: "#f5f3ef", text: "#26241f", line: "#dcd7cc" }, dark: { ground: "#1c1d20", text: "#ece9e3", line: "#35363b" } };

/**
 * Puts pictures together on one, each scaled into its cell above its caption, and writes it as a JPEG of the best quality
 * that its limit leaves.
 *
 * @param {import("playwright-core").Browser} browser
 * @param {string} file
 * @param {Sheet} sheet
 */
export async function writeSheet(browser, file, sheet) {
  const folder = await mkdtemp(path.join(tmpdir(), "rosto-sheet-"));
  const page = await browser.newPage({ viewport: { width: 800, height: 600 } });
  try {
    await page.goto(await asPage(folder, sheet));
    const size = await page.evaluate(() => [document.body.offsetWidth, document.body.offsetHeight]);
    await page.setViewportSize({ width: size[0], height: size[1] });
    await mkdir(path.dirname(file), { recursive: true });
    await writeFile(file, await smallEnough(page, sheet.most_bytes ?? 900_000));
  } finally {
    await page.close();
    await rm(folder, { recursive: true });
  }
}

/** @param {import("playwright-core").Page} page @param {number} most_bytes */
async function smallEnough(page, most_bytes) {
  let picture = Buffer.alloc(0);
  for (const quality of QUALITIES) {
    picture = await page.screenshot({ type: "jpeg", quality });
    if (picture.length <= most_bytes) break;
  }
  return picture;
}

/** The address of a page that shows the sheet. @param {string} folder @param {Sheet} sheet */
async function asPage(folder, sheet) {
  const cells = sheet.rows.flat();
  await Promise.all(cells.map((cell, place) => cell && writeFile(path.join(folder, `${place}.png`), cell.picture)));
  const file = path.join(folder, "sheet.html");
  await writeFile(file, html(sheet, cells));
  return pathToFileURL(file).href;
}

/** @param {Sheet} sheet @param {(Cell | undefined)[]} cells */
function html({ rows, width, height, theme = "light" }, cells) {
  const { ground, text, line } = COLOURS[theme];
  const figures = cells.map((cell, place) => (cell ? figure(cell, place) : "<figure></figure>"));
  return `<!doctype html><meta charset="utf-8"><style>
    body { display: grid; grid-template-columns: repeat(${Math.max(...rows.map((row) => row.length))}, auto); gap: 16px; width: max-content; margin: 0; padding: 16px;
      background: ${ground}; color: ${text}; font: 400 14px/20px system-ui, "Noto Sans", sans-serif; }
    figure { display: grid; align-content: start; justify-items: start; gap: 4px; margin: 0; }
    .picture { position: relative; }
    .picture svg { position: absolute; width: 15px; height: 18px; fill: #26241f; stroke: #fff; stroke-width: 1.5; }
    img { display: block; max-width: ${width}px; max-height: ${height}px; border: 1px solid ${line}; border-radius: 4px; }
    figcaption { max-width: ${width}px; }
    .note { color: #d0342c; }
  </style>${figures.join("")}`;
}

/** @param {Cell} cell @param {number} place */
function figure({ caption, note, pointer }, place) {
  const arrow = pointer ? `<svg viewBox="0 0 20 24" style="left: ${100 * pointer.left}%; top: ${100 * pointer.top}%"><path d="M1 1v18l5-4 3 7 4-2-3-7h6Z" /></svg>` : "";
  const words = `${escaped(caption)}${note ? ` <span class="note">${escaped(note)}</span>` : ""}`;
  return `<figure><div class="picture"><img src="${place}.png">${arrow}</div><figcaption>${words}</figcaption></figure>`;
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}
