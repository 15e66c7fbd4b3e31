"""pygltflib: GLB and glTF, the accessors decoded as the specification says, and the pictures by Pillow."""

import base64
import io

import numpy
import PIL.Image
from pygltflib import GLTF2

from seen import report, srgb_from_linear, textured

COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def read(path):
    file = GLTF2().load(path)
    (mesh,) = file.meshes
    (primitive,) = mesh.primitives
    positions = values(file, primitive.attributes.POSITION).astype(float)
    weights = mesh.weights or []
    for weight, target in zip(weights, primitive.targets or [], strict=True):
        positions += weight * values(file, target["POSITION"])
    names = mesh.extras.get("targetNames", [None] * len(weights))
    return {
        "positions": positions,
        "triangles": values(file, primitive.indices).reshape(-1, 3),
        "morphs": [{"name": name, "weight": weight} for name, weight in zip(names, weights, strict=True)],
        **skin(file, primitive.attributes, file.materials[primitive.material]),
    }


def skin(file, attributes, material):
    seen = {"unlit": "KHR_materials_unlit" in (material.extensions or {})}
    texture = material.pbrMetallicRoughness.baseColorTexture
    if texture is not None:
        image = file.images[file.textures[texture.index].source]
        data = from_uri(image.uri) if image.uri else view_of(file, image.bufferView)
        picture = PIL.Image.open(io.BytesIO(data)).convert("RGB")
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
        stride = file.bufferViews[accessor.bufferView].byteStride or width * kind.itemsize
        data = view_of(file, accessor.bufferView)
        rows[:] = numpy.ndarray(rows.shape, kind, data, accessor.byteOffset or 0, (stride, kind.itemsize))
    if accessor.sparse:
        places, changed = accessor.sparse.indices, accessor.sparse.values
        at = numpy.frombuffer(view_of(file, places.bufferView), COMPONENTS[places.componentType], accessor.sparse.count, places.byteOffset or 0)
        data = view_of(file, changed.bufferView)
        rows[at] = numpy.frombuffer(data, kind, len(at) * width, changed.byteOffset or 0).reshape(-1, width)
    return rows


def view_of(file, index):
    view = file.bufferViews[index]
    uri, start = file.buffers[view.buffer].uri, view.byteOffset or 0
    data = from_uri(uri) if uri else file.binary_blob()
    return data[start : start + view.byteLength]


def from_uri(uri):
    return base64.b64decode(uri.partition(",")[2])


report(read)
