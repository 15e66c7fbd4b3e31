//! Benchmarks of edits of the canonical face at several densities. `tests/bench/peers.py` runs other solvers on the
//! same matrices.
#![allow(clippy::unwrap_used, reason = "a benchmark fails by panicking")]
#![allow(missing_docs, reason = "Criterion's macros make public functions")]

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::DVec3;
use nalgebra_sparse::{CooMatrix, CsrMatrix};
use rosto_laplacian::{Constraints, Factor, LaplacianSystem, Operator};
use rosto_mesh::{LoopSubdivision, Topology};
use serde_json::Value;

const HANDLE: u32 = 1;
const ANCHORS: [u32; 2] = [10, 152];
const OFFSET: DVec3 = DVec3::new(0.1, 0.1, -0.1);
const LEVELS: u32 = 4;

fn edits(criterion: &mut Criterion) {
    let (cage, positions) = canonical_face();
    let mut group = criterion.benchmark_group("edit");
    group.sample_size(20).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
    for level in 0..=LEVELS {
        let dense = LoopSubdivision::new(&cage, level);
        let (topology, rest) = (dense.topology(), dense.apply(&positions));
        let size = format!("{} vertices", rest.len());
        let id = |what: &str| BenchmarkId::new(what, &size);

        let matrix = normal_matrix(topology, &rest);
        let factor = Factor::new(&matrix).unwrap();
        let mut unit = vec![0.0; rest.len()];
        unit[HANDLE as usize] = 1.0;
        group.bench_function(id("factor"), |bencher| bencher.iter(|| Factor::new(&matrix).unwrap()));
        group.bench_function(id("solve"), |bencher| bencher.iter(|| factor.solve(black_box(&mut unit.clone()))));
        group.bench_function(id("factor and solve"), |bencher| {
            bencher.iter(|| Factor::new(&matrix).unwrap().solve(black_box(&mut unit.clone())));
        });

        let system = || LaplacianSystem::new(topology, &rest, Operator::UniformSymmetric).unwrap();
        let ready = system();
        let response = ready.respond(&constraints()).unwrap();
        let mut edited = rest.clone();
        group.bench_function(id("edit with a kept factor"), |bencher| {
            bencher.iter(|| ready.respond(&constraints()).unwrap().displace(&rest, &[OFFSET], black_box(&mut edited)));
        });
        group.bench_function(id("slider tick"), |bencher| {
            bencher.iter(|| response.displace(&rest, &[OFFSET], black_box(&mut edited)));
        });
        group.bench_function(id("edit from nothing"), |bencher| {
            bencher
                .iter(|| system().respond(&constraints()).unwrap().displace(&rest, &[OFFSET], black_box(&mut edited)));
        });
    }
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

criterion_group!(benches, edits);
criterion_main!(benches);
