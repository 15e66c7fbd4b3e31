"""Trimesh: GLB, glTF, OBJ, PLY, STL and 3MF."""

import trimesh

from seen import report, srgb_from_linear, textured


def read(path):
    # Unprocessed: merging and dropping on the way in could hide a fault of the file.
    scene = trimesh.load_scene(path, process=False)
    (mesh,) = scene.dump()
    body = mesh.copy()
    body.merge_vertices(merge_tex=True, merge_norm=True)
    seen = {"positions": mesh.vertices, "triangles": mesh.faces, **skin(mesh.visual, path)}
    if body.is_watertight:
        seen |= {"closed": bool(body.is_winding_consistent), "volume": body.volume}
    if scene.units in ("millimeters", "mm"):
        seen["unit_m"] = 0.001
    return seen


def skin(visual, path):
    if visual.kind == "texture" and visual.uv is not None:
        material = visual.material
        picture = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
        # Trimesh counts from the bottom in every format.
        return textured(picture.convert("RGB"), visual.uv, "bottom") if picture else {"uvs": visual.uv}
    if visual.kind == "vertex":
        colours = visual.vertex_colors[:, :3]
        # Linear in glTF; the other formats hold sRGB.
        return {"skin": srgb_from_linear(colours / 255.0) if path.endswith((".glb", ".gltf")) else colours}
    return {}


report(read)
