use glam::DVec3;
use rosto_laplacian::{Distortion, LaplacianSystem, Operator, peaks};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::meshes::{Mesh, plane, small};
use crate::seeded::Seeded;

fn measure(mesh: &Mesh, after: &[DVec3]) -> Distortion {
    let system = LaplacianSystem::new(&mesh.topology, &mesh.positions, Operator::UniformSymmetric).unwrap();
    Distortion::measure(&mesh.topology, &system, &mesh.positions, after)
}

#[test]
fn a_translated_mesh_is_not_distorted() {
    for mesh in small() {
        let after: Vec<DVec3> = mesh.positions.iter().map(|&position| position + DVec3::new(3.0, 1.0, 2.0)).collect();
        let bent = measure(&mesh, &after);
        assert!(bent.delta_change.iter().all(|change| *change < 1e-12));
        assert!(bent.edge_stretch.iter().chain(&bent.area_ratio).all(|ratio| (ratio - 1.0).abs() < 1e-12));
        assert!(bent.flipped.is_empty() && bent.peaks.is_empty());
    }
}

#[test]
fn scaling_stretches_edges_by_the_scale_and_areas_by_its_square() {
    for mesh in small() {
        let after: Vec<DVec3> = mesh.positions.iter().map(|&position| 2.0 * position).collect();
        let summary = measure(&mesh, &after).summary();
        assert!(
            (summary.least_stretch.value - 2.0).abs() < 1e-12 && (summary.greatest_stretch.value - 2.0).abs() < 1e-12
        );
        assert!((summary.least_area.value - 4.0).abs() < 1e-12 && (summary.greatest_area.value - 4.0).abs() < 1e-12);
        assert_eq!(summary.flipped, (0, mesh.topology.triangles().len()));
    }
}

#[test]
fn moving_one_vertex_changes_its_delta_and_its_neighbours() {
    let mesh = plane(6, 6, &mut Seeded::new(2));
    let mut after = mesh.positions.clone();
    after[24] += DVec3::new(0.0, 0.0, 2.0);
    let bent = measure(&mesh, &after);
    assert_eq!(bent.peaks.iter().map(|peak| (peak.vertex, peak.share)).collect::<Vec<_>>(), [(24, 0.0)]);
    assert_eq!(bent.summary().delta_change.index, 24);
    assert!((bent.delta_change[24] - 2.0 * mesh.topology.degree(24) as f64).abs() < 1e-12);
    for vertex in (0..49).filter(|&vertex| vertex != 24) {
        let expected = if mesh.topology.neighbours(24).contains(&vertex) { 2.0 } else { 0.0 };
        assert!((bent.delta_change[vertex as usize] - expected).abs() < 1e-12);
    }
}

#[test]
fn a_vertex_moved_past_its_one_ring_flips_triangles() {
    let mesh = plane(6, 6, &mut Seeded::new(2));
    let mut after = mesh.positions.clone();
    after[24] += DVec3::new(2.5, 0.0, 0.0);
    let bent = measure(&mesh, &after);
    assert!(!bent.flipped.is_empty());
    assert!(bent.flipped.iter().all(|&triangle| mesh.topology.triangles()[triangle as usize].contains(&24)));
    assert_eq!(bent.summary().flipped.0, bent.flipped.len());
}

#[test]
fn a_steep_rise_is_a_peak_and_a_gradual_one_is_not() {
    let mesh = plane(12, 12, &mut Seeded::new(5));
    let hill = |steepness: f64| {
        let lift = |p: &DVec3| DVec3::new(0.0, 0.0, (-steepness * p.distance_squared(mesh.positions[84])).exp());
        mesh.positions.iter().map(lift).collect::<Vec<DVec3>>()
    };
    assert!(peaks(&mesh.topology, &hill(0.1)).is_empty());
    assert_eq!(peaks(&mesh.topology, &hill(3.0)).iter().map(|peak| peak.vertex).collect::<Vec<_>>(), [84]);
}

#[test]
fn summary_display() {
    let mesh = plane(6, 6, &mut Seeded::new(2));
    let after: Vec<DVec3> = mesh.positions.iter().map(|&position| 2.0 * position).collect();
    let text = measure(&mesh, &after).summary().to_string();
    assert!(
        text.starts_with("edges are 2.00 to 2.00 times as long, triangles 4.00 to 4.00 times as large; "),
        "{text}"
    );
    assert!(text.contains("0 of 72 triangles flipped, 0 isolated peaks"), "{text}");
}
