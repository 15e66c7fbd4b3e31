import { test } from "@playwright/test";
import { monkeyTest } from "./monkey.mjs";

/** `cargo xtask torture` goes on for longer. */
const AMOUNT = { runs: 2, actions: 100, seed: 1 };

test("a monkey does anything at random, and nothing breaks", async () => {
  // Shrinking takes longer than other tests.
  test.setTimeout(600_000);
  await monkeyTest(AMOUNT);
});
