// In the browser: the mesh that three.js' own loaders make of a file.
import { Color, LoadingManager, Vector3 } from "three";
import { ThreeMFLoader } from "three/addons/loaders/3MFLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { MTLLoader } from "three/addons/loaders/MTLLoader.js";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { PLYLoader } from "three/addons/loaders/PLYLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import { USDLoader } from "three/addons/loaders/USDLoader.js";

/** Limit for decoding a picture. */
const WAIT_MS = 10_000;

const LOADERS = {
  glb: async (url, manager) => (await new GLTFLoader(manager).loadAsync(url)).scene,
  gltf: async (url, manager) => (await new GLTFLoader(manager).loadAsync(url)).scene,
  obj: withMaterials,
  ply: (url, manager) => new PLYLoader(manager).loadAsync(url),
  stl: (url, manager) => new STLLoader(manager).loadAsync(url),
  "3mf": (url, manager) => new ThreeMFLoader(manager).loadAsync(url),
  usdz: (url, manager) => new USDLoader(manager).loadAsync(url),
};

/** A file with its pictures: an object, or the bare geometry. @param {string} url */
export async function load(url) {
  const manager = new LoadingManager();
  const lost = [];
  manager.onError = (missing) => lost.push(missing);
  const arrived = new Promise((resolve) => {
    manager.onLoad = () => resolve(undefined);
  });
  const loaded = await LOADERS[url.split(".").at(-1)](url, manager);
  await arrived;
  if (lost.length > 0) throw new Error(`not found: ${lost.join(", ")}`);
  return loaded;
}

/** @param {string} url */
export async function see(url) {
  const loaded = await load(url);
  if (loaded.isBufferGeometry) return { ...shapeOf(loaded), ...skinOf(loaded) };
  loaded.updateMatrixWorld(true);
  const meshes = [];
  loaded.traverse((object) => object.isMesh && meshes.push(object));
  if (meshes.length !== 1) throw new Error(`${meshes.length} meshes`);
  const [mesh] = meshes;
  await decoded(mesh.material.map);
  return {
    // With the morph targets at their weights, as it is drawn.
    ...shapeOf(mesh.geometry, (at, point) => mesh.getVertexPosition(at, point).applyMatrix4(mesh.matrixWorld)),
    ...skinOf(mesh.geometry, mesh.material),
    morphs: Object.entries(mesh.morphTargetDictionary ?? {}).map(([name, at]) => ({ name, weight: mesh.morphTargetInfluences[at] })),
    unlit: mesh.material.isMeshBasicMaterial === true,
  };
}

/** Some loaders return a material before its picture. */
async function decoded(map) {
  const until = performance.now() + WAIT_MS;
  while (map && !map.image?.width && performance.now() < until) await new Promise((resolve) => setTimeout(resolve, 20));
}

function shapeOf({ attributes: { position }, index }, at = (vertex, into) => into.fromBufferAttribute(position, vertex)) {
  const point = new Vector3();
  const corners = index ? [...index.array] : Array.from({ length: position.count }, (_, vertex) => vertex);
  return {
    positions: Array.from({ length: position.count }, (_, vertex) => at(vertex, point).toArray()),
    triangles: Array.from({ length: corners.length / 3 }, (_, triangle) => corners.slice(3 * triangle, 3 * triangle + 3)),
  };
}

function skinOf({ attributes: { uv, color } }, material) {
  if (uv && material?.map) return texturedSkin(uv, material.map);
  if (!color || (material && !material.vertexColors)) return {};
  const one = new Color();
  const skin = Array.from({ length: color.count }, (_, at) => one.fromBufferAttribute(color, at).convertLinearToSRGB().toArray());
  return { skin: skin.map((colour) => colour.map((share) => Math.round(255 * share))) };
}

function texturedSkin(uv, { image, flipY }) {
  const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
  context.drawImage(image, 0, 0);
  const { data, width, height } = context.getImageData(0, 0, image.width, image.height);
  const texel = (share, size) => Math.max(0, Math.min(size - 1, Math.floor(share * size)));
  const uvs = Array.from({ length: uv.count }, (_, at) => [uv.getX(at), uv.getY(at)]);
  const skin = uvs.map(([u, v]) => {
    const at = 4 * (texel(flipY ? 1 - v : v, height) * width + texel(u, width));
    return [...data.subarray(at, at + 3)];
  });
  return { uvs, texture: { width, height }, skin };
}

/** An OBJ with the materials that it names. */
async function withMaterials(url, manager) {
  const text = await (await fetch(url)).text();
  const named = /^mtllib (.+)$/m.exec(text)?.[1];
  const loader = new OBJLoader(manager);
  if (named) {
    const materials = await new MTLLoader(manager).loadAsync(new URL(named, new URL(url, location.href)).href);
    materials.preload();
    loader.setMaterials(materials);
  }
  return loader.loadAsync(url);
}
