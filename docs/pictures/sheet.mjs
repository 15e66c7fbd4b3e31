import { PNG } from "pngjs";

/**
 * @typedef {object} Cell
 * @property {Uint8Array | string} picture PNG bytes or SVG source
 * @property {string} caption
 * @property {{ left: number, top: number }} [pointer] position as shares of the picture's size
 */

const ARROW = '<path d="M1 1v18l5-4 3 7 4-2-3-7h6Z" />';

/**
 * Writes a contact sheet of captioned pictures as a JPEG.
 *
 * @param {import("@playwright/test").Browser} browser
 * @param {string} file
 * @param {Cell[]} cells
 * @param {{ columns: number, width: number }} layout `width` is the maximum for each picture, px
 */
export async function writeSheet(browser, file, cells, { columns, width }) {
  const page = await browser.newPage();
  await page.setContent(`<!doctype html><style>
    body { display: grid; grid-template-columns: repeat(${columns}, auto); gap: 16px; width: max-content; margin: 0; padding: 16px;
      background: #f5f3ef; color: #26241f; font: 400 14px/20px system-ui, "Noto Sans", sans-serif; }
    figure { display: grid; align-content: start; gap: 4px; max-width: ${width}px; margin: 0; }
    div { position: relative; width: fit-content; }
    div > :first-child { display: block; max-width: 100%; max-height: ${width}px; border-radius: 4px; }
    .pointer { position: absolute; width: 15px; height: 18px; fill: #26241f; stroke: #fff; stroke-width: 1.5; }
  </style>${cells.map(figure).join("")}`);
  await page.locator("body").screenshot({ path: file, type: "jpeg", quality: 80 });
  await page.close();
}

/** @param {Cell} cell */
function figure({ picture, caption, pointer }) {
  const image = typeof picture === "string" ? picture : `<img src="data:image/png;base64,${Buffer.from(picture).toString("base64")}">`;
  const arrow = pointer ? `<svg class="pointer" viewBox="0 0 20 24" style="left: ${100 * pointer.left}%; top: ${100 * pointer.top}%">${ARROW}</svg>` : "";
  return `<figure><div>${image}${arrow}</div><figcaption>${caption}</figcaption></figure>`;
}

/** Crops a PNG. @param {Uint8Array} png @param {{ x: number, y: number, width: number, height: number }} box */
export function cut(png, { x, y, width, height }) {
  const part = new PNG({ width, height });
  PNG.bitblt(PNG.sync.read(Buffer.from(png)), part, x, y, width, height, 0, 0);
  return PNG.sync.write(part);
}
