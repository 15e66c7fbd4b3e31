//! Reference data in `tests/golden`.

use glam::DVec3;
use rosto_mesh::Topology;
use serde_json::Value;

/// Parses a file of `tests/golden`. Callers embed the text, so that the tests also run in a browser.
pub fn golden(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

pub fn points(value: &Value) -> Vec<DVec3> {
    let point = |value: &Value| {
        let [x, y, z] = [0, 1, 2].map(|axis| value[axis].as_f64().unwrap());
        DVec3::new(x, y, z)
    };
    value.as_array().unwrap().iter().map(point).collect()
}

pub fn indices<const N: usize>(value: &Value) -> [u32; N] {
    std::array::from_fn(|k| value[k].as_u64().unwrap() as u32)
}

/// One of the two triangulations of the face's 468 landmarks, `"tessellation"` or `"canonical"`.
pub fn face(triangulation: &str) -> Topology {
    let tables = golden(include_str!("../../../../tests/golden/topology.json"));
    let triangles = tables[format!("triangles_{triangulation}")].as_array().unwrap().iter().map(indices).collect();
    Topology::new(468, triangles).unwrap()
}
