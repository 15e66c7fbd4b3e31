//! Loop subdivision of the canonical face.
#![allow(clippy::unwrap_used, reason = "a failed set-up fails the test")]

use glam::DVec3;
use rosto_mesh::{LoopSubdivision, Topology};
use serde_json::Value;

fn canonical_face() -> (Topology, Vec<DVec3>) {
    let tables: Value = serde_json::from_str(include_str!("../../../tests/golden/topology.json")).unwrap();
    let corners = |t: &Value| [0, 1, 2].map(|k| t[k].as_u64().unwrap() as u32);
    let point = |p: &Value| DVec3::from([0, 1, 2].map(|k| p[k].as_f64().unwrap()));
    let triangles = tables["triangles_canonical"].as_array().unwrap().iter().map(corners).collect();
    let positions = tables["vertices"].as_array().unwrap().iter().map(point).collect();
    (Topology::new(468, triangles).unwrap(), positions)
}

#[test]
fn vertex_counts_of_three_levels() {
    let (cage, _) = canonical_face();
    let counts = [0, 1, 2, 3].map(|levels| LoopSubdivision::new(&cage, levels).topology().vertex_count());
    assert_eq!(counts, [468, 1833, 7257, 28_881]);
}

#[test]
fn the_dense_face_stays_within_a_few_millimetres_of_its_cage() {
    let (cage, positions) = canonical_face();
    let dense = LoopSubdivision::new(&cage, 2).apply(&positions);
    let furthest = positions.iter().zip(&dense).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    assert!(furthest < 0.6, "the canonical face is in centimetres; a vertex moved by {furthest}");
}

#[test]
fn apply_to_equals_apply() {
    let (cage, positions) = canonical_face();
    let dense = LoopSubdivision::new(&cage, 3);
    let mut out = vec![DVec3::ZERO; dense.topology().vertex_count()];
    dense.apply_to(&positions, &mut out);
    assert_eq!(out, dense.apply(&positions));
}
