"""Reads GLB, glTF, OBJ, PLY, STL and 3MF with trimesh."""

import trimesh

from reporting import report, textured


def read(path):
    # Without processing, because merging and dropping vertices could hide faults.
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
        **colours(mesh.visual),
    }


def colours(visual):
    if visual.kind == "texture" and visual.uv is not None:
        material = visual.material
        picture = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
        return textured(picture.convert("RGB"), visual.uv) if picture else {"uvs": visual.uv}
    return {"vertex_colours": visual.vertex_colors[:, :3]} if visual.kind == "vertex" else {}


report(read)
