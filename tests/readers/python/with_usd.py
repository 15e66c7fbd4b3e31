"""Reads USDZ with OpenUSD, and checks it against the rules of Apple's AR Quick Look."""

import io
import zipfile

import numpy
import PIL.Image
from pxr import Usd, UsdGeom, UsdShade, UsdUtils, UsdValidation

from reporting import report, textured


def read(path):
    stage = Usd.Stage.Open(path)
    (mesh,) = [UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
    counts = set(mesh.GetFaceVertexCountsAttr().Get())
    if counts != {3}:
        raise ValueError(f"faces of {counts} corners")
    to_world = numpy.array(UsdGeom.XformCache().GetLocalToWorldTransform(mesh.GetPrim()))
    points = numpy.array(mesh.GetPointsAttr().Get(), dtype=float)
    return {
        "positions": points @ to_world[:3, :3] + to_world[3, :3],
        "triangles": numpy.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3),
        "unit_m": UsdGeom.GetStageMetersPerUnit(stage),
        "up": UsdGeom.GetStageUpAxis(stage),
        "remarks": remarks(stage, path),
        **colours(mesh, path),
    }


def remarks(stage, path):
    """Returns the findings of both USD checkers; the older one contains Apple's rules."""
    checker = UsdUtils.ComplianceChecker(arkit=True)
    checker.CheckCompliance(path)
    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    errors = [error.GetErrorAsString() for error in context.Validate(stage)]
    return checker.GetErrors() + checker.GetFailedChecks() + checker.GetWarnings() + errors


def colours(mesh, path):
    material, _ = UsdShade.MaterialBindingAPI(mesh.GetPrim()).ComputeBoundMaterial()
    if not material:
        return {}
    surface = UsdShade.Shader(material.ComputeSurfaceSource()[0])
    (source, *_), _ = surface.GetInput("diffuseColor").GetConnectedSources()
    file = UsdShade.Shader(source.source).GetInput("file")
    if not file:
        return {"vertex_colours": srgb_from_linear(mesh.GetDisplayColorPrimvar().ComputeFlattened())}
    uvs = numpy.array(UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st").ComputeFlattened())
    with zipfile.ZipFile(path) as package:
        picture = PIL.Image.open(io.BytesIO(package.read(file.Get().path.removeprefix("./"))))
        return textured(picture.convert("RGB"), uvs)


def srgb_from_linear(colours):
    """Converts linear light (0 to 1) to sRGB (0 to 255)."""
    linear = numpy.array(colours, dtype=float)
    return numpy.round(255.0 * numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055))


report(read)
