import assert from "node:assert/strict";
import { PNG } from "pngjs";
import { journey } from "./journey.mjs";
import { difference } from "./pixels.mjs";

journey("hints come one after the other, each once, and go with the next press", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.dropSample();
  await page.waitForFunction(() => document.getElementById("hint").textContent === "Drag the nose");
  assert.ok(await page.isVisible("#hint"));
  await page.waitForFunction(() => document.getElementById("hint").textContent.startsWith("Drag beside the face"));
  const beside = await visitor.besideTheFace();
  await page.mouse.click(beside.x, beside.y);
  assert.ok(await page.isHidden("#hint"));
  await visitor.dropSample();
  assert.ok(await page.isHidden("#hint"), "a hint was given twice");
});

journey("a hint for fingers speaks of fingers", async (open) => {
  const visitor = await open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await visitor.dropSample();
  await visitor.page.waitForFunction(() => document.getElementById("hint").textContent.includes("finger on the nose"));
});

for (const [drawn, needs] of /** @type {const} */ ([["WebGPU", "eyes"], ["WebGL2", "webgl"]])) {
  journey(
    `before a photo nothing but the wireframe lies over the page's ground: ${drawn}`,
    async (open) => {
      const visitor = await open({ colorScheme: "light", reducedMotion: "reduce" });
      await visitor.untilLoaded();
      const { data, width, height } = await visitor.view();
      const nearGround = (/** @type {number} */ at) => [0xf5, 0xf3, 0xef].every((ground, channel) => Math.abs(data[at + channel] - ground) < 24);
      const isGround = Array.from({ length: width * height }, (_, pixel) => nearGround(4 * pixel));
      assert.ok(isGround[0] && isGround[width - 1], `the corner is ${data.subarray(0, 4)}`);
      const share = isGround.filter(Boolean).length / isGround.length;
      assert.ok(share > 0.7 && share < 0.999, `${share} of the view is ground`);
    },
    { needs },
  );
}

for (const [reducedMotion, moves] of /** @type {const} */ ([["no-preference", true], ["reduce", false]])) {
  const verb = moves ? "turns slowly" : "keeps still";
  journey(`with ${reducedMotion} for motion, the empty face ${verb}`, async (open) => {
    const visitor = await open({ reducedMotion });
    await visitor.untilLoaded();
    const first = await shot(visitor);
    await visitor.frames(30);
    assert.equal(difference(first, await shot(visitor)) > 0, moves);
    const longest_ms = await visitor.page.evaluate(longestTransition);
    assert.ok(moves ? longest_ms >= 100 : longest_ms === 0, `a transition of ${longest_ms} ms`);
  }, { needs: "eyes" });
}

/** @param {import("./visitor.mjs").Visitor} visitor */
async function shot(visitor) {
  return PNG.sync.read(await visitor.page.locator("#viewport").screenshot());
}

/** In ms. Runs in the page. */
function longestTransition() {
  const durations = [...document.querySelectorAll("*")].flatMap((element) =>
    getComputedStyle(element).transitionDuration.split(",").map((duration) => 1000 * Number.parseFloat(duration)),
  );
  return Math.max(...durations);
}
