"""Prints a reader's report about each file as a line of JSON, with the properties of `Report` in verifier.mjs."""

import json
import os
import sys
import traceback

import numpy

# Redirects the output of libraries, some of it from C, to standard error.
REPORT = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)


def report(read):
    """Reads the files on the command line; prints the result of `read`, or its error."""
    for path in sys.argv[1:]:
        try:
            outcome = read(path)
        except Exception:  # Any exception is a finding about the file.
            outcome = {"error": traceback.format_exc()}
        print(json.dumps(outcome, default=lambda array: array.tolist()), file=REPORT, flush=True)


def textured(pixels, uvs):
    """Returns the colour at each texture coordinate. Pixel rows start at the top, coordinates at the bottom."""
    pixels = numpy.asarray(pixels)[:, :, :3]
    height, width, _ = pixels.shape
    u, v = numpy.asarray(uvs, dtype=float).T
    column = numpy.clip((u * width).astype(int), 0, width - 1)
    row = numpy.clip(((1.0 - v) * height).astype(int), 0, height - 1)
    return {"uvs": uvs, "texture": {"width": width, "height": height}, "vertex_colours": pixels[row, column]}
