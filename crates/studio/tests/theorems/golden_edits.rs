//! The paper's edits, applied by the document, against a dense pseudo-inverse (`tests/golden/edits.json`).

use glam::DVec3;
use rosto_face::Triangulation;
use rosto_studio::*;
use serde_json::Value;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn vector(value: &Value) -> DVec3 {
    DVec3::from([0, 1, 2].map(|axis| value[axis].as_f64().unwrap()))
}

fn vectors(value: &Value) -> Vec<DVec3> {
    value.as_array().unwrap().iter().map(vector).collect()
}

fn vertex(value: &Value) -> u32 {
    value.as_u64().unwrap() as u32
}

#[test]
fn sequences_match_the_pseudo_inverse() {
    let golden: Value = serde_json::from_str(include_str!("../../../../tests/golden/edits.json")).unwrap();
    let cases = golden["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 8);
    for case in cases {
        let canonical = case["topology"] != "tess";
        let triangulation = if canonical { Triangulation::Canonical } else { Triangulation::Tessellation };
        let operator = if case["operator"] == "D-A" { Operator::UniformSymmetric } else { Operator::Uniform };
        let rest =
            Rest::of_landmarks(triangulation.topology(), vectors(&golden["rest_positions"]), CoordinateFrame::Other);
        let mut document = Document::new(rest).unwrap();
        for step in case["steps"].as_array().unwrap() {
            let anchors = Anchors::explicit(step["anchors"].as_array().unwrap().iter().map(vertex).collect());
            let settings = Settings { operator, anchors, ..Settings::default() };
            let spec = EditSpec { level: 0, handles: vec![vertex(&step["vertex"])], settings };
            document.apply("step", Command::Move { spec, offsets: vec![vector(&step["offset"])] }).unwrap();
        }
        let expected = vectors(&case["expected_final"]);
        let worst = document.positions().iter().zip(expected).map(|(a, b)| (*a - b).abs().max_element());
        let worst = worst.fold(0.0, f64::max);
        assert!(worst < 1e-9, "{}: off by {worst:e}", case["name"]);
    }
}
