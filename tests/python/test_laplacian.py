"""δ-coordinates of meshes that are no faces: the theorems hold, and the dense solution is the same."""

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


@pytest.fixture(params=OPERATORS)
def editor(request):
    return rosto.Laplacian(torus(), request.param)


def test_rows_sum_to_zero_and_deltas_are_the_matrix_times_positions(editor):
    matrix = editor.matrix()
    assert np.abs(matrix.sum(axis=1)).max() < 1e-12
    assert np.allclose(matrix @ editor.positions, editor.deltas(), atol=1e-12)
    assert np.allclose(editor.deltas(editor.positions + [1, 2, 3]), editor.deltas(), atol=1e-9)


def test_what_is_held_is_where_it_should_be_and_offsets_add_up(editor):
    one, other = np.array([0, 0, 1.0]), np.array([0.5, -1, 0])
    moved = [editor.edit({0: offset}, anchors=[50, 90]) - editor.positions for offset in (one, other, one + other)]
    assert np.allclose(moved[0][0], one, atol=1e-12) and np.abs(moved[0][[50, 90]]).max() < 1e-12
    assert np.allclose(moved[0] + moved[1], moved[2], atol=1e-10)


def test_soft_constraints_are_the_least_squares_of_the_paper(editor):
    weight, handles, anchors = 1.0, {0: np.array([0, 0, 1.0])}, [50, 90]
    held = np.zeros((3, len(editor.positions)))
    held[[0, 1, 2], [0, 50, 90]] = np.sqrt(weight)
    targets = editor.positions[[0, 50, 90]] + [handles[0], np.zeros(3), np.zeros(3)]
    system = np.vstack([editor.matrix().toarray(), held])
    wanted = np.vstack([editor.deltas(), np.sqrt(weight) * targets])
    dense = np.linalg.lstsq(system, wanted, rcond=None)[0]
    assert np.allclose(editor.edit(handles, anchors, weight), dense, atol=1e-8)


def test_a_face_is_a_mesh_like_any_other(portrait):
    face = rosto.mesh(portrait)
    moved = rosto.Laplacian(face).edit({1: (0, 0, 0.005)}, anchors=[10, 152])
    assert np.allclose(moved[1] - face.positions_m[1], [0, 0, 0.005], atol=1e-12)


def test_an_editor_pickles(editor):
    again = pickle.loads(pickle.dumps(editor))
    assert np.array_equal(again.edit({3: (1, 0, 0)}, [80]), editor.edit({3: (1, 0, 0)}, [80]))


def test_an_editor_keeps_its_mesh_when_the_arrays_are_used_again():
    positions, triangles = torus()
    editor = rosto.Laplacian((positions, triangles.astype(np.uint32)))
    deltas = editor.deltas()
    positions[:] = 0
    assert np.array_equal(editor.deltas(), deltas)
    assert np.array_equal(pickle.loads(pickle.dumps(editor)).deltas(), deltas)


@pytest.mark.parametrize("kind", [np.int8, np.uint64, np.float32, np.float64, object, list])
def test_arrays_of_any_kind_and_layout_are_the_same_mesh(kind):
    positions, triangles = torus(8, 8)
    expected = rosto.Laplacian((positions, triangles)).deltas()
    plain = triangles.tolist() if kind is list else triangles.astype(kind)
    for corners in [plain] if kind is list else [plain, np.asfortranarray(plain), plain[::-1]]:
        if kind is object:
            with pytest.raises(TypeError, match="triangles"):
                rosto.Laplacian((positions, corners))
            continue
        mesh = (positions[::-1][::-1], corners)
        assert np.allclose(rosto.Laplacian(mesh).deltas(np.asfortranarray(positions)), expected, atol=1e-12)
    unaligned = np.zeros(len(positions) * 24 + 1, np.uint8)[1:].view(np.float64).reshape(-1, 3)
    unaligned[:] = positions
    assert np.array_equal(rosto.Laplacian((unaligned, triangles)).deltas(unaligned.astype(">f8")), expected)


def test_handles_anchors_and_weights_may_be_numpys():
    editor = rosto.Laplacian(torus())
    expected = editor.edit({0: (0, 0, 1), 7: (1, 0, 0)}, [50, 90], 2.0)
    handles = {np.int64(0): np.array([0, 0, 1]), np.uint8(7): [np.float32(1), 0, np.array(0)]}
    for anchors in (np.array([50, 90]), (np.int16(50), 90.0), iter([50, 90])):
        assert np.array_equal(editor.edit(handles, anchors, np.float32(2)), expected)
    assert np.array_equal(editor.edit({0: (0, 0, 1)}, 50), editor.edit({0: (0, 0, 1)}, [np.array(50)]))


def test_what_is_shown_of_an_editor_is_short():
    assert repr(rosto.Laplacian(torus())) == "Laplacian(160 vertices, 320 triangles, 'cotangent')"


def with_coordinate(wrong) -> np.ndarray:
    positions = torus()[0]
    positions[7, 1] = wrong
    return positions


@pytest.mark.parametrize("operator", OPERATORS)
@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf])
def test_coordinates_are_finite(operator, wrong):
    with pytest.raises(rosto.RostoError, match="positions: row 7 is not finite"):
        rosto.Laplacian((with_coordinate(wrong), torus()[1]), operator)
    with pytest.raises(rosto.RostoError, match="positions: row 7 is not finite"):
        rosto.Laplacian(torus(), operator).deltas(with_coordinate(wrong))
    with pytest.raises(rosto.RostoError, match=r"handles\[3\]\[2\]"):
        rosto.Laplacian(torus(), operator).edit({3: (0, 0, wrong)}, [80])


@pytest.mark.parametrize("scale", [1e-320, 1e-160, 1e150, 1e300])
@pytest.mark.parametrize("operator", OPERATORS)
def test_answers_are_finite_or_refused(operator, scale):
    positions, triangles = torus()
    try:
        editor = rosto.Laplacian((positions * scale, triangles), operator)
        answers = [editor.edit({0: (0, 0, 1e300)}, [50]), editor.deltas(positions * 1e307), editor.deltas()]
        assert all(np.isfinite(answer).all() for answer in answers)
    except rosto.RostoError as refused:
        assert "finite" in str(refused) or "scaled" in str(refused)


@pytest.mark.parametrize("wrong", [2**32 + 2, 2**32, 2**64, -1, -(2**32), 160, 1.9, 1e300, math.nan, math.inf])
def test_an_index_that_names_no_vertex_is_refused(wrong):
    editor = rosto.Laplacian(torus())
    with pytest.raises((rosto.RostoError, TypeError), match="triangles"):
        rosto.Laplacian((torus()[0], [[0, 1, wrong]]))
    with pytest.raises(rosto.RostoError, match=r"anchors\[1\]"):
        editor.edit({0: (0, 0, 1)}, [50, wrong])
    with pytest.raises(rosto.RostoError, match="handles"):
        editor.edit({wrong: (0, 0, 1)}, [50])


@pytest.mark.parametrize("wrong", [True, "2", None, 2j, [2]], ids=repr)
def test_an_index_of_another_type_is_a_type_error(wrong):
    editor = rosto.Laplacian(torus())
    with pytest.raises((TypeError, rosto.RostoError), match="triangles"):
        rosto.Laplacian((torus()[0], np.array([[wrong, wrong, wrong]], object)))
    with pytest.raises(TypeError, match=r"anchors\[0\]"):
        editor.edit({0: (0, 0, 1)}, [wrong])
    if wrong != [2]:
        with pytest.raises(TypeError, match="handles"):
            editor.edit({wrong: (0, 0, 1)}, [50])


@pytest.mark.parametrize(
    ("work", "error"),
    [
        (lambda: rosto.Laplacian((np.zeros((3, 3), "U1"), [[0, 1, 2]])), TypeError),
        (lambda: rosto.Laplacian((np.eye(3), np.ones((1, 3), bool))), TypeError),
        (lambda: rosto.Laplacian((np.eye(3) * 1j, [[0, 1, 2]])), TypeError),
        (lambda: rosto.Laplacian((np.eye(3), [[0, 1, 2], [0, 1]])), rosto.RostoError),
        (lambda: rosto.Laplacian((np.eye(3), [0, 1, 2])), rosto.RostoError),
        (lambda: rosto.Laplacian((np.zeros((0, 3)), np.zeros((0, 3), int))), rosto.RostoError),
        (lambda: rosto.Laplacian(([], [])), rosto.RostoError),
        (lambda: rosto.Laplacian(torus(), None), TypeError),
        (lambda: rosto.Laplacian(torus()).edit({}, [50]), rosto.RostoError),
        (lambda: rosto.Laplacian(torus()).edit({0: (0, 0)}, [50]), rosto.RostoError),
        (lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [50, 50]), rosto.RostoError),
        (lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [50], math.nan), rosto.RostoError),
        (lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [50], 0), rosto.RostoError),
        (lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [50], "1"), TypeError),
    ],
)
def test_meshes_and_edits_of_other_kinds_are_refused(work, error):
    with pytest.raises(error):
        work()


@pytest.mark.parametrize(
    ("work", "words"),
    [
        (lambda: rosto.Laplacian(torus(), "cubist"), ["cubist", "cotangent"]),
        (lambda: rosto.Laplacian((np.zeros((3, 2)), [[0, 1, 2]])), ["(3, 2)", "(N, 3)"]),
        (lambda: rosto.Laplacian((np.eye(3), [[0, 1, 7]])), ["7"]),
        (lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, []), ["anchor"]),
        (lambda: rosto.Laplacian(torus()).edit({0: (0, 0, 1)}, [0]), ["handle and an anchor"]),
        (lambda: rosto.Laplacian(torus()).deltas(np.zeros((2, 3))), ["2 positions for 160 vertices"]),
    ],
)
def test_what_has_no_answer_says_why(work, words):
    with pytest.raises(rosto.RostoError) as refused:
        work()
    assert all(word in str(refused.value) for word in words), refused.value
