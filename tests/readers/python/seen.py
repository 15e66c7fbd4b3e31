"""A reader's report about each file: one line of JSON, with the properties of `Seen` in judge.mjs."""

import json
import os
import sys
import traceback

import numpy

# Libraries print lines of their own, some of them from C: those go to standard error.
REPORT = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)


def report(read):
    """Reads each file named on the command line; prints what `read` returns, or why it failed."""
    for path in sys.argv[1:]:
        try:
            seen = read(path)
        except Exception:  # Whatever a reader does to a file is a finding about the file.
            seen = {"error": traceback.format_exc()}
        print(json.dumps(seen, default=lambda array: array.tolist()), file=REPORT, flush=True)


def textured(pixels, uvs):
    """The colour at each texture coordinate in rows of pixels from the top; the coordinates count from the bottom."""
    pixels = numpy.asarray(pixels)[:, :, :3]
    height, width, _ = pixels.shape
    u, v = numpy.asarray(uvs, dtype=float).T
    column = numpy.clip((u * width).astype(int), 0, width - 1)
    row = numpy.clip(((1.0 - v) * height).astype(int), 0, height - 1)
    return {"uvs": uvs, "texture": {"width": width, "height": height}, "skin": pixels[row, column]}
