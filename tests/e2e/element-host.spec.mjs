// <rosto-studio> on pages that restrict or hide it.
import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./element-visitor.mjs";
import { difference } from "./pixels.mjs";

const POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; img-src 'self'";
const TRUSTED = `${POLICY}; require-trusted-types-for 'script'; trusted-types rosto`;

const BODY = `<rosto-studio controls><img src="portrait.png" alt=""></rosto-studio>`;

test("the element needs no other Trusted Types policy than its own, also if the host sends one with each file", async ({ openElement }) => {
  const visitor = await openElement({ body: BODY, policy: TRUSTED, headers: { "content-security-policy": TRUSTED } });
  await visitor.until("rosto-face");
  await visitor.act((face) => face.setSlider("nose-width", 2));
  assert.ok((await visitor.file()).length > 10_000);
});

/** Restrictions of the host page, and the errors that the element reports. */
const RESTRICTIONS = [
  {
    code: "no-policy",
    when: "Trusted Types without the policy rosto",
    policy: TRUSTED.replace("trusted-types rosto", "trusted-types default other"),
    hint: /trusted-types/,
    notices: { en: /doesn’t allow the 3D view.*“rosto”/, pt: /não permite iniciar.*“rosto”/ },
  },
  {
    code: "sandboxed",
    when: "a frame in a sandbox",
    policy: "sandbox allow-scripts",
    headers: { "access-control-allow-origin": "*" },
    hint: /allow-same-origin/,
    notices: { en: /frame can’t show.*allow-same-origin/, pt: /quadro não pode mostrar.*allow-same-origin/ },
  },
];

for (const { code, when, hint, notices, ...host } of RESTRICTIONS) {
  test(`in ${when}, the element shows the photo and reports ${code} at once`, async ({ openElement }) => {
    for (const [language, notice] of Object.entries(notices)) {
      const visitor = await openElement({ ...host, body: BODY.replace("controls", `lang="${language}"`) });
      const error = await visitor.until("rosto-error");
      assert.equal(error.code, code);
      assert.match(error.hint, hint);
      assert.match(await visitor.notice(), notice);
      assert.ok(await visitor.page.isVisible("rosto-studio img"));
      for (const call of [(face) => face.getGlb(), (face) => face.open("portrait.png"), (face) => face.setSlider("nose-width", 1)]) {
        const thrown = await visitor.thrown(call);
        assert.deepEqual([thrown.name, thrown.code], ["RostoError", code]);
      }
      assert.deepEqual([visitor.page.workers().length, await visitor.page.evaluate("gpus.length")], [0, 0]);
      // The refused policy is a violation.
      visitor.visitor.errors.length = 0;
    }
  });
}

test("the element reports files from another website", async ({ openElement }) => {
  const visitor = await openElement({ body: `<rosto-studio base="https://elsewhere.invalid/rosto"></rosto-studio>` });
  assert.equal((await visitor.until("rosto-error")).code, "other-origin");
  assert.match(await visitor.notice(), /another website/);
  const wrong = await openElement({ body: `<rosto-studio base="http://"></rosto-studio>` });
  assert.equal((await wrong.until("rosto-error")).code, "bad-choice");
});

const SIZE = "width: 400px; height: 300px";

for (const [how, style, parent = ""] of [["with display: none", "display: none"], ["without width", "width: 0"], ["in a hidden parent", SIZE, "hidden"]]) {
  test(`an element ${how} starts when it is shown, as one shown at first does`, { tag: "@eyes" }, async ({ openElement }) => {
    const body = `<div ${parent}><rosto-studio controls src="portrait.png" style="${style}"></rosto-studio></div>`;
    const visitor = await openElement({ body });
    await visitor.visitor.frames(5);
    await visitor.page.waitForTimeout(1000);
    assert.deepEqual([await visitor.names(), await visitor.page.evaluate("gpus.length")], [[], 0]);
    const early = await visitor.thrown((face) => face.setSlider("nose-width", 1));
    assert.equal(early.code, "not-ready");
    assert.match(early.message, /hidden/);
    await show(visitor);
    await visitor.until("rosto-face");
    assert.deepEqual(await visitor.names(), ["rosto-ready", "rosto-face"]);

    const shown = await openElement({ body: body.replace(style, SIZE).replace(`<div ${parent}>`, "<div>") });
    await shown.until("rosto-face");
    const differing = async () => difference(await visitor.view(), await shown.view());
    // The texture arrives later.
    await expect.poll(differing, "it shows another view").toBeLessThan(0.001);

    // Hiding it later changes nothing.
    await visitor.act((face) => (face.hidden = true));
    await visitor.visitor.frames(5);
    await visitor.act((face) => (face.hidden = false));
    await expect.poll(differing, "it shows another view after it was hidden").toBeLessThan(0.001);
    assert.equal(await visitor.last("rosto-error"), undefined);
  });
}

test("an element removed while hidden rejects what waits for it", async ({ openElement }) => {
  const visitor = await openElement({ body: "<rosto-studio hidden></rosto-studio>" });
  const code = visitor.act((face) => face.getGlb().catch((error) => error.code));
  await visitor.act((face) => face.remove());
  assert.equal(await code, "closed");
});

/** @param {{ act: (action: (face: any) => unknown) => Promise<unknown> }} visitor */
function show(visitor) {
  return visitor.act((face) => {
    face.parentElement.hidden = false;
    Object.assign(face.style, { display: "", width: "400px", height: "300px" });
  });
}
