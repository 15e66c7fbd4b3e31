import assert from "node:assert/strict";
import { paperByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** Table 1 of the paper, in ms. */
const TABLE_1 = [[218, 214], [3, 7], [399, 362], [364, 389], [366, 401], [393, 363], [387, 374], [384, 584]];

test("the paper's experiment runs next to Table 1, gives the command line's results and leaves the work unchanged", async ({ visitor, page }) => {
  // The table includes the duration of face detection.
  await visitor.dropSample();
  await visitor.setSlider("nose-width", 2);
  const before = await visitor.meshJson("mm");
  await visitor.unfold("section-paper");
  await page.click("[data-action='run-paper']");
  // The page responds meanwhile.
  await page.waitForSelector("#paper-progress:not([hidden])");
  await visitor.setSlider("jaw-width", 1);
  await page.click("#toolbar [data-action='undo']");
  await page.waitForSelector("#paper-results:not([hidden])", { timeout: 150_000 });

  const table = await cells(page, "#paper-table");
  assert.deepEqual(table.map((row) => row.slice(0, 2)), TABLE_1);
  for (const [row, [, , here_ms]] of table.entries()) assert.ok(here_ms > 0 && here_ms < 60_000, `row ${row}: ${here_ms} ms`);
  assert.equal(await page.locator("#paper-plot circle").count(), 30);
  const methods = await paperByCommandLine(SAMPLE, ["--runs", "5", "--seed", "0"]);
  assert.equal(methods.length, 12);
  for (const [measure, within] of [["bent", 2e-3], ["stretch", 2e-2], ["flipped", 0], ["smooth", 0]]) {
    await page.selectOption("#paper-measure", measure);
    const here = (await cells(page, "#paper-methods")).flat();
    for (const [place, method] of methods.entries()) {
      const apart = Math.abs(here[place] - method[measure]);
      assert.ok(apart <= within, `${method.operator} ${method.hold}: ${measure} ${here[place]}, not ${method[measure]}`);
    }
  }
  assert.deepEqual(await visitor.history(), ["Nose width"]);
  assert.deepEqual(await visitor.meshJson("mm"), before);
  await page.selectOption("#language", "pt");
  assert.match(await page.innerText("#paper-table tr:nth-child(3) th"), /grau 3/);
});

/** Numbers in a table's rows. */
async function cells(page, table) {
  const rows = await page.locator(`${table} tr`).all();
  return Promise.all(rows.map(async (row) => (await row.locator("td").allInnerTexts()).map((text) => Number(text.replaceAll(",", "")))));
}
