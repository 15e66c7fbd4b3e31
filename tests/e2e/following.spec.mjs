// The worker tracks a face in camera frames. The tests use the VisionClient, not the page.
import assert from "node:assert/strict";
import path from "node:path";
import { portraitLandmarks } from "./video.mjs";
import { FRAMES_PER_S, STILL_FRAMES, mapToFrame, poseIn, speedIn } from "./video-frames.mjs";
import { test as base } from "./fixtures.mjs";
import { crashBefore } from "./page-scripts.mjs";
import { importParts } from "./parts.mjs";
import { inVersion } from "./server.mjs";

/** @typedef {import("./following-page.mjs").Seen} Seen */

/** The video takes four seconds. */
const WATCHED_MS = 9000;
/** Number of frames after which the smoothing has settled. */
const SETTLED_FRAMES = 10;

const test = base.extend({
  /** The exports of following-page.mjs, imported into a page with the VisionClient as `parts`. */
  following: async ({ page, server }, use) => {
    const fileOf = (url) => path.join(import.meta.dirname, path.basename(url));
    await page.route("**/film/*", (route) => route.fulfill({ path: fileOf(route.request().url()) }));
    // Without the page's policy and worker.
    await page.route("**/blank.html", (route) => route.fulfill({ contentType: "text/html", body: "<!doctype html><title>Blank</title>" }));
    await page.goto(`${server.url}blank.html`);
    const parts = await importParts(page, ["src/photo/vision-client.ts"]);
    await page.evaluate((parts) => void Object.assign(globalThis, { parts }), parts);
    await use(await page.evaluateHandle(() => import(new URL("film/following-page.mjs", document.baseURI).href)));
  },
});

test("tracking a camera's face is accurate at rest and does not lag in motion", { tag: "@moving-camera" }, async ({ following }) => {
  const seen = await following.evaluate(({ watch }, duration_ms) => watch(duration_ms), WATCHED_MS);
  assert.ok(seen.length > 30, `${seen.length} frames in ${WATCHED_MS} ms`);
  for (const { number, landmarks_px, answersMeanwhile } of seen) {
    assert.equal(landmarks_px?.length, 478, `no face in frame ${number}`);
    assert.ok(answersMeanwhile <= 1, `frame ${number} waited for ${answersMeanwhile} others`);
  }

  const still = seen.filter(({ number }) => number >= SETTLED_FRAMES && number < STILL_FRAMES);
  const rest = meanOf(still);
  assert.ok(jitter_px(still, rest) < 0.3, `jitter of ${jitter_px(still, rest)} px`);
  const truth = (await portraitLandmarks()).map((point) => mapToFrame(poseIn(0), point));
  const off_px = mean(rest.map(([x, y], point) => Math.hypot(x - truth[point][0], y - truth[point][1])));
  assert.ok(off_px < 2, `it is ${off_px} px off`);

  const lags_ms = seen.filter(({ number }) => speedIn(number) !== 0).map((frame) => lag_ms(frame, rest));
  assert.ok(lags_ms.length > 10, `${lags_ms.length} frames show motion`);
  const lag = mean(lags_ms);
  assert.ok(Math.abs(lag) < 60, `it is ${lag} ms behind`);
});

test("the first and last of simultaneous frames are answered, stopping answers all, and a crashed worker is replaced", { tag: "@usual" }, async ({ page, following }) => {
  const vision = await following.evaluateHandle(({ client }) => client());
  const { answered, left } = await vision.evaluate(async (vision) => {
    const frames = await Promise.all(Array.from({ length: 6 }, () => createImageBitmap(new ImageData(64, 48))));
    const answers = await Promise.all(frames.map((frame, number) => vision.follow(frame, 33 * number)));
    for (const answer of answers) answer?.frame.close();
    // A closed or transferred bitmap has no size.
    return { answered: answers.map((answer) => answer?.time_ms ?? null), left: frames.filter(({ width }) => width > 0).length };
  });
  assert.deepEqual(answered, [0, null, null, null, null, 165]);
  assert.equal(left, 0);

  const { afterStop, next } = await vision.evaluate(async (vision) => {
    const frame = () => createImageBitmap(new ImageData(64, 48));
    const stopped = [vision.follow(await frame(), 198), vision.follow(await frame(), 231)];
    vision.stopFollowing();
    const answers = await Promise.all(stopped);
    return { afterStop: answers.map((answer) => answer ?? null), next: (await vision.follow(await frame(), 264)).time_ms };
  });
  assert.deepEqual({ afterStop, next }, { afterStop: [null, null], next: 264 });

  const restarted = page.waitForEvent("worker");
  await page.workers().at(-1).evaluate(crashBefore, "follow");
  const { reason, waited, again } = await vision.evaluate(async (vision) => {
    const frame = () => createImageBitmap(new ImageData(64, 48));
    const [lost, waiting] = await Promise.allSettled([vision.follow(await frame(), 297), vision.follow(await frame(), 330)]);
    return { reason: lost.reason?.code, waited: waiting.value?.time_ms, again: (await vision.follow(await frame(), 363)).time_ms };
  });
  // The waiting frame goes to the next worker.
  assert.deepEqual({ reason, waited, again }, { reason: "worker-died", waited: 330, again: 363 });
  await restarted;
});

test("a large frame is downscaled, and its landmarks keep their positions", async ({ following }) => {
  const [small, large] = await following.evaluate(async ({ client }, sample) => {
    const vision = await client();
    const portrait = await createImageBitmap(await (await fetch(new URL(sample, document.baseURI))).blob());
    const found = [];
    for (const scale of [1, 3]) {
      const canvas = new OffscreenCanvas(640 * scale, 480 * scale);
      canvas.getContext("2d").drawImage(portrait, 80 * scale, 0, 480 * scale, 480 * scale);
      const { landmarks, width_px, height_px, frame } = await vision.follow(await createImageBitmap(canvas), 0);
      vision.stopFollowing();
      frame.close();
      found.push(Array.from(landmarks, (value, index) => value * [width_px, height_px, width_px][index % 3]));
    }
    return found;
  }, await inVersion("sample.png"));
  // The centre of the first pixel is at 0 at both scales.
  const off = (axis) => mean(large.flatMap((at, index) => (index % 3 === axis ? [at - 3 * small[index] - 1] : [])));
  assert.ok(Math.abs(off(0)) < 0.5 && Math.abs(off(1)) < 0.5, `${off(0)}, ${off(1)} px of 1920 × 1440`);
});

/** @param {number[]} numbers */
function mean(numbers) {
  return numbers.reduce((sum, each) => sum + each, 0) / numbers.length;
}

/** @param {Seen[]} frames */
function meanOf(frames) {
  return frames[0].landmarks_px.map((_, point) => [0, 1].map((axis) => mean(frames.map(({ landmarks_px }) => landmarks_px[point][axis]))));
}

/** Root mean square. @param {Seen[]} frames @param {number[][]} rest */
function jitter_px(frames, rest) {
  const squares = frames.map(({ landmarks_px }) => mean(landmarks_px.map(([x, y], point) => (x - rest[point][0]) ** 2 + (y - rest[point][1]) ** 2)));
  return Math.sqrt(mean(squares));
}

/** Delay between the face's motion and the landmarks, in ms. @param {Seen} frame @param {number[][]} rest */
function lag_ms({ number, landmarks_px }, rest) {
  const aside = poseIn(number).x - poseIn(0).x;
  const behind = mean(landmarks_px.map(([x], point) => rest[point][0] + aside - x));
  return (1000 / FRAMES_PER_S) * (behind / speedIn(number));
}
