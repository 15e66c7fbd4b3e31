//! The JSON mesh is lossless.

use glam::DVec3;
use rosto_export::*;

#[test]
fn numbers_round_trip_to_the_same_f64() {
    let positions = [
        DVec3::new(0.1 + 0.2, -1.0 / 3.0, 1e-300),
        DVec3::new(-0.0, 1e22, f64::MIN_POSITIVE),
        DVec3::new(123456789.12345679, 5e-324, f64::MAX),
    ];
    let mesh = JsonMesh {
        units: Units::Image,
        positions: &positions,
        colours_srgb: &[[0, 128, 255], [1, 2, 3], [4, 5, 6]],
        triangles: &[[0, 1, 2]],
        about: None,
    };
    let read: serde_json::Value = serde_json::from_str(&mesh_json(&mesh)).unwrap();
    for (vertex, position) in positions.iter().enumerate() {
        for axis in 0..3 {
            assert_eq!(read["positions"][vertex][axis].as_f64().unwrap().to_bits(), position[axis].to_bits());
        }
    }
    assert_eq!(read["units"], "image");
    assert_eq!(read["colours"], serde_json::json!([[0, 128, 255], [1, 2, 3], [4, 5, 6]]));
    assert_eq!(read["triangles"], serde_json::json!([[0, 1, 2]]));
}
