import { availableParallelism } from "node:os";
import { defineConfig } from "@playwright/test";

const SPECS = "*.spec.mjs";

export default defineConfig({
  testDir: "tests/e2e",
  outputDir: "target/e2e",
  preserveOutput: "failures-only",
  timeout: 180_000,
  fullyParallel: true,
  workers: Math.min(2, availableParallelism()),
  // Tests that pass on retry are reported as flaky.
  retries: 1,
  reporter: "list",
  expect: { timeout: 30_000 },
  use: { trace: "on-first-retry" },
  projects: [
    { name: "usual", testMatch: SPECS, grep: /@usual/ },
    { name: "rare", testMatch: SPECS, grepInvert: /@usual/ },
  ],
});
