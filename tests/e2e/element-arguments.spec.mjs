// Arguments of <rosto-studio> are checked before they reach its modules.
import assert from "node:assert/strict";
import { test } from "./element-visitor.mjs";

/** Calls of the element, and the codes and messages of their refusals. @type {[(face: any) => unknown, code: string, message: RegExp][]} */
const REFUSALS = [
  [(face) => face.express(3, 0.5), "bad-choice", /^expression is 3; use one of .*jawOpen/],
  [(face) => face.express("jawOpen", "0.5"), "bad-number", /^to is "0.5"; use a finite number$/],
  [(face) => face.setSlider("ears", 1), "bad-choice", /^slider is "ears"; use one of .*nose-width/],
  [(face) => face.getFile(7), "bad-choice", /^format is 7; use one of glb, /],
  [(face) => face.getFile("stl", { solid: 3 }), "bad-choice", /^choices.solid is 3; use a string$/],
  [(face) => face.moveLandmark(undefined, [0, 0, 1]), "bad-number", /^landmark is undefined; use an integer from 0, below 468$/],
  [(face) => face.moveLandmark(1, "123"), "bad-number", /^offset_mm is "123"; use \[x, y, z\]$/],
  [(face) => face.moveLandmark(1, [0, 1]), "bad-number", /^length of offset_mm is 2; use 3$/],
  [(face) => face.moveLandmark(1, [0, 0, Number.NaN]), "bad-number", /^offset_mm\.2 is NaN; use a finite number$/],
  [(face) => face.openFace(1), "bad-number", /^index is 1; use an integer from 0, below 1$/],
  [(face) => face.open(7), "bad-choice", /^photo is 7; use a Blob or an address$/],
  [(face) => face.apply({ zoom: "2" }), "bad-number", /expected f64/],
  [(face) => face.apply({ zoom: Infinity }), "bad-number", /^intent.zoom is Infinity; use a finite number$/],
  [(face) => (face.src = 7), "bad-choice", /^src is 7; use a string$/],
];

test("the element refuses arguments of a wrong kind with a code and the allowed values, and goes on without a restart", async ({ openElement }) => {
  const visitor = await openElement({ body: `<rosto-studio src="portrait.png" density="0"></rosto-studio><rosto-studio></rosto-studio>` });
  await visitor.until("rosto-ready", 2);
  await visitor.until("rosto-face");
  await visitor.act((face) => face.setSlider("nose-width", 1));

  const { outcomes, edits } = await visitor.act(refusals);
  assert.deepEqual(outcomes.filter(({ isRefused }) => !isRefused), []);
  assert.ok(outcomes.length > 300, `${outcomes.length} calls`);
  assert.equal(edits, 1, "a refused call has edited the face");

  for (const [call, code, message] of REFUSALS) {
    const thrown = await visitor.thrown(call);
    assert.equal(thrown.code, code, String(call));
    assert.match(thrown.message, message);
  }

  await visitor.act((face) => face.express("jawOpen", 0.5));
  await visitor.act((face) => face.moveLandmark(1, [0, 0, 6]));
  assert.equal((await visitor.state()).edits, 3);
  assert.ok((await visitor.file("stl")).length > 10_000);
  assert.equal(visitor.page.workers().length, 1);
  assert.equal(await visitor.page.evaluate("hooked.calls.length"), 1, "the module has restarted");
  assert.ok(!(await visitor.page.evaluate("elementEvents")).some(({ detail }) => detail?.code === "restarted"));
});

/** Runs in the page: calls each member of the element with values of wrong kinds. @param {any} face */
async function refusals(face) {
  const cyclic = [];
  cyclic.push(cyclic);
  const { proxy: revoked, revoke } = Proxy.revocable({}, {});
  revoke();
  const fail = () => {
    throw new Error("of the host");
  };
  const reenter = () => face.apply({ zoom: 1 });
  const wrong = {
    ...{ undefined: undefined, null: null, NaN: Number.NaN, Infinity: Infinity, true: true, empty: "", "123": "123" },
    ...{ "-1": -1, "1.5": 1.5, "1e9": 1e9, array: [], object: {}, symbol: Symbol("wrong"), bigint: 1n, function: () => {}, revoked },
    ...{ proxy: new Proxy({}, { get: fail, ownKeys: fail, getPrototypeOf: fail, has: fail }), cyclic, sparse: new Array(1e9) },
    ...{ getter: Object.defineProperty({}, "zoom", { get: fail, enumerable: true }), date: new Date(), null0: Object.create(null) },
    ...{ reentrant: Object.defineProperty({}, "zoom", { get: reenter, enumerable: true }), map: new Map([["zoom", 2]]), element: face },
  };
  const numbers = ["-1", "1.5"];
  const hostile = ["proxy", "revoked", "getter"];
  const expected = ["bad-choice", "bad-number", "bad-vertex", "not-a-picture", "unreadable-file", "unsupported-format"];
  /** A call for each value, and the values that are right. */
  const calls = {
    "open(x)": [(x) => face.open(x)],
    "openFace(x)": [(x) => face.openFace(x)],
    "moveLandmark(x, …)": [(x) => face.moveLandmark(x, [0, 0, 1])],
    "moveLandmark(1, x)": [(x) => face.moveLandmark(1, x)],
    "moveLandmark(1, [0, x, 0])": [(x) => face.moveLandmark(1, [0, x, 0]), numbers],
    "setSlider(x, 1)": [(x) => face.setSlider(x, 1)],
    "setSlider(…, x)": [(x) => face.setSlider("nose-width", x), numbers],
    "express(x, 0.5)": [(x) => face.express(x, 0.5)],
    "express(…, x)": [(x) => face.express("jawOpen", x), numbers],
    "apply(x)": [(x) => face.apply(x)],
    "apply({ set: [x, 1] })": [(x) => face.apply({ set: [x, 1] })],
    "apply({ set: [slider, x] })": [(x) => face.apply({ set: ["slider.nose-width", x] }), numbers],
    "apply({ slide: x })": [(x) => face.apply({ slide: x })],
    "apply({ zoom: x })": [(x) => face.apply({ zoom: x }), [...numbers, "1e9"]],
    "apply({ shading: x })": [(x) => face.apply({ shading: x })],
    "apply({ resize: x })": [(x) => face.apply({ resize: x })],
    "getGlb(x)": [(x) => face.getGlb(x), ["undefined", "object", "null0"]],
    "getGlb({ eyes: x })": [(x) => face.getGlb({ eyes: x })],
    "getFile(x)": [(x) => face.getFile(x)],
    "getFile(obj, x)": [(x) => face.getFile("obj", x), ["undefined", "object", "null0"]],
    "src = x": [(x) => (face.src = x), ["empty", "123"]],
  };
  const outcomes = [];
  for (const [call, [act, right = []]] of Object.entries(calls)) {
    for (const [value, x] of Object.entries(wrong)) {
      if (right.includes(value)) continue;
      const error = await Promise.try(act, x).then(() => undefined, (error) => error);
      // An error of the host's own object keeps its message.
      const codes = hostile.includes(value) ? [...expected, "other"] : expected;
      const isRefused = error instanceof Error && error.name === "RostoError" && codes.includes(error.code);
      outcomes.push({ call, value, isRefused, error: `${error?.code}: ${error}` });
    }
  }
  return { outcomes, edits: face.state.edits };
}
