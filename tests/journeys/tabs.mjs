import assert from "node:assert/strict";
import { keptWorks } from "./kept.mjs";
import { Visitor } from "./visitor.mjs";

/**
 * @param {Visitor} visitor
 * @param {string} address
 * @param {() => void} [script] runs in the page before its own
 */
export async function anotherTab(visitor, address, script) {
  const other = new Visitor(await visitor.page.context().newPage());
  if (script) await other.page.addInitScript(script);
  await other.page.goto(address);
  await other.untilLoaded();
  return other;
}

export async function continueIn(visitor) {
  await visitor.page.bringToFront();
  await visitor.page.waitForSelector("#continue:not([hidden])");
  await visitor.page.click("#continue");
  await visitor.untilFace();
}

/** What is open, and what has been done to it. */
export async function standing(visitor) {
  await visitor.page.bringToFront();
  return { mesh: await visitor.meshJson("mm"), history: await visitor.history() };
}

/** Waits until so many works are kept, and what was done last is among them. */
export async function untilKept(visitor, count) {
  for (let tries = 0; (await keptWorks(visitor.page)).length < count; tries += 1) {
    assert.ok(tries < 50, `only ${(await keptWorks(visitor.page)).length} works are kept`);
    await visitor.page.waitForTimeout(100);
  }
  await visitor.page.waitForTimeout(600);
}
