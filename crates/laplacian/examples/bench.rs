//! How long the engine takes, beside the paper's own way and beside nalgebra-sparse's Cholesky.
//!
//! Prints one JSON object a line, in the form of `tests/bench/peers.py`, which times other solvers on the same matrices:
//! `{"task": TASK, "peer": PEER, "vertices": N, "ms": MEDIAN, "runs": R}`. Beyond the tasks named there:
//!
//! - `system`  everything that is done once per mesh and operator, from triangles to factor
//! - `select`  the response field of a handle and two anchors
//! - `tick`    the mesh moved by one slider
#![allow(clippy::unwrap_used, reason = "a measurement that cannot go on should stop")]

use std::hint::black_box;
use std::time::{Duration, Instant};

use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;
use glam::DVec3;
use nalgebra::{DMatrix, DVector};
use nalgebra_sparse::factorization::{CscCholesky, CscSymbolicCholesky};
use nalgebra_sparse::{CooMatrix, CscMatrix, CsrMatrix};
use rosto_laplacian::{Constraints, Factor, LaplacianSystem, Operator};
use rosto_mesh::{LoopSubdivision, Topology};
use serde_json::{Value, json};

const HANDLE: u32 = 1;
const ANCHORS: [u32; 2] = [10, 152];
const OFFSET: DVec3 = DVec3::new(0.1, 0.1, -0.1);
const LEVELS: u32 = 4;

const BUDGET: Duration = Duration::from_secs(2);
const FEWEST_RUNS: usize = 3;
const MOST_RUNS: usize = 200;

fn main() {
    let (cage, positions) = canonical_face();
    paper_edits(&cage, &positions);
    for level in 0..=LEVELS {
        let dense = LoopSubdivision::new(&cage, level);
        let rest = dense.apply(&positions);
        engine(dense.topology(), &rest);
        solvers(&normal_matrix(dense.topology(), &rest));
    }
}

/// From the choice of a vertex to the moved mesh: with the factor at hand, from nothing, and as the paper does it, from
/// nothing as well.
fn paper_edits(topology: &Topology, rest: &[DVec3]) {
    let system = LaplacianSystem::new(topology, rest, Operator::UniformSymmetric).unwrap();
    let mut edited = rest.to_vec();
    report("paper-edit", "rosto", rest.len(), || {
        system.respond(&constraints()).unwrap().displace(rest, &[OFFSET], &mut edited);
    });
    report("paper-edit-bare", "rosto", rest.len(), || {
        let system = LaplacianSystem::new(topology, rest, Operator::UniformSymmetric).unwrap();
        system.respond(&constraints()).unwrap().displace(rest, &[OFFSET], &mut edited);
    });
    let operator = DMatrix::from(system.operator());
    report("paper-edit", "nalgebra-pinv", rest.len(), || {
        black_box(by_pseudo_inverses(&operator, rest));
    });
}

/// Algorithm 2 of the paper, to the letter: the matrix is inverted anew for every axis.
fn by_pseudo_inverses(operator: &DMatrix<f64>, rest: &[DVec3]) -> [DVector<f64>; 3] {
    let n = operator.ncols();
    let constrained = [ANCHORS[0], ANCHORS[1], HANDLE].map(|vertex| vertex as usize);
    [0, 1, 2].map(|axis| {
        let mut stacked = operator.clone().insert_rows(n, 3, 0.0);
        constrained.iter().enumerate().for_each(|(row, &vertex)| stacked[(n + row, vertex)] = 1.0);
        let mut target = &stacked * DVector::from_iterator(n, rest.iter().map(|position| position[axis]));
        target[n + 2] += OFFSET[axis];
        stacked.pseudo_inverse(1e-12).unwrap() * target
    })
}

/// What the product does at each step of the user's.
fn engine(topology: &Topology, rest: &[DVec3]) {
    report("system", "rosto", rest.len(), || {
        black_box(LaplacianSystem::new(topology, rest, Operator::UniformSymmetric).unwrap());
    });
    let system = LaplacianSystem::new(topology, rest, Operator::UniformSymmetric).unwrap();
    report("select", "rosto", rest.len(), || {
        black_box(system.respond(&constraints()).unwrap());
    });
    let response = system.respond(&constraints()).unwrap();
    let mut edited = rest.to_vec();
    report("tick", "rosto", rest.len(), || response.displace(rest, &[OFFSET], black_box(&mut edited)));
}

/// Factor and solve, with this crate and with nalgebra-sparse under the same kind of order.
fn solvers(matrix: &CsrMatrix<f64>) {
    let n = matrix.nrows();
    let mut unit = vec![0.0; n];
    unit[HANDLE as usize] = 1.0;

    let factor = Factor::new(matrix).unwrap();
    report("factor", "rosto", n, || {
        black_box(Factor::new(matrix).unwrap());
    });
    report("solve", "rosto", n, || factor.solve(black_box(&mut unit.clone())));
    report("edit", "rosto", n, || Factor::new(matrix).unwrap().solve(black_box(&mut unit.clone())));

    let rhs = DVector::from_column_slice(&unit);
    let other = by_nalgebra(matrix);
    report("factor", "nalgebra-sparse with AMD", n, || {
        black_box(by_nalgebra(matrix));
    });
    report("solve", "nalgebra-sparse with AMD", n, || {
        black_box(other.solve(&rhs));
    });
}

/// nalgebra-sparse has no fill-reducing order: it is given one.
fn by_nalgebra(matrix: &CsrMatrix<f64>) -> CscCholesky<f64> {
    let n = matrix.nrows();
    let pattern = SymbolicSparseColMatRef::new_checked(n, n, matrix.row_offsets(), None, matrix.col_indices());
    let (mut order, mut place) = (vec![0; n], vec![0; n]);
    let scratch = amd::order_scratch::<usize>(n, matrix.nnz());
    let mut memory = faer::dyn_stack::MemBuffer::new(scratch);
    let stack = faer::dyn_stack::MemStack::new(&mut memory);
    amd::order(&mut order, &mut place, pattern, amd::Control::default(), stack).unwrap();
    let mut entries = CooMatrix::new(n, n);
    matrix.triplet_iter().for_each(|(i, j, &value)| entries.push(place[i], place[j], value));
    let permuted = CscMatrix::from(&entries);
    let symbolic = CscSymbolicCholesky::factor(permuted.pattern().clone());
    CscCholesky::factor_numerical(symbolic, permuted.values()).unwrap()
}

fn constraints() -> Constraints<'static> {
    Constraints { handles: &[HANDLE], anchors: &ANCHORS, ..Default::default() }
}

/// `N = KᵀK + I_a + I_b + I_e` with `K = L_s`.
fn normal_matrix(topology: &Topology, rest: &[DVec3]) -> CsrMatrix<f64> {
    let operator = Operator::UniformSymmetric.matrix(topology, rest).unwrap();
    let mut constrained = CooMatrix::new(rest.len(), rest.len());
    [HANDLE, ANCHORS[0], ANCHORS[1]].iter().for_each(|&vertex| constrained.push(vertex as usize, vertex as usize, 1.0));
    operator.transpose() * operator + CsrMatrix::from(&constrained)
}

fn canonical_face() -> (Topology, Vec<DVec3>) {
    let tables: Value = serde_json::from_str(include_str!("../../../tests/golden/topology.json")).unwrap();
    let corners = |t: &Value| [0, 1, 2].map(|k| t[k].as_u64().unwrap() as u32);
    let point = |p: &Value| DVec3::from([0, 1, 2].map(|k| p[k].as_f64().unwrap()));
    let triangles = tables["triangles_canonical"].as_array().unwrap().iter().map(corners).collect();
    let positions: Vec<DVec3> = tables["vertices"].as_array().unwrap().iter().map(point).collect();
    (Topology::new(positions.len(), triangles).unwrap(), positions)
}

/// Prints the median of as many runs as fit the budget, after one that is not counted. What is too short for the clock
/// is timed by the hundred.
fn report(task: &str, peer: &str, vertices: usize, mut action: impl FnMut()) {
    let once = Instant::now();
    action();
    let batch = if once.elapsed() < Duration::from_micros(50) { 100 } else { 1 };
    let (mut times, start) = (Vec::new(), Instant::now());
    while times.len() < FEWEST_RUNS || (start.elapsed() < BUDGET && times.len() < MOST_RUNS) {
        let run = Instant::now();
        (0..batch).for_each(|_| action());
        times.push(run.elapsed().as_secs_f64() * 1e3 / f64::from(batch));
    }
    times.sort_by(f64::total_cmp);
    let ms = times[times.len() / 2];
    println!("{}", json!({"task": task, "peer": peer, "vertices": vertices, "ms": ms, "runs": times.len()}));
}
