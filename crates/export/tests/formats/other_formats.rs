//! Round trips through OBJ, PLY, STL and glTF text.

use crate::common::{Glb, by_photo, face};
use glam::{DVec3, Vec3};
use rosto_export::*;
use rosto_face::Triangulation;

fn vector(bytes: &[u8]) -> Vec3 {
    Vec3::from_array([0, 4, 8].map(|at| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())))
}

#[test]
fn obj_round_trips() {
    let face = face(Triangulation::Canonical);
    let text = obj(&Model::of_face(&face)).unwrap();
    let rows = |key: &str| -> Vec<Vec<String>> {
        let matching = text.lines().filter_map(|line| line.strip_prefix(key));
        matching.map(|line| line.split(' ').map(str::to_owned).collect()).collect()
    };
    let number = |text: &String| text.parse::<f64>().unwrap();
    let vertices = rows("v ");
    for (row, (position, colour)) in vertices.iter().zip(face.positions_m().iter().zip(face.colours_srgb())) {
        assert_eq!(DVec3::new(number(&row[0]), number(&row[1]), number(&row[2])).as_vec3(), position.as_vec3());
        assert!(row[..3].iter().all(|number| number.trim_start_matches('-').len() < 20), "{row:?}");
        assert_eq!([3, 4, 5].map(|at| (number(&row[at]) * 255.0).round() as u8), *colour);
    }
    assert_eq!((vertices.len(), rows("vn ").len()), (468, 468));
    let index = |corner: &String| corner.split("//").next().unwrap().parse::<u32>().unwrap() - 1;
    let triangles: Vec<[u32; 3]> = rows("f ").iter().map(|row| [0, 1, 2].map(|at| index(&row[at]))).collect();
    assert_eq!(triangles, face.topology().triangles());
}

#[test]
fn ply_round_trips() {
    let face = face(Triangulation::Tessellation);
    let file = ply(&Model::of_face(&face)).unwrap();
    let end = b"end_header\n";
    let start = file.windows(end.len()).position(|window| window == end).unwrap() + end.len();
    let (vertices, faces) = file[start..].split_at(468 * 27);
    for (row, (position, colour)) in vertices.chunks_exact(27).zip(face.positions_m().iter().zip(face.colours_srgb())) {
        assert_eq!((vector(row), &row[24..]), (position.as_vec3(), colour.as_slice()));
        assert!((vector(&row[12..]).length() - 1.0).abs() < 1e-6);
    }
    let corner = |row: &[u8], at: usize| u32::from_le_bytes(row[1 + 4 * at..5 + 4 * at].try_into().unwrap());
    let triangles: Vec<[u32; 3]> = faces.chunks_exact(13).map(|row| [0, 1, 2].map(|at| corner(row, at))).collect();
    assert_eq!(triangles, face.topology().triangles());
}

#[test]
fn stl_has_millimetres_and_outward_normals() {
    let face = face(Triangulation::Canonical);
    let file = stl(&Model::of_face(&face)).unwrap();
    assert_eq!(u32::from_le_bytes(file[80..84].try_into().unwrap()), 898);
    assert_eq!(file.len(), 84 + 898 * 50);
    for (row, corners) in file[84..].chunks_exact(50).zip(face.topology().triangles()) {
        let at = [12, 24, 36].map(|at| vector(&row[at..]));
        let expected = corners.map(|corner| (face.positions_m()[corner as usize] * 1000.0).as_vec3());
        assert_eq!(at, expected);
        let across = (at[1] - at[0]).cross(at[2] - at[0]);
        assert!(across.length() == 0.0 || across.normalize().distance(vector(row)) < 1e-3);
    }
}

#[test]
fn gltf_text_matches_the_binary() {
    let face = face(Triangulation::Canonical);
    let model = Model::of_face(&face);
    let binary = Glb::read(&glb(&model, &by_photo()).unwrap());
    let mut text: serde_json::Value = serde_json::from_str(&gltf(&model, &by_photo()).unwrap()).unwrap();
    let uri = text["buffers"][0]["uri"].as_str().unwrap().to_owned();
    let encoded = uri.strip_prefix("data:application/octet-stream;base64,").unwrap();
    assert_eq!(encoded.len(), binary.binary.len().div_ceil(3) * 4);
    text.as_object_mut().unwrap().remove("buffers");
    let mut json = binary.json;
    json.as_object_mut().unwrap().remove("buffers");
    assert_eq!(text, json);
}

#[test]
fn non_finite_positions_are_refused_in_each_format() {
    let face = face(Triangulation::Canonical);
    let mut broken = face.positions_m().to_vec();
    broken[3].x = f64::NAN;
    let model = Model::of_face(&face).at(&broken);
    let refused = ExportError::NotFinite { vertex: 3 };
    assert_eq!(obj(&model), Err(refused.clone()));
    assert_eq!(ply(&model), Err(refused.clone()));
    assert_eq!(stl(&model), Err(refused));
}
