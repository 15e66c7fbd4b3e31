import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";

/** Maximum duration of the toast. */
const TOAST_MS = 6000;

for (const [width, height] of [[1280, 720], [390, 844], [844, 390]]) {
  test(`at ${width}×${height} a download shows a short toast, announced once, that covers no tool`, async ({ open }) => {
    const visitor = await open({ viewport: { width, height } });
    const { page } = visitor;
    await visitor.openFace();
    assert.ok(await page.isHidden("#toast"));
    await page.evaluate(recordAnnouncements);
    await visitor.download("save-project");
    assert.ok(await page.isVisible("#toast"));
    assert.equal(await page.innerText("#toast"), "portrait.rosto saved to your downloads");
    const [toast, toolbar, stage] = await Promise.all(["toast", "toolbar", "stage"].map((id) => page.locator(`#${id}`).boundingBox()));
    assert.ok(toast.y + toast.height <= toolbar.y && toast.x >= stage.x && toast.x + toast.width <= stage.x + stage.width);
    // Screen readers read the live region instead.
    assert.equal(await page.getAttribute("#toast", "aria-hidden"), "true");
    await page.waitForSelector("#toast", { state: "hidden", timeout: TOAST_MS });
    assert.deepEqual(await page.evaluate("announcements"), ["portrait.rosto saved to your downloads"]);
  });
}

/** Runs in the page: records announcements of live regions. */
function recordAnnouncements() {
  /** @type {string[]} */
  const announcements = [];
  globalThis["announcements"] = announcements;
  for (const region of document.querySelectorAll("[role=status], [role=alert], [aria-live]")) {
    new MutationObserver(() => region.textContent.trim() && announcements.push(region.textContent.trim())).observe(region, { childList: true });
  }
}
