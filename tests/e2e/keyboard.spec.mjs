import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { difference } from "./pixels.mjs";

test.use({ visit: { expert: true } });

test("photo, edit, undo and redo work by keyboard alone", { tag: "@usual" }, async ({ visitor, page }) => {
  await visitor.untilLoaded();

  await page.focus("#welcome [data-action='choose']");
  await page.keyboard.press("Enter");
  await visitor.untilFace();

  await visitor.selectBy("landmark");
  await page.focus("#landmark-search");
  await page.keyboard.type("nose tip");
  await page.keyboard.press("Enter");
  assert.match(await page.innerText("#announcement"), /nose tip · \d+ selected/i);
  const before = await visitor.meshJson("mm");

  await visitor.reveal("#landmark-offset");
  await page.focus("#landmark-offset [data-axis='z'] input[type=range]");
  for (let press = 0; press < 10; press++) await page.keyboard.press("ArrowRight");
  assert.equal(await page.inputValue("#landmark-offset [data-axis='z'] .number-field"), "1");
  await page.waitForFunction(() => document.getElementById("announcement")?.textContent?.includes("z 1.0 mill"));
  assert.notDeepEqual(await visitor.meshJson("mm"), before);

  await page.keyboard.press("Control+z");
  assert.deepEqual(await visitor.meshJson("mm"), before);
  await page.keyboard.press("Control+Shift+z");
  assert.notDeepEqual(await visitor.meshJson("mm"), before);

  await visitor.reveal("#landmark-offset");
  await page.focus("#landmark-offset [data-axis='y'] .number-field");
  await page.keyboard.type("3");
  await page.keyboard.press("Enter");
  assert.equal((await visitor.history()).length, 2);
  await page.keyboard.press("Control+z");
  const undone = await page.textContent("#announcement");
  await page.keyboard.press("Control+z");
  assert.equal(undone?.trim(), "Undone");
  assert.notEqual(await page.textContent("#announcement"), undone, "a repeated undo is not announced");
  await page.keyboard.press("Control+y");
  assert.equal((await visitor.history()).length, 1);
  assert.equal(await page.inputValue("#landmark-offset [data-axis='y'] .number-field"), "0");
  await page.keyboard.type("2?");
  assert.ok(await page.isHidden("#keys"), "a key that was typed into a field is a shortcut");
});

test("the skip link leads to moving by hand on each tab", async ({ editor, page }) => {
  await page.keyboard.press("Tab");
  assert.ok(await page.evaluate(() => document.activeElement?.matches(".skip-link")), "the skip link is not the first tab stop");
  await editor.selectBy("landmark");
  for (const [name, landmark] of [["nose tip", 1], ["bottom of the chin", 152]]) {
    await page.focus(".skip-link");
    await page.keyboard.press("Enter");
    assert.equal(await page.evaluate(() => document.activeElement.value), "landmark");
    await page.keyboard.press("Tab");
    await page.keyboard.type(name);
    await page.keyboard.press("Enter");
    assert.equal(await editor.selectedLandmark(), landmark);
    await page.click("#tab-view");
  }
});

test("keys move the camera while the view has the focus", { tag: "@eyes" }, async ({ editor, page }) => {
  await page.focus("#viewport");
  const start = await editor.view();
  for (const key of ["ArrowLeft", "Control+Shift+ArrowUp", "Alt+ArrowUp", "l", "t", "w"]) {
    await page.keyboard.press("Space");
    await page.keyboard.press(key);
    assert.ok(difference(start, await editor.view()) > 0.01, `${key} did nothing`);
  }
  await page.keyboard.press("w");
  await page.keyboard.press("f");
  // Unlike the start, the front view is not from where the photo was taken.
  const front = await editor.view();
  await page.keyboard.press("l");
  await page.keyboard.press("f");
  assert.ok(difference(front, await editor.view()) < 0.001, "F did not show the front");
  await page.keyboard.press("Alt+ArrowDown");
  await page.keyboard.press("Space");
  assert.ok(difference(start, await editor.view()) < 0.001, "Space did not reset the view");
});

/** Tab stops of each tab of the panel. */
const STOPS = {
  shape: ["section-photo", "photo-change", "shape", "Nose width, in millimetres", "selection", "landmark-search", "landmark-more", "preset", "look-smile", "section-history", "operator", "anchors-shown", "run-paper"],
  view: ["shading", "view-wireframe", "density", "view-left"],
  export: ["base-colour", "export-density", "check-glb", "download-json"],
};
const EVERYWHERE = ["viewport", "undo", "language", "theme", "open-keys", "open-credits", "save-main", "save-more"];

for (const [tab, stops] of Object.entries(STOPS)) {
  test(`Tab reaches each control on the ${tab} tab, with a complete focus ring`, async ({ editor, page }) => {
    await editor.move("nose tip", "z", 3);
    await editor.unfold("section-paper");
    await page.click(`#tab-${tab}`);
    await page.focus(".skip-link");
    const seen = new Set();
    for (;;) {
      await page.keyboard.press("Tab");
      const stop = await page.evaluate(focused);
      if (stop.isKnown) break;
      seen.add(stop.name);
      assert.deepEqual(stop.faults, [], stop.name);
    }
    for (const name of [...EVERYWHERE, `tab-${tab}`, ...stops]) assert.ok(seen.has(name), `Tab does not reach ${name}, only ${[...seen].join(", ")}`);
  });
}

test("a question mark opens the list of keys, except while typing; dialogs show complete focus rings", async ({ open }) => {
  const visitor = await open({ viewport: { width: 720, height: 450 } });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.selectBy("landmark");
  await page.focus("#landmark-search");
  await page.keyboard.press("?");
  assert.equal(await page.inputValue("#landmark-search"), "?");
  assert.ok(await page.isHidden("#keys"));
  await page.focus("#viewport");
  await page.keyboard.press("?");
  assert.match(await page.innerText("#keys"), /Ctrl Z/);
  await page.keyboard.press("Escape");
  assert.ok(await page.isHidden("#keys"));
  for (const dialog of ["keys", "credits"]) {
    await page.evaluate((dialog) => document.querySelector(`[data-action='open-${dialog}']`).click(), dialog);
    await page.keyboard.press("Tab");
    assert.deepEqual(await page.evaluate(focused), { name: `close-${dialog}`, isKnown: false, faults: [] });
    await page.keyboard.press("Enter");
    assert.ok(await page.isHidden(`#${dialog}`));
  }
});

/** The focused element, whether it was focused before, and problems of its focus ring. Runs in the page. */
function focused() {
  const element = document.activeElement;
  const fold = element.matches("summary") ? element.parentElement.id : "";
  const name = element.id || fold || element.dataset.action || element.name || element.getAttribute("aria-label") || element.innerText;
  const isKnown = element === document.body || element.hasAttribute("data-was-focused");
  element.setAttribute("data-was-focused", "");
  // A note shows the focus of the whole stage.
  if (element.id === "viewport") return { name, isKnown, faults: document.querySelector(".focus-note").checkVisibility() ? [] : ["it has no note"] };
  // Radio buttons of a segmented control are represented by their labels.
  const shows = element.type === "radio" ? element.nextElementSibling : element;
  const { outlineStyle, outlineWidth, outlineOffset } = getComputedStyle(shows);
  const { left, right, top, bottom } = shows.getBoundingClientRect();
  const [x, y] = [(left + right) / 2, (top + bottom) / 2];
  const isOutlined = outlineStyle !== "none" && Number.parseFloat(outlineWidth) >= 2;
  const isInSight = x > 0 && x < innerWidth && y > 0 && y < innerHeight;
  const out = Math.max(0, Number.parseFloat(outlineWidth) + Number.parseFloat(outlineOffset));
  const ring = { left: left - out, right: right + out, top: top - out, bottom: bottom + out };
  const faults = [!isOutlined && "it has no outline", !isInSight && "it is out of sight", cutter()];
  return { name, isKnown, faults: faults.filter(Boolean) };

  /** Element that clips the ring or covers the centre of a side. */
  function cutter() {
    for (let up = shows.parentElement; up; up = up.parentElement) {
      if (up !== document.body && getComputedStyle(up).overflow === "visible") continue;
      const frame = up.getBoundingClientRect();
      const isCut = ring.left < frame.left - 0.5 || ring.right > frame.right + 0.5 || ring.top < frame.top - 0.5 || ring.bottom > frame.bottom + 0.5;
      if (isCut) return `its ring is cut by ${up.id || up.className || up.tagName}`;
    }
    const sides = [[ring.left + 1, y], [ring.right - 1, y], [x, ring.top + 1], [x, ring.bottom - 1]];
    const over = sides.map(([x, y]) => document.elementFromPoint(x, y)).find((hit) => hit && liesOver(hit));
    return over && `its ring is covered by ${over.id || over.className || over.tagName}`;
  }

  /** Other elements cover the outline only if they are positioned. */
  function liesOver(hit) {
    const own = shows.closest("label") ?? shows;
    for (let up = hit; up && !up.contains(own) && !own.contains(up); up = up.parentElement) {
      if (getComputedStyle(up).position !== "static") return true;
    }
    return false;
  }
}
