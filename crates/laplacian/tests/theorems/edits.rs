use glam::DVec3;
use nalgebra::{DMatrix, DVector};
use rosto_laplacian::{ConstraintKind, Constraints, LaplacianSystem, Operator, Response, random_anchors};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::golden::{face, golden};
use crate::meshes::{Mesh, canonical_face, handle_and_anchors, plane, small, torus};
use crate::seeded::Seeded;

const KINDS: [ConstraintKind; 3] =
    [ConstraintKind::Soft { weight: 1.0 }, ConstraintKind::Soft { weight: 250.0 }, ConstraintKind::Hard];

fn system(mesh: &Mesh, operator: Operator) -> LaplacianSystem {
    LaplacianSystem::new(&mesh.topology, &mesh.positions, operator).unwrap()
}

fn moved(response: &Response, mesh: &Mesh, offsets: &[DVec3]) -> Vec<DVec3> {
    let mut out = vec![DVec3::ZERO; mesh.vertex_count()];
    response.displace(&mesh.positions, offsets, &mut out);
    out
}

/// Calls `check` for each small mesh, operator and constraint kind, with one handle and two anchors.
fn each(check: impl Fn(&str, &Mesh, &LaplacianSystem, &Constraints<'_>)) {
    for mesh in small() {
        let (handle, anchors) = handle_and_anchors(&mesh);
        for operator in Operator::ALL {
            let system = system(&mesh, operator);
            for kind in KINDS {
                let constraints = Constraints { handles: &[handle], anchors: &anchors, kind, falloff: None };
                check(&format!("{operator:?}, {kind:?} on {}", mesh.name), &mesh, &system, &constraints);
            }
        }
    }
}

#[test]
fn a_zero_offset_returns_the_rest_positions() {
    each(|case, mesh, system, constraints| {
        let response = system.respond(constraints).unwrap();
        assert_eq!(moved(&response, mesh, &[DVec3::ZERO]), mesh.positions, "{case}");
    });
}

#[test]
fn the_edit_minimises_the_energy() {
    let offset = DVec3::new(0.3, -0.2, 0.9);
    each(|case, mesh, system, constraints| {
        let best = moved(&system.respond(constraints).unwrap(), mesh, &[offset]);
        let least = residual(system, constraints, offset, &mesh.positions, &best);
        let random = &mut Seeded::new(5);
        for _ in 0..20 {
            let free = |vertex: usize| constraints.kind != ConstraintKind::Hard || !is_constrained(constraints, vertex);
            let nudge = |(vertex, &p): (usize, &DVec3)| if free(vertex) { p + 0.01 * random.vector() } else { p };
            let other: Vec<DVec3> = best.iter().enumerate().map(nudge).collect();
            let residual = residual(system, constraints, offset, &mesh.positions, &other);
            assert!(residual >= least, "{case}: {residual} under {least}");
        }
    });
}

/// The energy that an edit of one handle minimises: `‖K X' − K X‖² + Σ w‖x'ᵢ − targetᵢ‖²`.
fn residual(
    system: &LaplacianSystem,
    constraints: &Constraints<'_>,
    offset: DVec3,
    rest: &[DVec3],
    edited: &[DVec3],
) -> f64 {
    let moved: Vec<DVec3> = edited.iter().zip(rest).map(|(after, before)| after - before).collect();
    let bent: f64 = system.deltas(&moved).iter().map(|delta| delta.length_squared()).sum();
    let ConstraintKind::Soft { weight } = constraints.kind else { return bent };
    let constrained = constraints.handles.iter().chain(constraints.anchors);
    let targets = std::iter::once(offset).chain(std::iter::repeat(DVec3::ZERO));
    let missed = constrained.zip(targets).map(|(&vertex, target)| (moved[vertex as usize] - target).length_squared());
    bent + weight * missed.sum::<f64>()
}

fn is_constrained(constraints: &Constraints<'_>, vertex: usize) -> bool {
    constraints.handles.iter().chain(constraints.anchors).any(|&constrained| constrained as usize == vertex)
}

#[test]
fn hard_handles_reach_their_targets_and_anchors_stay() {
    let random = &mut Seeded::new(21);
    let mesh = canonical_face();
    for operator in Operator::ALL {
        let system = system(&mesh, operator);
        for _ in 0..10 {
            let constrained = random.vertices(9, 468);
            let (handles, anchors) = constrained.split_at(4);
            let constraints = Constraints { handles, anchors, kind: ConstraintKind::Hard, falloff: None };
            let offsets: Vec<DVec3> = handles.iter().map(|_| 3.0 * random.vector()).collect();
            let after = moved(&system.respond(&constraints).unwrap(), &mesh, &offsets);
            for (&handle, &offset) in handles.iter().zip(&offsets) {
                assert!(after[handle as usize].distance(mesh.positions[handle as usize] + offset) < 1e-12);
            }
            assert!(anchors.iter().all(|&anchor| after[anchor as usize] == mesh.positions[anchor as usize]));
        }
    }
}

#[test]
fn soft_constraints_converge_to_hard_ones_with_their_weight() {
    let mesh = canonical_face();
    let system = system(&mesh, Operator::UniformSymmetric);
    let field = |kind| {
        let constraints = Constraints { handles: &[4], anchors: &[10, 152], kind, falloff: None };
        DVector::from_column_slice(system.respond(&constraints).unwrap().field(0))
    };
    let exact = field(ConstraintKind::Hard);
    let distances = [1.0, 1e2, 1e4, 1e6].map(|weight| (field(ConstraintKind::Soft { weight }) - &exact).amax());
    assert!(distances.windows(2).all(|pair| pair[1] < 0.1 * pair[0]), "{distances:?}");
}

#[test]
fn the_displacement_is_the_sum_over_handles() {
    let mesh = canonical_face();
    let random = &mut Seeded::new(2);
    for operator in Operator::ALL {
        let system = system(&mesh, operator);
        for kind in KINDS {
            let constraints = Constraints { handles: &[4, 61, 291], anchors: &[10, 152], kind, falloff: None };
            let response = system.respond(&constraints).unwrap();
            let offsets = [random.vector(), random.vector(), random.vector()];
            let together = moved(&response, &mesh, &offsets);
            let alone = [0, 1, 2].map(|k| {
                let mut only = [DVec3::ZERO; 3];
                only[k] = offsets[k];
                moved(&response, &mesh, &only)
            });
            for (vertex, &rest) in mesh.positions.iter().enumerate() {
                let sum = rest + alone.iter().map(|after| after[vertex] - rest).sum::<DVec3>();
                assert!(together[vertex].distance(sum) < 1e-12);
            }
        }
    }
}

#[test]
fn edits_commute_with_similarity_transforms() {
    let (turn, shift, scale) = (Seeded::new(8).rotation(), DVec3::new(3.0, -7.0, 2.0), 2.5);
    let map = |p: DVec3| turn * p * scale + shift;
    let offset = DVec3::new(0.3, -0.2, 0.9);
    each(|case, mesh, system, constraints| {
        let there = mesh.positions.iter().copied().map(map).collect();
        let there = Mesh { name: mesh.name, topology: mesh.topology.clone(), positions: there };
        let response = system.respond(constraints).unwrap();
        let here = moved(&response, mesh, &[offset]);
        for (before, after) in here.into_iter().zip(moved(&response, &there, &[turn * offset * scale])) {
            assert!(map(before).distance(after) < 1e-11, "{case}");
        }
    });
}

#[test]
fn components_without_a_handle_stay() {
    let mesh = crate::meshes::apart(&mut Seeded::new(1));
    let component = mesh.topology.components();
    for kind in KINDS {
        let constraints = Constraints { handles: &[0], anchors: &[3, 17], kind, falloff: None };
        let response = system(&mesh, Operator::Cotangent).respond(&constraints).unwrap();
        for (vertex, &share) in response.field(0).iter().enumerate().filter(|(v, _)| component[*v] != 0) {
            assert!(share == 0.0, "vertex {vertex} takes {share:e}");
        }
    }
}

/// Dense Cholesky solution of the normal equations, with one response field per handle.
fn by_dense_solve(mesh: &Mesh, operator: Operator, constraints: &Constraints<'_>) -> Vec<DVector<f64>> {
    let k = DMatrix::from(&operator.matrix(&mesh.topology, &mesh.positions).unwrap());
    let n = mesh.vertex_count();
    let constrained: Vec<usize> = constraints.handles.iter().chain(constraints.anchors).map(|&v| v as usize).collect();
    let mut normal = k.transpose() * &k;
    let weight = match constraints.kind {
        ConstraintKind::Soft { weight } => weight,
        ConstraintKind::Hard => 0.0,
    };
    constrained.iter().for_each(|&vertex| normal[(vertex, vertex)] += weight);
    let solve = |&handle: &u32| {
        let mut rhs = DVector::zeros(n);
        if constraints.kind != ConstraintKind::Hard {
            rhs[handle as usize] = weight;
            return normal.clone().cholesky().unwrap().solve(&rhs);
        }
        let mut system = normal.clone();
        rhs -= normal.column(handle as usize);
        for &vertex in &constrained {
            system.row_mut(vertex).fill(0.0);
            system.column_mut(vertex).fill(0.0);
            system[(vertex, vertex)] = 1.0;
            rhs[vertex] = f64::from(u8::from(vertex == handle as usize));
        }
        system.cholesky().unwrap().solve(&rhs)
    };
    constraints.handles.iter().map(solve).collect()
}

fn assert_equals_dense_solve(mesh: &Mesh, operator: Operator, constraints: &Constraints<'_>) {
    let response = system(mesh, operator).respond(constraints).unwrap();
    for (index, expected) in by_dense_solve(mesh, operator, constraints).iter().enumerate() {
        let worst = (DVector::from_column_slice(response.field(index)) - expected).amax();
        assert!(worst < 1e-10, "{operator:?}, {:?} on {}: {worst:e}", constraints.kind, mesh.name);
    }
}

#[test]
fn a_shared_factor_equals_a_dense_solve_per_constraint() {
    let random = &mut Seeded::new(77);
    for mesh in [canonical_face(), torus(12, 9)] {
        for operator in Operator::ALL {
            for kind in KINDS {
                let constrained = random.vertices(6, mesh.vertex_count());
                let (handles, anchors) = constrained.split_at(2);
                assert_equals_dense_solve(&mesh, operator, &Constraints { handles, anchors, kind, falloff: None });
            }
        }
    }
}

#[test]
fn the_gauge_vertex_may_be_a_handle_or_an_anchor() {
    let mesh = canonical_face();
    for kind in KINDS {
        for (handles, anchors) in [([0], [7, 300]), ([7], [0, 300])] {
            let constraints = Constraints { handles: &handles, anchors: &anchors, kind, falloff: None };
            assert_equals_dense_solve(&mesh, Operator::UniformSymmetric, &constraints);
        }
    }
}

#[test]
fn larger_meshes_match_the_dense_solve() {
    let mesh = plane(33, 31, &mut Seeded::new(4));
    for (operator, kind) in [(Operator::UniformSymmetric, KINDS[0]), (Operator::Cotangent, ConstraintKind::Hard)] {
        let constraints = Constraints { handles: &[500, 30], anchors: &[0, 1087, 700], kind, falloff: None };
        assert_equals_dense_solve(&mesh, operator, &constraints);
    }
}

#[test]
fn hundreds_of_anchors_match_the_dense_solve() {
    let constrained = Seeded::new(6).vertices(310, 468);
    let (handles, anchors) = constrained.split_at(3);
    for kind in KINDS {
        let constraints = Constraints { handles, anchors, kind, falloff: None };
        assert_equals_dense_solve(&canonical_face(), Operator::UniformSymmetric, &constraints);
    }
}

#[test]
fn mirrored_handles_on_a_symmetric_mesh_give_a_mirrored_displacement() {
    let mesh = canonical_face();
    let tables = golden(include_str!("../../../../tests/golden/topology.json"));
    let mirror = |vertex: u32| tables["mirror"][vertex as usize].as_u64().unwrap() as u32;
    let flip = |p: DVec3| DVec3::new(-p.x, p.y, p.z);
    let symmetric = mesh.positions.iter().enumerate();
    let symmetric = symmetric.map(|(v, &p)| 0.5 * (p + flip(mesh.positions[mirror(v as u32) as usize]))).collect();
    let mesh = Mesh { name: "symmetric face", topology: mesh.topology, positions: symmetric };
    let offset = DVec3::new(0.4, 0.7, -0.3);
    for operator in Operator::ALL {
        let system = system(&mesh, operator);
        for kind in KINDS {
            let handles = [61, mirror(61)];
            let anchors = [234, mirror(234), 10, 152];
            let response = system.respond(&Constraints { handles: &handles, anchors: &anchors, kind, falloff: None });
            let after = moved(&response.unwrap(), &mesh, &[offset, flip(offset)]);
            for vertex in 0..468 {
                let other = mirror(vertex) as usize;
                let (own, across) =
                    (after[vertex as usize] - mesh.positions[vertex as usize], after[other] - mesh.positions[other]);
                assert!(own.distance(flip(across)) < 1e-12, "{operator:?}, {kind:?}, vertex {vertex}");
            }
        }
    }
}

#[test]
fn the_papers_random_edits_leave_no_peaks() {
    let topology = face("tessellation");
    let mesh = Mesh { name: "face", topology, positions: canonical_face().positions };
    let system = system(&mesh, Operator::UniformSymmetric);
    for seed in 0..300 {
        let handle = (seed % 468) as u32;
        let anchors = random_anchors(468, &[handle], seed);
        let constraints = Constraints { handles: &[handle], anchors: &anchors, ..Default::default() };
        let after = moved(&system.respond(&constraints).unwrap(), &mesh, &[DVec3::new(0.1, 0.1, -0.1)]);
        let displacement: Vec<DVec3> = after.iter().zip(&mesh.positions).map(|(a, b)| a - b).collect();
        let peaks = rosto_laplacian::peaks(&mesh.topology, &displacement);
        assert!(peaks.is_empty(), "handle {handle}, anchors {anchors:?}: {peaks:?}");
    }
}

#[test]
fn an_anchored_system_equals_a_factor_per_choice_of_handles() {
    let mesh = canonical_face();
    let anchors: Vec<u32> = (160..460).collect();
    for operator in Operator::ALL {
        let system = system(&mesh, operator);
        for kind in KINDS {
            let under = |handles| Constraints { handles, anchors: &anchors, kind, falloff: None };
            let anchored = system.anchored(&under(&[4])).unwrap().unwrap();
            for handles in [&[4][..], &[1, 61, 152]] {
                let (shared, separate) =
                    (anchored.respond(&under(handles)).unwrap(), system.respond(&under(handles)).unwrap());
                for index in 0..handles.len() {
                    let pairs = shared.field(index).iter().zip(separate.field(index));
                    let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    assert!(apart < 1e-10, "{operator:?}, {kind:?}: {apart}");
                }
            }
        }
    }
    let few = Constraints { handles: &[4], anchors: &[10, 152], ..Constraints::default() };
    assert!(system(&mesh, Operator::Uniform).anchored(&few).unwrap().is_none());
}
