"""Computes the golden numbers of the editing engine with libigl and NumPy: tests/golden/engine.json.

Run with the packages of requirements-engine.txt. There are three meshes: the canonical face, a closed sphere and an
open, bumpy sheet. Fields per mesh:

- `cotangent`: libigl's cotangent matrix (negative semi-definite, half-cotangents) as [row, column, value], lower half,
- `biharmonic`: the field that minimises |L g|^2 with g = 1 on `handle` and 0 on `anchors` (no mass matrix),
- `geodesic`: exact polyhedral distances from `handle`,
- `harmonic`: the same for the form g^T L g,
- `arap`: libigl's as-rigid-as-possible deformation (spokes and rims, unclamped cotangents) after 500 iterations, with
  the handle moved by `offset` and the anchors fixed,
- `paper`: the paper's edit of `handle` by `offset` with the first two anchors, by `numpy.linalg.pinv` once per axis.
"""

import json
from pathlib import Path

import igl
import numpy as np
import scipy.sparse as sparse

GOLDEN = Path(__file__).resolve().parent.parent / "golden"


def sphere(levels=2):
    """A subdivided octahedron on the unit sphere, then scaled so that the axes differ."""
    vertices = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
    triangles = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]], dtype=np.int64)
    for _ in range(levels):
        vertices, triangles = igl.upsample(vertices, triangles)
        vertices = vertices / np.linalg.norm(vertices, axis=1, keepdims=True)
    return vertices * [1.0, 0.8, 1.3], triangles


def sheet(side=12):
    """A square height field with side x side vertices and an open boundary."""
    u, v = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side), indexing="ij")
    height = 0.12 * np.sin(5 * u + 1) * np.cos(4 * v)
    vertices = np.stack([u, v, height], axis=-1).reshape(-1, 3)
    cell = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)[None, :]).ravel()
    lower = np.stack([cell, cell + side, cell + 1], axis=1)
    upper = np.stack([cell + 1, cell + side, cell + side + 1], axis=1)
    return vertices, np.concatenate([lower, upper]).astype(np.int64)


def polyharmonic(form, handle, anchors):
    known = np.array([handle, *anchors], dtype=np.int64)
    values = np.zeros((len(known), 1))
    values[0] = 1.0
    return igl.min_quad_with_fixed(sparse.csc_matrix(form), np.zeros((form.shape[0], 1)), known, values)[:, 0]


def paper_edit(vertices, triangles, handle, anchors, offset):
    """Equation 7 of the paper, with L_s = D - Adj."""
    adjacency = igl.adjacency_matrix(triangles).toarray()
    laplacian = np.diag(adjacency.sum(axis=1)) - adjacency
    held = np.eye(len(vertices))[[*anchors, handle]]
    stacked = np.vstack([laplacian, held])
    targets = np.vstack([laplacian @ vertices, held @ vertices])
    targets[-1] += offset
    return np.stack([np.linalg.pinv(stacked) @ targets[:, axis] for axis in range(3)], axis=1)


def arap(vertices, triangles, handle, anchors, offset):
    fixed = np.array([handle, *anchors], dtype=np.int32)
    data = igl.ARAPData()
    data.energy = igl.pyigl_core.ARAP_ENERGY_TYPE_SPOKES_AND_RIMS
    data.max_iter = 500
    igl.arap_precomputation(vertices, triangles, 3, fixed, data)
    targets = vertices[fixed].copy()
    targets[0] += offset
    return igl.arap_solve(targets, data, vertices.copy())


def answers(name, vertices, triangles, handle, anchors, offset):
    laplacian = igl.cotmatrix(vertices, triangles)
    lower = sparse.tril(laplacian).tocoo()
    targets = np.arange(len(vertices), dtype=np.int64)
    distances = igl.exact_geodesic(vertices, triangles, VS=np.array([handle], dtype=np.int64), VT=targets)
    return {
        "name": name,
        "vertices": vertices.tolist(),
        "triangles": triangles.tolist(),
        "handle": handle,
        "anchors": anchors,
        "offset": offset,
        "cotangent": [[int(r), int(c), v] for r, c, v in zip(lower.row, lower.col, lower.data)],
        "harmonic": polyharmonic(-laplacian, handle, anchors).tolist(),
        "biharmonic": polyharmonic(laplacian.T @ laplacian, handle, anchors).tolist(),
        "geodesic": distances.tolist(),
        "arap": arap(vertices, triangles, handle, anchors, np.array(offset)).tolist(),
        "paper": paper_edit(vertices, triangles, handle, anchors[:2], np.array(offset)).tolist(),
    }


def main():
    table = json.loads((GOLDEN / "topology.json").read_text())
    face = np.array(table["vertices"]), np.array(table["triangles_canonical"], dtype=np.int64)
    meshes = [
        answers("canonical face", *face, 4, [10, 152, 234, 454], [0.3, 0.2, 1.0]),
        answers("sphere", *sphere(), 0, [1, 3], [0.4, 0.3, 0.0]),
        answers("sheet", *sheet(), 66, [0, 11, 132, 143], [0.05, 0.0, 0.3]),
    ]
    # Thirteen significant digits exceed the tolerances of the tests and save a third of the bytes.
    meshes = json.loads(json.dumps(meshes), parse_float=lambda number: float(f"{float(number):.13g}"))
    (GOLDEN / "engine.json").write_text(json.dumps({"meshes": meshes}, separators=(",", ":")) + "\n")


if __name__ == "__main__":
    main()
