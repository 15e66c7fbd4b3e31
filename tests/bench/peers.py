"""Benchmarks other solvers, on one thread, with the matrices of `crates/laplacian/benches/edit.rs`.

Prints one JSON object per line, with the median time in ms of

    edit from nothing   the paper's method: a dense pseudo-inverse for each of the three axes (468 vertices only)
    factor              factorisation of N, including symbolic analysis and ordering
    solve               one right-hand side with a kept factor
    factor and solve    both, as without a kept factor

N = L_s^T L_s + I_a + I_b + I_e (the paper's normal equations) on the canonical face, subdivided 0 to 4 times
(468, 1833, 7257, 28 881, 115 233 vertices). New vertices follow the old ones, in the order of the sorted edges.
Anchors 10 and 152, handle 1. Peers that are not installed are skipped with a note on standard error.
"""

import json
import os
import statistics
import sys
import time
from pathlib import Path

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[threads] = "1"

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as sparse_linalg

TOPOLOGY = Path(__file__).resolve().parent.parent / "golden" / "topology.json"
HANDLE, ANCHORS = 1, (10, 152)
LEVELS = 4
BUDGET_S = 2.0
FEWEST_RUNS, MOST_RUNS = 3, 200


def split(vertex_count, triangles):
    """Splits each triangle into four. Edge midpoints are numbered in the order of the sorted edges."""
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, of_side = np.unique(sides, axis=0, return_inverse=True)
    ab, bc, ca = (vertex_count + of_side.reshape(-1, 3)).T
    a, b, c = triangles.T
    corners = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
    return vertex_count + len(edges), np.concatenate([np.stack(corner, axis=1) for corner in corners])


def uniform_laplacian(vertex_count, triangles):
    """Returns L_s = D - Adj (eq. 4 of the paper)."""
    sides = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    both = np.concatenate([sides, sides[:, ::-1]])
    adjacency = sparse.csr_matrix((np.ones(len(both)), both.T), shape=(vertex_count, vertex_count))
    adjacency.data[:] = 1.0
    return (sparse.diags(np.asarray(adjacency.sum(axis=1)).ravel()) - adjacency).tocsc()


def normal_matrix(laplacian):
    held = np.zeros(laplacian.shape[0])
    held[[HANDLE, *ANCHORS]] = 1.0
    return (laplacian.T @ laplacian + sparse.diags(held)).tocsc()


def median_ms(action):
    """Returns the median time in ms and the number of runs that fit the time budget, after one warm-up run."""
    action()
    times, until = [], time.perf_counter() + BUDGET_S
    while len(times) < FEWEST_RUNS or (time.perf_counter() < until and len(times) < MOST_RUNS):
        start = time.perf_counter()
        action()
        times.append((time.perf_counter() - start) * 1e3)
    return statistics.median(times), len(times)


def report(what, peer, vertices, action):
    ms, runs = median_ms(action)
    record = {"task": "edit", "what": what, "size": f"{vertices} vertices", "peer": peer, "value": ms, "unit": "ms", "samples": runs}
    print(json.dumps(record), flush=True)


def pseudo_inverse_edit(laplacian, positions):
    """Algorithm 2 of the paper: `find_vector` inverts the matrix once per axis."""
    n = laplacian.shape[0]
    rows = np.zeros((3, n))
    rows[[0, 1, 2], [*ANCHORS, HANDLE]] = 1.0
    system = np.vstack([laplacian.toarray(), rows])
    target = system @ positions
    target[-1] += [0.1, 0.1, -0.1]
    return np.stack([np.linalg.pinv(system) @ target[:, axis] for axis in range(3)], axis=1)


def scipy_splu():
    return lambda matrix: sparse_linalg.splu(matrix).solve


def cholmod():
    from sksparse.cholmod import cholesky

    return lambda matrix: cholesky(matrix)


def libigl():
    import igl

    def factor(matrix):
        n = matrix.shape[0]
        data = igl.min_quad_with_fixed_data()
        nothing_known, nothing_equal = np.zeros(0, dtype=np.int64), sparse.csc_matrix((0, n))
        igl.min_quad_with_fixed_precompute(matrix, nothing_known, nothing_equal, True, data)
        no_rows = np.zeros((0, 1))
        return lambda b: igl.min_quad_with_fixed_solve(data, -b[:, None], no_rows, no_rows)

    return factor


PEERS = {"SciPy splu": scipy_splu, "CHOLMOD": cholmod, "libigl": libigl}


def bench_peer(name, factor, matrix):
    n = matrix.shape[0]
    unit = np.zeros(n)
    unit[HANDLE] = 1.0
    solve = factor(matrix)
    residual = np.abs(matrix @ np.asarray(solve(unit)).ravel() - unit).max()
    if not residual < 1e-6:
        raise ArithmeticError(f"{name} leaves a residual of {residual:.1e} at {n} vertices")
    report("factor", name, n, lambda: factor(matrix))
    report("solve", name, n, lambda: solve(unit))
    report("factor and solve", name, n, lambda: factor(matrix)(unit))


def main():
    table = json.loads(TOPOLOGY.read_text())
    count, triangles = len(table["vertices"]), np.array(table["triangles_canonical"])
    laplacian = uniform_laplacian(count, triangles)
    positions = np.array(table["vertices"])
    report("edit from nothing", "NumPy pinv", count, lambda: pseudo_inverse_edit(laplacian, positions))
    for level in range(LEVELS + 1):
        if level:
            count, triangles = split(count, triangles)
        matrix = normal_matrix(uniform_laplacian(count, triangles))
        for name, load in PEERS.items():
            try:
                bench_peer(name, load(), matrix)
            except (ImportError, ArithmeticError) as reason:
                print(f"{name} skipped: {reason}", file=sys.stderr)


if __name__ == "__main__":
    main()
