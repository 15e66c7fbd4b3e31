/**
 * What was done to the face that is open, as it stands.
 *
 * @param {import("../viewport/host.js").Host | undefined} host
 * @returns {import("./work.js").Done | undefined}
 */
export function standing(host) {
  return host?.read((state, studio) => {
    const [triangulation = "", density = "0"] = ["triangulation", "density"].map((choice) => state.chosen(choice));
    const [edits, photo, lens, preferences] = [studio.editsJson(), studio.photoEdit, studio.photoLens, studio.preferences()];
    return { edits, photo, triangulation, density: Number(density), lens, preferences };
  });
}
