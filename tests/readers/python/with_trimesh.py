"""Trimesh: GLB, glTF, OBJ, PLY, STL and 3MF."""

import numpy
import trimesh

from seen import srgb_from_linear, tell, textured


def read(path):
    # Unprocessed: what is merged or thrown away on the way in could hide a fault of the file.
    scene = trimesh.load_scene(path, process=False)
    (mesh,) = scene.dump()
    body = mesh.copy()
    body.merge_vertices(merge_tex=True, merge_norm=True)
    seen = {"positions": mesh.vertices, "triangles": mesh.faces, **skin(mesh, path)}
    if body.is_watertight:
        seen |= {"closed": bool(body.is_winding_consistent), "volume": body.volume}
    if scene.units == "millimeters" or scene.units == "mm":
        seen["unit_m"] = 0.001
    return seen


def skin(mesh, path):
    visual = mesh.visual
    if visual.kind == "texture" and visual.uv is not None:
        material = visual.material
        picture = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
        # Trimesh counts from the bottom whatever the format does.
        return textured(picture, visual.uv, "bottom") if picture else {"uvs": visual.uv}
    if visual.kind == "vertex":
        colours = visual.vertex_colors[:, :3]
        # Of glTF it hands out the light's shares as they are; the other formats hold a picture's bytes.
        is_linear = path.endswith((".glb", ".gltf"))
        return {"skin": srgb_from_linear(colours / 255.0) if is_linear else colours}
    if visual.kind == "face":
        return {"triangle_skin": visual.face_colors[:, :3]}
    return {}


tell("trimesh", trimesh.__version__, read)
