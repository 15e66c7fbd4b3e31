"""δ-coordinates of meshes that are no faces: the theorems hold, and the dense solution is the same."""

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
