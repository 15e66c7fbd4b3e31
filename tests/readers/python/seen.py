"""A reader's report about each file: one line of JSON, with the properties of `Seen` in judge.mjs."""

import json
import sys
import traceback

import numpy


def report(read):
    """Reads each file named on the command line; prints what `read` returns, or why it failed."""
    for path in sys.argv[1:]:
        try:
            seen = read(path)
        except Exception:  # Whatever a reader does to a file is a finding about the file.
            seen = {"error": traceback.format_exc()}
        print(json.dumps({"path": path, **seen}, default=lambda array: array.tolist()))


def textured(pixels, uvs, origin):
    """The colour at each texture coordinate in rows of pixels from the top; the coordinates count from the "top" or the "bottom"."""
    pixels = numpy.asarray(pixels)[:, :, :3]
    height, width, _ = pixels.shape
    u, v = numpy.asarray(uvs, dtype=float).T
    v = v if origin == "top" else 1.0 - v
    column = numpy.clip((u * width).astype(int), 0, width - 1)
    row = numpy.clip((v * height).astype(int), 0, height - 1)
    return {"uvs": uvs, "texture": {"width": width, "height": height}, "skin": pixels[row, column]}


def srgb_from_linear(colours):
    """Linear light from 0 to 1 as sRGB from 0 to 255."""
    linear = numpy.clip(numpy.asarray(colours, dtype=float), 0.0, 1.0)
    curved = numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return numpy.round(255.0 * curved)
