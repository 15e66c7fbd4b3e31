// Runs in the browser: loads files with three.js' loaders, reports their meshes, and draws them.
import { Color, LoadingManager, Matrix4, Mesh, MeshStandardMaterial, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { ThreeMFLoader } from "three/addons/loaders/3MFLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { MTLLoader } from "three/addons/loaders/MTLLoader.js";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { PLYLoader } from "three/addons/loaders/PLYLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import { USDLoader } from "three/addons/loaders/USDLoader.js";

/** Time limit for decoding a picture. */
const WAIT_MS = 10_000;

/** Material for formats without materials. */
const PAINTED = new MeshStandardMaterial({ vertexColors: true });

const LOADERS = {
  glb: async (url, manager) => (await new GLTFLoader(manager).loadAsync(url)).scene,
  gltf: async (url, manager) => (await new GLTFLoader(manager).loadAsync(url)).scene,
  obj: withMaterials,
  ply: async (url, manager) => new Mesh(await new PLYLoader(manager).loadAsync(url), PAINTED),
  stl: async (url, manager) => new Mesh(await new STLLoader(manager).loadAsync(url), PAINTED),
  "3mf": (url, manager) => new ThreeMFLoader(manager).loadAsync(url),
  usdz: (url, manager) => new USDLoader(manager).loadAsync(url),
};

/** @param {string} url */
export async function read(url) {
  const loaded = await load(url);
  loaded.updateMatrixWorld(true);
  const meshes = [];
  loaded.traverse((object) => object.isMesh && meshes.push(object));
  if (meshes.length !== 1) throw new Error(`${meshes.length} meshes`);
  const [mesh] = meshes;
  const { attributes, index } = mesh.geometry;
  await decoded(mesh.material.map);
  const vertices = Array.from({ length: attributes.position.count }, (_, at) => at);
  const corners = index ? [...index.array] : vertices;
  const targets = Object.entries(mesh.morphTargetDictionary ?? {});
  return {
    // With morph targets applied at their weights.
    positions: vertices.map((at) => mesh.getVertexPosition(at, new Vector3()).applyMatrix4(mesh.matrixWorld).toArray()),
    triangles: Array.from({ length: corners.length / 3 }, (_, triangle) => corners.slice(3 * triangle, 3 * triangle + 3)),
    ...coloursOf(attributes, mesh.material),
    morphs: (mesh.morphTargetInfluences ?? []).map((weight, at) => [targets.find(([, target]) => target === at)?.[0], weight]),
    unlit: mesh.material.isMeshBasicMaterial === true,
  };
}

/**
 * Renders a file with a camera to a PNG as a data URL, with a transparent background. Without lights, so that only unlit
 * materials have colours.
 *
 * @param {string} url
 * @param {{ width: number, height: number, focal_px: number, cameraFromModel: number[] }} camera the matrix in
 *   column-major order; the camera looks along −Z through the centre of the picture
 */
export async function draw(url, { width, height, focal_px, cameraFromModel }) {
  const renderer = new WebGLRenderer({ alpha: true, preserveDrawingBuffer: true });
  renderer.setSize(width, height);
  const upright_deg = (360 / Math.PI) * Math.atan(height / 2 / focal_px);
  const shown = await load(url);
  shown.applyMatrix4(new Matrix4().fromArray(cameraFromModel));
  renderer.render(new Scene().add(shown), new PerspectiveCamera(upright_deg, width / height, 0.01, 100));
  const picture = renderer.domElement.toDataURL();
  renderer.forceContextLoss();
  return picture;
}

/** Loads a file and its pictures. @param {string} url */
async function load(url) {
  const manager = new LoadingManager();
  const lost = [];
  const arrived = new Promise((resolve) => Object.assign(manager, { onLoad: resolve, onError: (missing) => lost.push(missing) }));
  const loaded = await LOADERS[url.split(".").at(-1)](url, manager);
  await arrived;
  if (lost.length > 0) throw new Error(`not found: ${lost.join(", ")}`);
  return loaded;
}

/** Waits for a material's picture, because some loaders return earlier. */
async function decoded(map) {
  const until = performance.now() + WAIT_MS;
  while (map && !map.image?.width && performance.now() < until) await new Promise((resolve) => setTimeout(resolve, 20));
}

function coloursOf({ uv, color }, material) {
  if (uv && material.map) return texturedColours(uv, material.map);
  if (!color || !material.vertexColors) return {};
  const colours = Array.from({ length: color.count }, (_, at) => new Color().fromBufferAttribute(color, at).convertLinearToSRGB());
  return { vertex_colours: colours.map((colour) => colour.toArray().map((share) => Math.round(255 * share))) };
}

function texturedColours(uv, { image, flipY }) {
  const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
  context.drawImage(image, 0, 0);
  const { data, width, height } = context.getImageData(0, 0, image.width, image.height);
  const texel = (share, size) => Math.max(0, Math.min(size - 1, Math.floor(share * size)));
  const uvs = Array.from({ length: uv.count }, (_, at) => [uv.getX(at), uv.getY(at)]);
  const vertex_colours = uvs.map(([u, v]) => {
    const at = 4 * (texel(flipY ? 1 - v : v, height) * width + texel(u, width));
    return [...data.subarray(at, at + 3)];
  });
  return { uvs, texture: { width, height }, vertex_colours };
}

/** Loads an OBJ with the materials that it names. */
async function withMaterials(url, manager) {
  const named = /^mtllib (.+)$/m.exec(await (await fetch(url)).text())?.[1];
  const loader = new OBJLoader(manager);
  if (named) loader.setMaterials(await new MTLLoader(manager).loadAsync(url.replace(/[^/]+$/, named)));
  return loader.loadAsync(url);
}
