// Pictures of models rather than of the page, each put together on one: every expression, textures beside the truth, a printed body
// in slices. `cargo xtask screenshots` has had the models drawn into target/pictures.
import { execFile } from "node:child_process";
import { readdir, readFile } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";
import { PNG } from "pngjs";
import { launch } from "./browser.mjs";
import { program } from "./command-line.mjs";
import { writeSheet } from "./sheets.mjs";
import { slicesOf } from "./slices.mjs";
import { SAMPLE } from "./visitor.mjs";

const DRAWN = path.resolve(import.meta.dirname, "../../target/pictures");
const IMAGES = path.resolve(import.meta.dirname, "../../docs/images");

const browser = await launch();
await writeSheet(browser, path.join(IMAGES, "expressions.jpg"), { rows: inRows(await expressions(), 5), width: 270, height: 135 });
await writeSheet(browser, path.join(IMAGES, "texture.jpg"), { rows: await textures(), width: 230, height: 230 });
await writeSheet(browser, path.join(IMAGES, "sliced.jpg"), { rows: inRows(await slices(), 3), width: 300, height: 340 });
await browser.close();

async function expressions() {
  const folder = path.join(DRAWN, "expressions");
  const files = (await readdir(folder)).sort();
  return Promise.all(files.map(async (file) => ({ picture: await readFile(path.join(folder, file)), caption: file.slice(3, -4) })));
}

/** A photo of each turn, and the side that it hides as it is, by the photo alone, and by the whole texture. */
function textures() {
  const turns = [0, 20, -20, 40, -40];
  const picture = (/** @type {string} */ name) => readFile(path.join(DRAWN, "texture", `${name}.png`));
  return Promise.all(
    turns.map(async (turn) => {
      const hidden = turn > 0 ? "-45" : "45";
      return [
        { picture: face(await picture(`photo${turn}`)), caption: `The photo, ${turn}°` },
        { picture: face(await picture(`truthat${hidden}`)), caption: "From its hidden side" },
        { picture: face(await picture(`projected${turn}at${hidden}`)), caption: "By the photo alone" },
        { picture: face(await picture(`whole${turn}at${hidden}`)), caption: "By the whole texture" },
      ];
    }),
  );
}

/** The middle of a picture, which the head fills. @param {Uint8Array} png */
function face(png) {
  const whole = PNG.sync.read(Buffer.from(png));
  const side = Math.round(0.62 * whole.width);
  const part = new PNG({ width: side, height: side });
  PNG.bitblt(whole, part, (whole.width - side) / 2, (whole.height - side) / 2, side, side, 0, 0);
  return PNG.sync.write(part);
}

/** The sample portrait as a mask of 2 mm, sliced as for a usual printer. */
async function slices() {
  const body = path.join(DRAWN, "mask.stl");
  await promisify(execFile)(program(), ["mesh", SAMPLE, "-o", body, "--solid", "thickness:2"]);
  return slicesOf(body);
}

/** @template T @param {T[]} cells @param {number} many */
function inRows(cells, many) {
  const rows = Array.from({ length: Math.ceil(cells.length / many) }, (_, row) => cells.slice(row * many, (row + 1) * many));
  return rows.map((row) => [...row, ...Array.from({ length: many - row.length }, () => undefined)]);
}
