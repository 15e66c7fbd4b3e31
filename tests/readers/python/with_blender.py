"""Blender as a module: GLB, glTF, OBJ, PLY, STL and USDZ, each by the importer that its menu offers."""

import contextlib
import os
import sys

import bpy
import numpy

from seen import tell

IMPORTERS = {
    "glb": bpy.ops.import_scene.gltf,
    "gltf": bpy.ops.import_scene.gltf,
    "obj": bpy.ops.wm.obj_import,
    "ply": bpy.ops.wm.ply_import,
    "stl": bpy.ops.wm.stl_import,
    "usdz": bpy.ops.wm.usd_import,
}
# Blender's +Z points up. These formats say that their +Y does, and are turned on the way in.
TURNED = {"glb", "gltf", "obj", "usdz"}


def read(path):
    ending = path.rpartition(".")[2]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with silence():
        IMPORTERS[ending](filepath=path)
    (body,) = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    mesh = body.data
    mesh.calc_loop_triangles()
    triangles = numpy.array([triangle.vertices for triangle in mesh.loop_triangles])
    return {"positions": upright(positions(body), ending), "triangles": triangles, "morphs": morphs(mesh), **skin(mesh)}


def positions(body):
    """With the shape keys at their values, as it is shown."""
    shown = body.evaluated_get(bpy.context.evaluated_depsgraph_get())
    points = numpy.array([vertex.co for vertex in shown.data.vertices], dtype=float)
    to_world = numpy.array(shown.matrix_world)
    return points @ to_world[:3, :3].T + to_world[:3, 3]


def upright(points, ending):
    """+Y up again."""
    return numpy.stack([points[:, 0], points[:, 2], -points[:, 1]], axis=1) if ending in TURNED else points


def morphs(mesh):
    keys = mesh.shape_keys.key_blocks[1:] if mesh.shape_keys else []
    return [{"name": key.name, "weight": key.value} for key in keys]


def skin(mesh):
    corners = numpy.array([loop.vertex_index for loop in mesh.loops])
    pictures = [picture for picture in bpy.data.images if picture.size[0] > 0]
    if mesh.uv_layers and pictures:
        return textured(mesh, corners, pictures[0])
    if mesh.color_attributes:
        return coloured(mesh, corners, mesh.color_attributes[0])
    return {}


def textured(mesh, corners, picture):
    width, height = picture.size
    # From the bottom left, as texture coordinates are.
    pixels = numpy.array(picture.pixels).reshape(height, width, -1)[:, :, :3]
    of_corners = numpy.array([corner.uv for corner in mesh.uv_layers[0].data])
    uvs = numpy.zeros((len(mesh.vertices), 2))
    uvs[corners] = of_corners
    column = numpy.clip((uvs[:, 0] * width).astype(int), 0, width - 1)
    row = numpy.clip((uvs[:, 1] * height).astype(int), 0, height - 1)
    skin = numpy.round(255 * pixels[row, column])
    return {"uvs": uvs, "texture": {"width": width, "height": height}, "skin": skin}


def coloured(mesh, corners, attribute):
    colours = numpy.array([entry.color_srgb for entry in attribute.data])[:, :3]
    skin = numpy.zeros((len(mesh.vertices), 3))
    skin[corners if attribute.domain == "CORNER" else slice(None)] = colours
    return {"skin": numpy.round(255 * skin)}


@contextlib.contextmanager
def silence():
    """Importers print what they do, some of them below Python; the lines of ours stay readable."""
    sys.stdout.flush()
    kept = os.dup(1)
    with open(os.devnull, "w") as nowhere:
        os.dup2(nowhere.fileno(), 1)
        try:
            yield
        finally:
            sys.stdout.flush()
            os.dup2(kept, 1)
            os.close(kept)


tell("Blender", bpy.app.version_string, read)
