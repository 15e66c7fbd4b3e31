"""Reads 3MF and STL with the 3MF Consortium's lib3mf."""

import lib3mf
from lib3mf import get_wrapper

from reporting import report

UNITS_M = {lib3mf.ModelUnit.MilliMeter: 0.001, lib3mf.ModelUnit.Meter: 1.0, lib3mf.ModelUnit.CentiMeter: 0.01}
WRAPPER = get_wrapper()


def read(path):
    model = WRAPPER.CreateModel()
    reader = model.QueryReader(path.rpartition(".")[2])
    # Strict mode reports deviations from the specification at least as warnings.
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(path)
    meshes = model.GetMeshObjects()
    meshes.MoveNext()
    mesh = meshes.GetCurrentMeshObject()
    return {
        "positions": [list(vertex.Coordinates) for vertex in mesh.GetVertices()],
        "triangles": [list(triangle.Indices) for triangle in mesh.GetTriangleIndices()],
        "remarks": [str(reader.GetWarning(at)) for at in range(reader.GetWarningCount())],
        "unit_m": UNITS_M[model.GetUnit()],
        "closed": mesh.IsManifoldAndOriented(),
        **colours(model, mesh),
    }


def colours(model, mesh):
    """Returns the colour of each triangle corner, if the file has colours."""
    groups = model.GetColorGroups()
    if not groups.MoveNext():
        return {}
    group = groups.GetCurrentColorGroup()
    palette = {at: group.GetColor(at) for at in group.GetAllPropertyIDs()}
    corners = [[palette[at] for at in triangle.PropertyIDs] for triangle in mesh.GetAllTriangleProperties()]
    return {"corner_colours": [[[colour.Red, colour.Green, colour.Blue] for colour in triangle] for triangle in corners]}


report(read)
