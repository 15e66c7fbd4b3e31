"""pygltflib: GLB and glTF, the accessors decoded as the specification says, and the pictures by Pillow."""

import base64
import io
from importlib.metadata import version

import numpy
import PIL.Image
from pygltflib import GLTF2

from seen import srgb_from_linear, tell, textured

COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def read(path):
    file = GLTF2().load(path)
    (primitive,) = file.meshes[0].primitives
    attributes = primitive.attributes
    positions = values(file, attributes.POSITION).astype(float)
    morphs = []
    names = file.meshes[0].extras.get("targetNames", [])
    for at, target in enumerate(primitive.targets or []):
        moved = values(file, target["POSITION"] if isinstance(target, dict) else target.POSITION)
        weight = file.meshes[0].weights[at]
        positions = positions + weight * moved
        morphs.append({"name": names[at] if at < len(names) else None, "weight": weight})
    triangles = values(file, primitive.indices).reshape(-1, 3)
    return {"positions": positions, "triangles": triangles, "morphs": morphs, **skin(file, primitive)}


def skin(file, primitive):
    attributes = primitive.attributes
    material = file.materials[primitive.material]
    seen = {"unlit": "KHR_materials_unlit" in (material.extensions or {})}
    texture = material.pbrMetallicRoughness.baseColorTexture
    if texture is not None:
        picture = picture_of(file, file.images[file.textures[texture.index].source])
        return seen | textured(picture, values(file, attributes.TEXCOORD_0), "top")
    if attributes.COLOR_0 is not None:
        colours = values(file, attributes.COLOR_0)
        most = numpy.iinfo(colours.dtype).max if colours.dtype.kind == "u" else 1.0
        return seen | {"skin": srgb_from_linear(colours[:, :3] / most)}
    return seen


def values(file, index):
    """An accessor's numbers: one row for each element."""
    accessor = file.accessors[index]
    kind, width = numpy.dtype(COMPONENTS[accessor.componentType]), WIDTHS[accessor.type]
    rows = numpy.zeros((accessor.count, width), kind)
    if accessor.bufferView is not None:
        view = file.bufferViews[accessor.bufferView]
        start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
        stride = view.byteStride or width * kind.itemsize
        data = bytes_of(file, view.buffer)
        rows[:] = numpy.ndarray(rows.shape, kind, data, start, (stride, kind.itemsize))
    for sparse in [accessor.sparse] if accessor.sparse else []:
        rows[sparse_indices(file, sparse)] = sparse_values(file, sparse, kind, width)
    return rows


def sparse_indices(file, sparse):
    view = file.bufferViews[sparse.indices.bufferView]
    start = (view.byteOffset or 0) + (sparse.indices.byteOffset or 0)
    kind = COMPONENTS[sparse.indices.componentType]
    return numpy.frombuffer(bytes_of(file, view.buffer), kind, sparse.count, start)


def sparse_values(file, sparse, kind, width):
    view = file.bufferViews[sparse.values.bufferView]
    start = (view.byteOffset or 0) + (sparse.values.byteOffset or 0)
    return numpy.frombuffer(bytes_of(file, view.buffer), kind, sparse.count * width, start).reshape(-1, width)


def bytes_of(file, index):
    uri = file.buffers[index].uri
    return file.binary_blob() if uri is None else base64.b64decode(uri.partition(",")[2])


def picture_of(file, image):
    if image.uri is not None:
        data = base64.b64decode(image.uri.partition(",")[2])
    else:
        view = file.bufferViews[image.bufferView]
        start = view.byteOffset or 0
        data = bytes_of(file, view.buffer)[start : start + view.byteLength]
    picture = PIL.Image.open(io.BytesIO(data))
    picture.load()
    return picture


tell("pygltflib", version("pygltflib"), read)
