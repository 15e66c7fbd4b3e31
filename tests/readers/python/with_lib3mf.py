"""lib3mf, the 3MF Consortium's own: 3MF and STL."""

import lib3mf
import numpy
from lib3mf import get_wrapper

from seen import tell

UNITS_M = {lib3mf.ModelUnit.MilliMeter: 0.001, lib3mf.ModelUnit.Meter: 1.0, lib3mf.ModelUnit.CentiMeter: 0.01}
WRAPPER = get_wrapper()


def read(path):
    model = WRAPPER.CreateModel()
    reader = model.QueryReader(path.rpartition(".")[2])
    # Strict: what is not as the specification says is a warning at least.
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(path)
    meshes = model.GetMeshObjects()
    if not meshes.MoveNext():
        raise ValueError("no mesh")
    mesh = meshes.GetCurrentMeshObject()
    seen = {
        "positions": numpy.array([list(vertex.Coordinates) for vertex in mesh.GetVertices()]),
        "triangles": numpy.array([list(triangle.Indices) for triangle in mesh.GetTriangleIndices()]),
        "remarks": [str(reader.GetWarning(at)) for at in range(reader.GetWarningCount())],
        "unit_m": UNITS_M[model.GetUnit()],
        **colours(model, mesh),
    }
    if mesh.IsManifoldAndOriented():
        seen["closed"] = True
    return seen


def colours(model, mesh):
    """The colour of each corner of each triangle, where the file has colours."""
    groups = model.GetColorGroups()
    palette = {}
    while groups.MoveNext():
        group = groups.GetCurrentColorGroup()
        for property_id in group.GetAllPropertyIDs():
            colour = group.GetColor(property_id)
            palette[group.GetResourceID(), property_id] = [colour.Red, colour.Green, colour.Blue]
    if not palette:
        return {}
    corners = [
        [palette.get((properties.ResourceID, at), [0, 0, 0]) for at in properties.PropertyIDs]
        for properties in mesh.GetAllTriangleProperties()
    ]
    return {"corner_skin": corners}


tell("lib3mf", ".".join(str(part) for part in WRAPPER.GetLibraryVersion()), read)
