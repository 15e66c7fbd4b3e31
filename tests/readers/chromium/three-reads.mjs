// In the browser: what three.js' own loaders make of a file, told as the readers in Python tell it.
import { Color, LoadingManager, REVISION, Vector3 } from "three";
import { ThreeMFLoader } from "three/addons/loaders/3MFLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { MTLLoader } from "three/addons/loaders/MTLLoader.js";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { PLYLoader } from "three/addons/loaders/PLYLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import { USDLoader } from "three/addons/loaders/USDLoader.js";

/** As three.js numbers its releases. */
export const version = REVISION;

/** For a picture to be decoded. */
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

/** What a file is to three.js, with its pictures: an object, or the bare geometry. @param {string} url */
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
  await pictured(meshes[0].material);
  return seenOf(meshes[0]);
}

/** Some loaders give a material before its picture is there. */
async function pictured(material) {
  const until = performance.now() + WAIT_MS;
  while (material?.map && !material.map.image?.width && performance.now() < until) await new Promise((resolve) => setTimeout(resolve, 20));
}

function seenOf(mesh) {
  const { geometry, material } = mesh;
  const names = Object.entries(mesh.morphTargetDictionary ?? {}).sort((a, b) => a[1] - b[1]);
  return {
    // With the morph targets at their weights, as it is drawn.
    ...shapeOf(geometry, (at, point) => mesh.getVertexPosition(at, point).applyMatrix4(mesh.matrixWorld)),
    ...skinOf(geometry, material),
    morphs: names.map(([name, at]) => ({ name, weight: mesh.morphTargetInfluences[at] })),
    unlit: material.isMeshBasicMaterial === true,
  };
}

function shapeOf(geometry, placed) {
  const { position } = geometry.attributes;
  const point = new Vector3();
  const at = placed ?? ((index, into) => into.fromBufferAttribute(position, index));
  const corners = geometry.index ? [...geometry.index.array] : Array.from({ length: position.count }, (_, index) => index);
  return {
    positions: Array.from({ length: position.count }, (_, index) => at(index, point).toArray()),
    triangles: Array.from({ length: corners.length / 3 }, (_, index) => corners.slice(3 * index, 3 * index + 3)),
  };
}

function skinOf(geometry, material) {
  const { uv, color } = geometry.attributes;
  if (uv && material?.map) return texturedSkin(uv, material.map);
  if (!color || (material && !material.vertexColors)) return {};
  const one = new Color();
  const skin = Array.from({ length: color.count }, (_, at) => one.fromBufferAttribute(color, at).convertLinearToSRGB().toArray());
  return { skin: skin.map((colour) => colour.map((share) => Math.round(255 * share))) };
}

function texturedSkin(uv, { image, flipY }) {
  const canvas = new OffscreenCanvas(image.width, image.height);
  const context = canvas.getContext("2d");
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
