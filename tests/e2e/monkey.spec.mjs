import { test } from "@playwright/test";
import { monkeyTest } from "./monkey.mjs";

test("a monkey does anything at random, and nothing breaks", async () => {
  // Shrinking takes longer than other tests. `cargo xtask fuzz` goes on for longer, too.
  test.setTimeout(600_000);
  await monkeyTest({ runs: 2, actions: 100, seed: 1 });
});
