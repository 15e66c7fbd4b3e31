"""OpenUSD: USDZ, with the rules of Apple's AR Quick Look."""

import io
import zipfile

import numpy
import PIL.Image
from pxr import Usd, UsdGeom, UsdShade, UsdUtils, UsdValidation

from seen import srgb_from_linear, tell, textured


def read(path):
    stage = Usd.Stage.Open(path)
    (mesh,) = [UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
    counts = numpy.array(mesh.GetFaceVertexCountsAttr().Get())
    if (counts != 3).any():
        raise ValueError(f"faces of {sorted(set(counts))} corners")
    to_world = numpy.array(UsdGeom.XformCache().GetLocalToWorldTransform(mesh.GetPrim()))
    points = numpy.array(mesh.GetPointsAttr().Get(), dtype=float)
    corners = numpy.array(mesh.GetFaceVertexIndicesAttr().Get())
    return {
        "positions": points @ to_world[:3, :3] + to_world[3, :3],
        "triangles": corners.reshape(-1, 3),
        "unit_m": UsdGeom.GetStageMetersPerUnit(stage),
        "up": UsdGeom.GetStageUpAxis(stage),
        "remarks": remarks(stage, path),
        **skin(mesh, corners, len(points), path),
    }


def remarks(stage, path):
    """What both of USD's own checks have to say, the older with Apple's rules."""
    checker = UsdUtils.ComplianceChecker(arkit=True)
    checker.CheckCompliance(path)
    said = checker.GetErrors() + checker.GetFailedChecks() + checker.GetWarnings()
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    return said + [error.GetErrorAsString() for error in context.Validate(stage)]


def skin(mesh, corners, count, path):
    material, _ = UsdShade.MaterialBindingAPI(mesh.GetPrim()).ComputeBoundMaterial()
    if not material:
        return {}
    surface = UsdShade.Shader(material.ComputeSurfaceSource()[0])
    (source, *_), _ = surface.GetInput("diffuseColor").GetConnectedSources()
    file = UsdShade.Shader(source.source).GetInput("file")
    if not file:
        return {"skin": srgb_from_linear(mesh.GetDisplayColorPrimvar().ComputeFlattened())}
    uvs = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st")
    of_corners = numpy.array(uvs.ComputeFlattened())
    uvs = of_corners if uvs.GetInterpolation() == UsdGeom.Tokens.vertex else numpy.zeros((count, 2))
    if len(of_corners) == len(corners) and len(of_corners) != count:
        uvs[corners] = of_corners
    return textured(picture_in(path, file.Get().path), uvs, "bottom")


def picture_in(path, name):
    with zipfile.ZipFile(path) as package:
        picture = PIL.Image.open(io.BytesIO(package.read(name.removeprefix("./"))))
        picture.load()
    return picture


tell("OpenUSD", ".".join(str(part) for part in Usd.GetVersion()[1:]), read)
