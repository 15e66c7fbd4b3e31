import { test } from "@playwright/test";
import { monkeyTest } from "./monkey.mjs";

test("random actions of a monkey test break nothing", async () => {
  // Shrinking takes longer than other tests, and `cargo xtask fuzz` runs longer, too.
  test.setTimeout(600_000);
  await monkeyTest({ runs: 2, actions: 100, seed: 1 });
});
