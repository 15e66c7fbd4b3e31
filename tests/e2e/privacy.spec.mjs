import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";

test("after loading, the page sends no requests", { tag: "@usual" }, async ({ visitor }) => {
  await visitor.untilLoaded();
  assert.match(await visitor.page.innerText("#privacy"), /Nothing uploaded.*your photo stays on this device/s);
  visitor.requests.length = 0;
  await visitor.page.click("#welcome [data-action='sample']");
  await visitor.untilFace();
  await visitor.move("bottom of the chin", "y", -6);
  await visitor.download("download-glb");
  await visitor.dropSample();
  const left = visitor.requests.filter((url) => !url.startsWith("blob:") && !url.startsWith("data:"));
  assert.deepEqual(left, []);
  assert.equal(await visitor.page.getAttribute("#privacy-count", "data-requests"), "0");
  assert.match(await visitor.page.innerText("#privacy"), /Nothing uploaded/);
});

test("the policy blocks other hosts, inline scripts and eval", { tag: "@usual" }, async ({ visitor }) => {
  const { violations, ...rest } = await visitor.page.evaluate(async () => {
    const violations = [];
    document.addEventListener("securitypolicyviolation", (event) => violations.push(event.effectiveDirective));
    const elsewhere = await fetch("https://example.com/").then(() => "answered", () => "refused");
    const script = document.createElement("script");
    script.append("window.ranInline = true");
    document.body.append(script);
    const picture = new Image();
    picture.src = "https://example.com/pixel.png";
    await new Promise((resolve) => (picture.onerror = resolve));
    let evaluated = "refused";
    try {
      evaluated = new Function("return 'ran'")();
    } catch {}
    return { elsewhere, ranInline: "ranInline" in window, evaluated, violations };
  });
  assert.deepEqual(rest, { elsewhere: "refused", ranInline: false, evaluated: "refused" });
  assert.ok(violations.includes("connect-src") && violations.includes("img-src"));
  // Violations are reported asynchronously; unexpected ones fail the test.
  await visitor.frames(2);
  assert.ok(visitor.errors.splice(0).length > 0);
});

test("only the page's Trusted Types policy can create markup and script URLs", { tag: "@usual" }, async ({ visitor }) => {
  await visitor.untilLoaded();
  const refused = await visitor.page.evaluate(() => {
    const text = (act) => {
      try {
        return String(act());
      } catch (error) {
        return error.name;
      }
    };
    const { src } = /** @type {HTMLScriptElement} */ (document.querySelector("script[type='module']"));
    return {
      markup: text(() => (document.createElement("p").innerHTML = "<b>bold</b>")),
      worker: text(() => new Worker(src.replace("page.js", "vision-worker.js"))),
      script: text(() => (document.createElement("script").src = src)),
      policy: text(() => window.trustedTypes.createPolicy("another", {})),
      same: text(() => window.trustedTypes.createPolicy("rosto", {})),
    };
  });
  assert.deepEqual(Object.entries(refused).filter(([, what]) => what !== "TypeError"), []);
  // Violations are reported asynchronously.
  await visitor.frames(2);
  assert.ok(visitor.errors.splice(0).length > 0);
});
