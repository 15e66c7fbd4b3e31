//! The paper's edits, solved with a dense pseudo-inverse in NumPy (`tests/golden/edits.json`).

use glam::DVec3;
use rosto_laplacian::{Constraints, LaplacianSystem, Operator};
use serde_json::Value;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::golden::{face, golden, indices, points};

#[test]
fn edits_equal_the_pseudo_inverse() {
    let file = golden(include_str!("../../../../tests/golden/edits.json"));
    let rest = points(&file["rest_positions"]);
    let cases = file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 8);
    for case in cases {
        let edited = replay(case, &rest);
        let worst = edited.iter().zip(points(&case["expected_final"])).map(|(a, b)| (a - b).abs().max_element());
        let worst = worst.fold(0.0, f64::max);
        assert!(worst < 1e-9, "{}: off by {worst:e}", case["name"]);
    }
}

fn replay(case: &Value, rest: &[DVec3]) -> Vec<DVec3> {
    let topology = face(if case["topology"] == "tess" { "tessellation" } else { "canonical" });
    let operator = if case["operator"] == "D-A" { Operator::UniformSymmetric } else { Operator::Uniform };
    let system = LaplacianSystem::new(&topology, rest, operator).unwrap();
    let mut positions = rest.to_vec();
    for step in case["steps"].as_array().unwrap() {
        let handle = step["vertex"].as_u64().unwrap() as u32;
        let anchors: [u32; 2] = indices(&step["anchors"]);
        let offset = points(&Value::from(vec![step["offset"].clone()]))[0];
        let constraints = Constraints { handles: &[handle], anchors: &anchors, ..Default::default() };
        let before = positions.clone();
        system.respond(&constraints).unwrap().displace(&before, &[offset], &mut positions);
    }
    positions
}
