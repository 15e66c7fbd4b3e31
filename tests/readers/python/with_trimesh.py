"""Trimesh: GLB, glTF, OBJ, PLY, STL and 3MF."""

import trimesh

from seen import report, textured


def read(path):
    # Unprocessed: merging and dropping on the way in could hide a fault of the file.
    scene = trimesh.load_scene(path, process=False)
    (mesh,) = scene.dump()
    body = mesh.copy()
    body.merge_vertices(merge_tex=True, merge_norm=True)
    return {
        "positions": mesh.vertices,
        "triangles": mesh.faces,
        "closed": bool(body.is_volume),
        "volume": body.volume,
        **({"unit_m": trimesh.units.unit_conversion(scene.units, "meters")} if scene.units else {}),
        **skin(mesh.visual),
    }


def skin(visual):
    if visual.kind == "texture" and visual.uv is not None:
        material = visual.material
        picture = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
        return textured(picture.convert("RGB"), visual.uv) if picture else {"uvs": visual.uv}
    return {"skin": visual.vertex_colors[:, :3]} if visual.kind == "vertex" else {}


report(read)
