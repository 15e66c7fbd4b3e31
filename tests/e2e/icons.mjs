// Draws web/icons/*.png from the SVG icon. Run it after changes to the SVG.
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { launch } from "./browser.mjs";

const ICONS = path.resolve(import.meta.dirname, "../../web/icons");

const svg = await readFile(path.join(ICONS, "rosto.svg"), "utf8");
const browser = await launch();
for (const side_px of [192, 512]) {
  const page = await browser.newPage({ viewport: { width: side_px, height: side_px } });
  // Square corners: systems round icons themselves.
  const square = svg.replace('rx="14"', "").replace("<svg ", `<svg width="${side_px}" height="${side_px}" style="display:block" `);
  await page.setContent(`<body style="margin:0">${square}</body>`);
  await writeFile(path.join(ICONS, `rosto-${side_px}.png`), await page.screenshot());
  await page.close();
}
await browser.close();
