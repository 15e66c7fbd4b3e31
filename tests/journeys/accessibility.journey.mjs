import assert from "node:assert/strict";
import { AUDIENCES, audits } from "./accessibility.mjs";
import { test } from "./fixtures.mjs";

/** `npm run accessibility` checks the others. */
const WALKED = ["phone, light"];

for (const { name, options } of AUDIENCES.filter(({ name }) => WALKED.includes(name))) {
  test(`axe-core finds nothing to object to: ${name}`, async ({ open }) => {
    let passed = 0;
    for await (const audit of audits(await open(options))) {
      assert.deepEqual(audit.violations, [], audit.state);
      passed += audit.passed;
    }
    assert.ok(passed > 100, `axe-core looked at next to nothing: ${passed} rules passed`);
  });
}
