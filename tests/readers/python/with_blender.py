"""Reads GLB, glTF, OBJ, PLY, STL and USDZ with Blender's importers."""

import bpy
import numpy

from reporting import report, textured

IMPORTERS = {
    "glb": bpy.ops.import_scene.gltf,
    "gltf": bpy.ops.import_scene.gltf,
    "obj": bpy.ops.wm.obj_import,
    "ply": bpy.ops.wm.ply_import,
    "stl": bpy.ops.wm.stl_import,
    "usdz": bpy.ops.wm.usd_import,
}
# Formats with +Y up, which Blender rotates to +Z up.
TURNED = {"glb", "gltf", "obj", "usdz"}


def read(path):
    ending = path.rpartition(".")[2]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    IMPORTERS[ending](filepath=path)
    (body,) = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    mesh = body.data
    mesh.calc_loop_triangles()
    # With shape keys applied at their values.
    shown = body.evaluated_get(bpy.context.evaluated_depsgraph_get())
    points = numpy.array([shown.matrix_world @ vertex.co for vertex in shown.data.vertices])
    if ending in TURNED:
        points = numpy.stack([points[:, 0], points[:, 2], -points[:, 1]], axis=1)
    keys = mesh.shape_keys.key_blocks[1:] if mesh.shape_keys else []
    return {
        "positions": points,
        "triangles": [list(triangle.vertices) for triangle in mesh.loop_triangles],
        "morphs": [[key.name, key.value] for key in keys],
        **colours(mesh),
    }


def colours(mesh):
    corners = numpy.array([loop.vertex_index for loop in mesh.loops])
    pictures = [picture for picture in bpy.data.images if picture.size[0] > 0]
    if mesh.uv_layers and pictures:
        uvs = numpy.zeros((len(mesh.vertices), 2))
        uvs[corners] = [list(corner.uv) for corner in mesh.uv_layers[0].data]
        width, height = pictures[0].size
        # Blender's pixel rows start at the bottom.
        pixels = numpy.array(pictures[0].pixels).reshape(height, width, -1)[::-1]
        return textured(numpy.round(255 * pixels), uvs)
    if not mesh.color_attributes:
        return {}
    attribute = mesh.color_attributes[0]
    colours = numpy.zeros((len(mesh.vertices), 3))
    colours[corners if attribute.domain == "CORNER" else slice(None)] = [list(entry.color_srgb)[:3] for entry in attribute.data]
    return {"vertex_colours": numpy.round(255 * colours)}


report(read)
