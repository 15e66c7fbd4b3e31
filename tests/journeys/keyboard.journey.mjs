import assert from "node:assert/strict";
import { journey } from "./journey.mjs";
import { difference } from "./pixels.mjs";

journey("everything from photo to file by keyboard alone", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.untilLoaded();

  await page.focus("#drop-zone");
  await page.keyboard.press("Enter");
  await visitor.untilFace();

  await page.focus("#landmark-search");
  await page.keyboard.type("nose tip");
  await page.keyboard.press("Enter");
  assert.match(await page.innerText("#said"), /nose tip · \d+ selected/i);
  const before = await visitor.meshJson("mm");

  await page.focus("#landmark-sliders [data-axis='z'] input[type=range]");
  for (let press = 0; press < 10; press++) await page.keyboard.press("ArrowRight");
  assert.equal(await page.inputValue("#landmark-sliders [data-axis='z'] input[type=number]"), "1");
  await page.waitForFunction(() => document.getElementById("said")?.textContent?.includes("z 1.0 mill"));
  assert.notDeepEqual(await visitor.meshJson("mm"), before);

  await page.keyboard.press("Control+z");
  assert.deepEqual(await visitor.meshJson("mm"), before);
  await page.keyboard.press("Control+Shift+z");
  assert.notDeepEqual(await visitor.meshJson("mm"), before);

  await page.focus("#landmark-sliders [data-axis='y'] input[type=number]");
  await page.keyboard.type("3");
  await page.keyboard.press("Enter");
  assert.equal((await visitor.history()).length, 2);
  await page.keyboard.press("Control+z");
  const undone = await page.textContent("#said");
  await page.keyboard.press("Control+z");
  assert.equal(undone?.trim(), "Undone");
  assert.notEqual(await page.textContent("#said"), undone, "undone twice, said once");
  await page.keyboard.press("Control+y");
  assert.equal((await visitor.history()).length, 1);
  assert.equal(await page.inputValue("#landmark-sliders [data-axis='y'] input[type=number]"), "0");
});

journey("the first stop of the keyboard leads past everything to the landmarks", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.dropSample();
  await page.keyboard.press("Tab");
  assert.ok(await page.evaluate(() => document.activeElement?.matches(".skip-link")), "the first stop is another");
  await page.keyboard.press("Enter");
  await page.keyboard.type("nose tip");
  await page.keyboard.press("Enter");
  assert.equal(await visitor.landmark(), 1);
});

journey("a question mark lists the keys, but not where text is typed", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.dropSample();
  await page.focus("#landmark-search");
  await page.keyboard.press("?");
  assert.equal(await page.inputValue("#landmark-search"), "?");
  assert.ok(await page.isHidden("#keys"));
  await page.focus("#viewport");
  await page.keyboard.press("?");
  assert.match(await page.innerText("#keys"), /Ctrl Z/);
  await page.keyboard.press("Escape");
  assert.ok(await page.isHidden("#keys"));
  await page.click("[data-action='open-keys']");
  assert.ok(await page.isVisible("#keys"));
});

journey("the camera follows the keys while the view has the focus", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.dropSample();
  await page.focus("#viewport");
  const start = await visitor.view();
  for (const key of ["ArrowLeft", "Control+Shift+ArrowUp", "Alt+ArrowUp", "l", "t", "w"]) {
    await page.keyboard.press("Space");
    await page.keyboard.press(key);
    assert.ok(difference(start, await visitor.view()) > 0.01, `${key} did nothing`);
  }
  await page.keyboard.press("w");
  await page.keyboard.press("f");
  assert.ok(difference(start, await visitor.view()) < 0.001, "F did not show the front");
  await page.keyboard.press("Alt+ArrowDown");
  await page.keyboard.press("Space");
  assert.ok(difference(start, await visitor.view()) < 0.001, "Space did not reset the view");
}, { needs: "eyes" });

journey("Tab goes through everything, and shows where it is", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", 3);
  await page.focus(".skip-link");
  const seen = new Set();
  for (;;) {
    await page.keyboard.press("Tab");
    const stop = await page.evaluate(focused);
    if (stop.isKnown) break;
    seen.add(stop.name);
    assert.ok(stop.outlined, `${stop.name} does not show that it has the focus`);
    assert.ok(stop.inSight, `${stop.name} is out of sight`);
  }
  const expected = ["viewport", "undo", "compare", "language", "theme", "drop-zone", "selection", "landmark-search", "mirror"];
  for (const name of [...expected, "Nose width, in millimetres", "symmetrise", "shading", "light-colour", "reset-selection", "download-glb", "open-keys", "open-credits"]) {
    assert.ok(seen.has(name), `Tab does not reach ${name}, only ${[...seen].join(", ")}`);
  }
});

/**
 * What has the focus: a name for it, whether it had the focus before, whether an outline shows it, and whether it is in
 * the window. Runs in the page.
 */
function focused() {
  const element = document.activeElement;
  const name = element.id || element.dataset.action || element.name || element.getAttribute("aria-label") || element.innerText;
  const isKnown = element === document.body || element.hasAttribute("data-was-focused");
  element.setAttribute("data-was-focused", "");
  // The radio buttons of a segmented choice are their labels.
  const shows = element.type === "radio" ? element.nextElementSibling : element;
  const { outlineStyle, outlineWidth } = getComputedStyle(shows);
  const box = shows.getBoundingClientRect();
  const middle = { x: box.left + box.width / 2, y: box.top + box.height / 2 };
  const inSight = middle.x > 0 && middle.x < innerWidth && middle.y > 0 && middle.y < innerHeight;
  return { name, isKnown, outlined: outlineStyle !== "none" && Number.parseFloat(outlineWidth) >= 2, inSight };
}
