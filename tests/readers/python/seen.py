"""What a reader says about the files it is given: one line of JSON for each.

Positions and triangles are as the reader hands them out, in the file's unit; `skin` is the colour that the reader shows at each
vertex, sRGB from 0 to 255, out of the texture or out of the vertices' own colours. All judging is done by who reads the lines.
"""

import json
import sys
import traceback

import numpy


def tell(reader, version, read):
    """Reads each file that the command line names, and says what was seen or why it could not be read."""
    for path in sys.argv[1:]:
        try:
            seen = read(path)
        except Exception:  # Whatever a reader does to a file is a finding about the file, not an end of the run.
            seen = {"error": traceback.format_exc()}
        print(json.dumps({"reader": reader, "version": version, "path": path, **seen}, default=listed))


def listed(value):
    """NumPy's arrays and numbers as JSON's."""
    return value.tolist()


def sampled(picture, uvs, origin):
    """The picture's colour at each texture coordinate, which count from the "top" or the "bottom"."""
    pixels = numpy.asarray(picture.convert("RGB"))
    height, width, _ = pixels.shape
    u, v = numpy.asarray(uvs, dtype=float).T
    v = v if origin == "top" else 1.0 - v
    column = numpy.clip((u * width).astype(int), 0, width - 1)
    row = numpy.clip((v * height).astype(int), 0, height - 1)
    return pixels[row, column]


def textured(picture, uvs, origin):
    """What is seen of a texture."""
    return {
        "uvs": uvs,
        "texture": {"width": picture.size[0], "height": picture.size[1]},
        "skin": sampled(picture, uvs, origin),
    }


def srgb_from_linear(colours):
    """Shares from 0 to 1 of light as bytes of a picture."""
    linear = numpy.clip(numpy.asarray(colours, dtype=float), 0.0, 1.0)
    curved = numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return numpy.round(255.0 * curved)
