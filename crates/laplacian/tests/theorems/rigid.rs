use glam::DVec3;
use rosto_laplacian::{ConstraintKind, Constraints, Falloff, LaplacianSystem, Operator, RigidOptions, RigidSystem};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::meshes::{Mesh, canonical_face, handle_and_anchors, plane, small};
use crate::seeded::Seeded;

const MANY_ITERATIONS: RigidOptions = RigidOptions { max_iterations: 60, tolerance: 0.0 };

fn rigid(mesh: &Mesh, operator: Operator) -> RigidSystem {
    RigidSystem::new(&mesh.topology, &mesh.positions, operator).unwrap()
}

#[test]
fn the_energy_does_not_increase_and_iterations_are_bounded() {
    for mesh in small().into_iter().chain([canonical_face()]) {
        let (handle, anchors) = handle_and_anchors(&mesh);
        for operator in Operator::ALL {
            let rigid = rigid(&mesh, operator);
            for kind in [ConstraintKind::default(), ConstraintKind::Hard] {
                let constraints = Constraints { handles: &[handle], anchors: &anchors, kind, falloff: None };
                let mut positions = mesh.positions.clone();
                let energies = rigid.constrain(&constraints).unwrap().settle(
                    &[DVec3::new(2.0, 1.0, 3.0)],
                    &MANY_ITERATIONS,
                    &mut positions,
                );
                let energies = energies.unwrap();
                assert!(energies.len() <= 61);
                let rises = energies.windows(2).any(|pair| pair[1] > pair[0] * (1.0 + 1e-12));
                assert!(!rises, "{operator:?}, {kind:?} on {}: {energies:?}", mesh.name);
            }
        }
    }
}

#[test]
fn a_zero_offset_moves_nothing() {
    for mesh in small() {
        let (handle, anchors) = handle_and_anchors(&mesh);
        let constraints = Constraints { handles: &[handle], anchors: &anchors, ..Default::default() };
        let mut positions = mesh.positions.clone();
        let edit = rigid(&mesh, Operator::Cotangent).constrain(&constraints).unwrap();
        edit.settle(&[DVec3::ZERO], &MANY_ITERATIONS, &mut positions).unwrap();
        let worst = positions.iter().zip(&mesh.positions).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        assert!(worst < 1e-12, "{}: {worst:e}", mesh.name);
    }
}

#[test]
fn rigidly_moved_handles_move_the_mesh_rigidly() {
    let mesh = canonical_face();
    let (turn, shift) = (Seeded::new(3).rotation(), DVec3::new(1.0, 2.0, 3.0));
    let turned: Vec<DVec3> = mesh.positions.iter().map(|&position| turn * position + shift).collect();
    let handles = [10, 152, 234, 454, 4, 61, 291];
    let offsets = handles.map(|handle: u32| turned[handle as usize] - mesh.positions[handle as usize]);
    for kind in [ConstraintKind::Soft { weight: 1.0 }, ConstraintKind::Hard] {
        let constraints = Constraints { handles: &handles[1..], anchors: &handles[..1], kind, falloff: None };
        // The single anchor stays, so rotate about it.
        let about = mesh.positions[handles[0] as usize];
        let turned: Vec<DVec3> = mesh.positions.iter().map(|&position| about + turn * (position - about)).collect();
        let offsets: Vec<DVec3> = offsets[1..].iter().map(|offset| *offset - offsets[0]).collect();
        let edit = rigid(&mesh, Operator::Cotangent).constrain(&constraints).unwrap();
        let mut positions = turned.clone();
        let energies = edit.settle(&offsets, &MANY_ITERATIONS, &mut positions).unwrap();
        assert!(energies[0] < 1e-20);
        assert!(positions.iter().zip(&turned).all(|(a, b)| a.distance(*b) < 1e-9));
    }
}

#[test]
fn a_bent_strip_stretches_less_than_in_a_linear_edit() {
    let mesh = plane(24, 3, &mut Seeded::new(30));
    let row = |column: u32| (0..4).map(|row| row * 25 + column).collect::<Vec<_>>();
    let (handles, anchors) = (row(24), row(0));
    let constraints = Constraints { handles: &handles, anchors: &anchors, kind: ConstraintKind::Hard, falloff: None };
    let offsets = vec![DVec3::new(-12.0, 0.0, 10.0); handles.len()];
    let mut linear = mesh.positions.clone();
    let system = LaplacianSystem::new(&mesh.topology, &mesh.positions, Operator::Cotangent).unwrap();
    system.respond(&constraints).unwrap().displace(&mesh.positions, &offsets, &mut linear);
    let mut settled = linear.clone();
    rigid(&mesh, Operator::Cotangent)
        .constrain(&constraints)
        .unwrap()
        .settle(&offsets, &MANY_ITERATIONS, &mut settled)
        .unwrap();
    let stretch = |positions: &[DVec3]| {
        let length = |at: &[DVec3], [a, b]: [u32; 2]| at[a as usize].distance(at[b as usize]);
        let squares =
            mesh.topology.edges().iter().map(|&e| (length(positions, e) / length(&mesh.positions, e)).ln().powi(2));
        squares.sum::<f64>()
    };
    assert!(stretch(&settled) < 0.2 * stretch(&linear), "{} against {}", stretch(&settled), stretch(&linear));
}

#[test]
fn hard_handles_reach_their_targets_and_vertices_outside_the_region_stay() {
    let mesh = canonical_face();
    let falloff = mesh.positions.iter().map(|p| 1.0 - p.distance(mesh.positions[4]) / 5.0).collect();
    let falloff = Falloff::new(falloff).unwrap();
    let constraints =
        Constraints { handles: &[4, 45], anchors: &[10], kind: ConstraintKind::Hard, falloff: Some(&falloff) };
    let offsets = [DVec3::new(0.5, 0.0, 1.0), DVec3::new(0.4, 0.0, 0.8)];
    let mut positions = mesh.positions.clone();
    let edit = rigid(&mesh, Operator::Cotangent).constrain(&constraints).unwrap();
    edit.settle(&offsets, &RigidOptions::default(), &mut positions).unwrap();
    assert_eq!(positions[4], mesh.positions[4] + offsets[0]);
    assert_eq!(positions[45], mesh.positions[45] + offsets[1]);
    for (vertex, _) in falloff.weights().iter().enumerate().filter(|(_, share)| **share == 0.0) {
        assert_eq!(positions[vertex], mesh.positions[vertex]);
    }
}
