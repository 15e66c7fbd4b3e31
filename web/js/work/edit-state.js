/**
 * The edits of the open face as they are now.
 *
 * @param {import("../viewport/host.js").Host | undefined} host
 * @returns {import("./work.js").EditState | undefined}
 */
export function editStateOf(host) {
  return host?.read((state, studio) => {
    const [triangulation = "", density = "0"] = ["triangulation", "density"].map((choice) => state.chosen(choice));
    const [edits, photo, lens, preferences] = [studio.editsJson(), studio.photoEdit, studio.photoLens, studio.preferences()];
    return { edits, photo, triangulation, density: Number(density), lens, preferences };
  });
}
