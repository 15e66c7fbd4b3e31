"""Laplacian editing of a torus: properties of the operators, equality with a dense solution, and invalid input."""

import math
import pickle

import numpy as np
import pytest
import rosto

OPERATORS = ["L_s", "L", "degree", "inverse-length", "cotangent", "cotangent-mass"]


def torus(around: int = 16, through: int = 10) -> tuple[np.ndarray, np.ndarray]:
    u, v = np.meshgrid(np.arange(around), np.arange(through), indexing="ij")
    a, b = 2 * np.pi * u / around, 2 * np.pi * v / through
    ring = 3 + np.cos(b)
    positions = np.stack([ring * np.cos(a), ring * np.sin(a), np.sin(b)], -1).reshape(-1, 3)
    at = lambda i, j: (i % around) * through + j % through  # noqa: E731
    quads = [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(around) for j in range(through)]
    return positions, np.array([triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))])


@pytest.mark.parametrize("operator", OPERATORS)
def test_matrix_deltas_and_edits_match_the_equations(operator):
    editor = rosto.Laplacian(torus(), operator)
    matrix, rest, offset, weight = editor.matrix(), editor.positions, np.array([0, 0, 1.0]), 0.25
    assert np.abs(matrix.sum(axis=1)).max() < 1e-12
    assert np.allclose(matrix @ rest, editor.deltas(), atol=1e-12)
    assert np.allclose(editor.deltas(rest + [1, 2, 3]), editor.deltas(), atol=1e-9)
    exact = editor.edit({0: offset}, anchors=[50, 90]) - rest
    assert np.allclose(exact[0], offset, atol=1e-12) and np.abs(exact[[50, 90]]).max() < 1e-12
    # Soft constraints are additional rows of the system.
    fixed = np.eye(len(rest))[[0, 50, 90]]
    targets = fixed @ rest + [offset, np.zeros(3), np.zeros(3)]
    system = np.vstack([matrix.toarray(), np.sqrt(weight) * fixed])
    wanted = np.vstack([editor.deltas(), np.sqrt(weight) * targets])
    dense = np.linalg.lstsq(system, wanted, rcond=None)[0]
    assert np.allclose(editor.edit({0: offset}, [50, 90], weight), dense, atol=1e-8)


def test_edits_a_face_mesh(portrait):
    face = rosto.mesh(portrait)
    moved = rosto.Laplacian(face).edit({1: (0, 0, 0.005)}, anchors=[10, 152])
    assert np.allclose(moved[1] - face.positions_m[1], [0, 0, 0.005], atol=1e-12)


@pytest.mark.parametrize("operator", OPERATORS)
def test_an_editor_and_its_pickle_keep_copies_of_the_arrays(operator):
    positions, triangles = torus()
    editor = rosto.Laplacian((positions, triangles.astype(np.uint32)), operator)
    deltas = editor.deltas()
    positions[:] = 0
    again = pickle.loads(pickle.dumps(editor))
    assert np.array_equal(editor.deltas(), deltas) and np.array_equal(again.deltas(), deltas)
    assert np.array_equal(again.edit({3: (1, 0, 0)}, [80]), editor.edit({3: (1, 0, 0)}, [80]))


@pytest.mark.parametrize("kind", [np.int8, np.uint64, np.float32, np.float64])
def test_accepts_arrays_of_any_type_and_layout(kind):
    positions, triangles = torus(8, 8)
    expected = rosto.Laplacian((positions, triangles)).deltas()
    plain = triangles.astype(kind)
    for corners in [plain, plain.tolist(), np.asfortranarray(plain), plain[::-1]]:
        mesh = (positions[::-1][::-1], corners)
        assert np.allclose(rosto.Laplacian(mesh).deltas(np.asfortranarray(positions)), expected, atol=1e-12)
    unaligned = np.zeros(len(positions) * 24 + 1, np.uint8)[1:].view(np.float64).reshape(-1, 3)
    unaligned[:] = positions
    assert np.array_equal(rosto.Laplacian((unaligned, triangles)).deltas(unaligned.astype(">f8")), expected)


def test_accepts_numpy_handles_anchors_and_weights():
    editor = rosto.Laplacian(torus())
    expected = editor.edit({0: (0, 0, 1), 7: (1, 0, 0)}, [50, 90], 2.0)
    handles = {np.int64(0): np.array([0, 0, 1]), np.uint8(7): [np.float32(1), 0, np.array(0)]}
    for anchors in (np.array([50, 90]), (np.int16(50), 90.0), iter([50, 90])):
        assert np.array_equal(editor.edit(handles, anchors, np.float32(2)), expected)
    assert np.array_equal(editor.edit({0: (0, 0, 1)}, 50), editor.edit({0: (0, 0, 1)}, [np.array(50)]))


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf])
def test_refuses_coordinates_that_are_not_finite(wrong):
    positions, triangles = torus()
    positions[7, 1] = wrong
    with pytest.raises(rosto.RostoError, match="positions: row 7 is not finite"):
        rosto.Laplacian((positions, triangles))
    with pytest.raises(rosto.RostoError, match="positions: row 7 is not finite"):
        rosto.Laplacian(torus()).deltas(positions)
    with pytest.raises(rosto.RostoError, match=r"handles\[3\]\[2\]"):
        rosto.Laplacian(torus()).edit({3: (0, 0, wrong)}, [80])


@pytest.mark.parametrize("scale", [1e-320, 1e-160, 1e150, 1e300])
@pytest.mark.parametrize("operator", OPERATORS)
def test_results_are_finite_or_an_error(operator, scale):
    positions, triangles = torus()
    try:
        editor = rosto.Laplacian((positions * scale, triangles), operator)
        answers = [editor.edit({0: (0, 0, 1e300)}, [50]), editor.deltas(positions * 1e307), editor.deltas()]
        assert all(np.isfinite(answer).all() for answer in answers)
    except rosto.RostoError as error:
        assert "finite" in str(error) or "scaled" in str(error)


@pytest.mark.parametrize(
    ("error", "wrong"),
    [
        *((rosto.RostoError, wrong) for wrong in [2**32 + 2, 2**32, 2**64, -1, -(2**32), 160, 1.9, 1e300, math.nan, math.inf]),
        *((TypeError, wrong) for wrong in [True, "2", None, 2j, (2,)]),
    ],
)
def test_refuses_invalid_indices(error, wrong):
    editor = rosto.Laplacian(torus())
    with pytest.raises((rosto.RostoError, TypeError), match="triangles"):
        rosto.Laplacian((torus()[0], [[wrong] * 3]))
    with pytest.raises(error, match=r"anchors\[1\]"):
        editor.edit({0: (0, 0, 1)}, [50, wrong])
    with pytest.raises(error, match="handles"):
        editor.edit({wrong: (0, 0, 1)}, [50])


@pytest.mark.parametrize(
    ("error", "message", "work"),
    [
        (TypeError, "positions", lambda: rosto.Laplacian((np.zeros((3, 3), "U1"), [[0, 1, 2]]))),
        (TypeError, "triangles", lambda: rosto.Laplacian((np.eye(3), np.ones((1, 3), bool)))),
        (TypeError, "triangles", lambda: rosto.Laplacian((np.eye(3), np.array([[0, 1, 2]], object)))),
        (TypeError, "positions", lambda: rosto.Laplacian((np.eye(3) * 1j, [[0, 1, 2]]))),
        (rosto.RostoError, "triangles", lambda: rosto.Laplacian((np.eye(3), [[0, 1, 2], [0, 1]]))),
        (rosto.RostoError, "triangles", lambda: rosto.Laplacian((np.eye(3), [0, 1, 2]))),
        (rosto.RostoError, "vert", lambda: rosto.Laplacian((np.zeros((0, 3)), np.zeros((0, 3), int)))),
        (rosto.RostoError, "positions", lambda: rosto.Laplacian(([], []))),
        (rosto.RostoError, r"\(3, 2\), not \(N, 3\)", lambda: rosto.Laplacian((np.zeros((3, 2)), [[0, 1, 2]]))),
        (rosto.RostoError, "no vertex 7", lambda: rosto.Laplacian((np.eye(3), [[0, 1, 7]]))),
        (TypeError, "operator", lambda: rosto.Laplacian(torus(), None)),
        (rosto.RostoError, "cubist.*cotangent", lambda: rosto.Laplacian(torus(), "cubist")),
        (rosto.RostoError, "handle", lambda: rosto.Laplacian(torus()).edit({}, [50])),
        (rosto.RostoError, "handles", lambda: rosto.Laplacian(torus()).edit({0: (0, 0)}, [50])),
        (rosto.RostoError, "anchor", lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [])),
        (rosto.RostoError, "50", lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [50, 50])),
        (rosto.RostoError, "handle and an anchor", lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [0])),
        (rosto.RostoError, "weight", lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [50], math.nan)),
        (rosto.RostoError, "weight", lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [50], 0)),
        (TypeError, "weight", lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [50], "1")),
        (rosto.RostoError, "2 positions for 160 vertices", lambda: rosto.Laplacian(torus()).deltas(np.zeros((2, 3)))),
    ],
)
def test_refuses_invalid_meshes_and_edits_with_a_reason(error, message, work):
    with pytest.raises(error, match=message):
        work()
