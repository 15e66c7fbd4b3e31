import { existsSync } from "node:fs";
import { mkdir, readFile, rename, writeFile } from "node:fs/promises";
import path from "node:path";
import { DIST, serve, versionIn } from "./server.mjs";
import { Visitor } from "./visitor.mjs";

const TARGET = process.env.CARGO_TARGET_DIR ?? path.join(import.meta.dirname, "../../target");

/**
 * The sample portrait as a project, saved by the page once per version.
 *
 * @param {() => Promise<import("@playwright/test").Browser>} launch
 */
export async function storedProject(launch) {
  const file = path.join(TARGET, "projects", `${await versionIn(DIST)}.rosto`);
  if (existsSync(file)) return readFile(file);
  const server = await serve(DIST, "/");
  const visitor = await Visitor.open(await launch(), server.url);
  await visitor.dropSample();
  const project = await visitor.download("save-project");
  await visitor.leave();
  server.close();
  // Another worker may write the same file, so rename it when complete.
  const unfinished = `${file}.${process.pid}`;
  await mkdir(path.dirname(file), { recursive: true });
  await writeFile(unfinished, project);
  await rename(unfinished, file);
  return project;
}
