use glam::DVec3;
use rosto_laplacian::{ConstraintKind, Constraints, Falloff, Geodesics, LaplacianSystem, Operator};
use rosto_mesh::{LoopSubdivision, Topology};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::meshes::{Mesh, apart, canonical_face, plane};
use crate::seeded::Seeded;

fn distances(mesh: &Mesh, sources: &[u32]) -> Vec<f64> {
    Geodesics::new(&mesh.topology, &mesh.positions).unwrap().distances(sources).unwrap()
}

#[test]
fn on_a_plane_distances_are_euclidean() {
    let mesh = plane(40, 40, &mut Seeded::new(12));
    let centre = 20 * 41 + 20;
    for (vertex, &found) in distances(&mesh, &[centre]).iter().enumerate() {
        let straight = mesh.positions[vertex].distance(mesh.positions[centre as usize]);
        assert!((found - straight).abs() < 0.05 * straight + 0.25, "vertex {vertex}: {found} for {straight}");
    }
}

#[test]
fn on_a_bent_sheet_distances_follow_the_surface() {
    // A sheet rolled into a half cylinder keeps its intrinsic distances.
    let mut mesh = plane(40, 12, &mut Seeded::new(9));
    let flat = mesh.positions.clone();
    let radius = 40.0 / std::f64::consts::PI;
    for position in &mut mesh.positions {
        let (sin, cos) = (position.x / radius).sin_cos();
        *position = DVec3::new(radius * cos, position.y, radius * sin);
    }
    let (start, end) = (6 * 41, 6 * 41 + 40);
    let found = distances(&mesh, &[start])[end as usize];
    let rolled_out = flat[start as usize].distance(flat[end as usize]);
    assert!((found / rolled_out - 1.0).abs() < 0.03, "{found} for {rolled_out}");
    assert!(found > 1.4 * mesh.positions[start as usize].distance(mesh.positions[end as usize]));
}

#[test]
fn on_a_dense_face_distances_lie_between_straight_lines_and_edge_paths() {
    let cage = canonical_face();
    let dense = LoopSubdivision::new(&cage.topology, 2);
    let mesh = Mesh { name: "dense face", topology: dense.topology().clone(), positions: dense.apply(&cage.positions) };
    let along_edges = shortest_along_edges(&mesh, 4);
    for (vertex, &found) in distances(&mesh, &[4]).iter().enumerate() {
        let straight = mesh.positions[vertex].distance(mesh.positions[4]);
        assert!(found >= straight * (1.0 - 1e-12), "vertex {vertex}: {found} under {straight}");
        assert!(found < 1.05 * along_edges[vertex] + 0.1, "vertex {vertex}: {found} over {}", along_edges[vertex]);
    }
}

/// Shortest paths along edges, by the Bellman–Ford algorithm.
fn shortest_along_edges(mesh: &Mesh, source: usize) -> Vec<f64> {
    let mut distance = vec![f64::INFINITY; mesh.vertex_count()];
    distance[source] = 0.0;
    let mut changed = true;
    while std::mem::take(&mut changed) {
        for &[a, b] in mesh.topology.edges() {
            let [a, b] = [a as usize, b as usize];
            let length = mesh.positions[a].distance(mesh.positions[b]);
            for (from, to) in [(a, b), (b, a)] {
                if distance[from] + length < distance[to] {
                    distance[to] = distance[from] + length;
                    changed = true;
                }
            }
        }
    }
    distance
}

#[test]
fn distances_scale_with_the_mesh() {
    let mesh = canonical_face();
    let near = distances(&mesh, &[4]);
    for scale in [1e-150, 1e-3, 1e3, 1e150] {
        let positions = mesh.positions.iter().map(|&p| p * scale).collect();
        let scaled = Mesh { name: "scaled", topology: mesh.topology.clone(), positions };
        for (one, other) in near.iter().zip(distances(&scaled, &[4])) {
            assert!((one - other / scale).abs() < 1e-9);
        }
    }
}

#[test]
fn distances_are_infinite_in_components_without_a_source() {
    let mesh = apart(&mut Seeded::new(1));
    let found = distances(&mesh, &[0, 15]);
    let component = mesh.topology.components();
    assert_eq!((found[0], found[15]), (0.0, 0.0));
    for vertex in 0..mesh.vertex_count() {
        assert_eq!(found[vertex].is_finite(), component[vertex] == 0);
    }
}

#[test]
fn without_sources_distances_are_infinite() {
    assert!(distances(&canonical_face(), &[]).iter().all(|distance| distance.is_infinite()));
}

#[test]
fn a_region_falls_smoothly_from_one_to_zero() {
    let along: Vec<f64> = (0..=1000).map(|k| f64::from(k) / 500.0).collect();
    let falloff = Falloff::within(1.5, &along).unwrap();
    let weights = falloff.weights();
    assert_eq!(weights[0], 1.0);
    assert!(weights[750..].iter().all(|&share| share == 0.0));
    assert!(weights.windows(2).all(|pair| pair[0] >= pair[1] && pair[0] - pair[1] < 0.0026));
    assert!(weights[749] < 1e-6 && weights[1] > 1.0 - 1e-6);
}

#[test]
fn vertices_outside_the_region_stay_and_hard_handles_reach_their_targets() {
    let mesh = canonical_face();
    let along = distances(&mesh, &[4]);
    let falloff = Falloff::within(4.0, &along).unwrap();
    let other = (0..468).find(|&v| (1.0..2.0).contains(&along[v as usize])).unwrap();
    for operator in Operator::ALL {
        let system = LaplacianSystem::new(&mesh.topology, &mesh.positions, operator).unwrap();
        let handles = [4, other];
        let constraints =
            Constraints { handles: &handles, anchors: &[10], kind: ConstraintKind::Hard, falloff: Some(&falloff) };
        let response = system.respond(&constraints).unwrap();
        let mut after = mesh.positions.clone();
        let offsets = [DVec3::new(0.0, 0.5, 1.0), DVec3::new(0.2, 0.0, 0.4)];
        response.displace(&mesh.positions, &offsets, &mut after);
        for vertex in (0..468).filter(|&vertex| along[vertex] >= 4.0) {
            assert_eq!(after[vertex], mesh.positions[vertex]);
        }
        for (&handle, &offset) in handles.iter().zip(&offsets) {
            assert!(after[handle as usize].distance(mesh.positions[handle as usize] + offset) < 1e-12);
        }
    }
}

#[test]
fn degenerate_triangles_have_finite_distances() {
    let topology = Topology::new(4, vec![[0, 1, 2], [1, 3, 2]]).unwrap();
    let positions = [0.0, 1.0, 2.0, 3.0].map(|x| DVec3::new(x, 0.0, 0.0));
    let found = Geodesics::new(&topology, &positions).unwrap().distances(&[0]).unwrap();
    assert!(found.iter().all(|distance| distance.is_finite()));
}
