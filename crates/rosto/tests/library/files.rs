//! Files of a mesh: each format, and what reopening restores.

use crate::common::*;
use rosto::*;
use serde_json::Value;

/// Bytes of a format's file.
fn written(mesh: &mut FaceMesh, format: Format, options: &FileOptions) -> Vec<u8> {
    mesh.write(format, options, "face").unwrap().bytes
}

#[test]
fn a_project_restores_the_mesh_bit_for_bit() {
    let mut mesh = edited().open().unwrap();
    let project = mesh.write_project().unwrap();
    let mut again = FaceMesh::reopen(project::read(&project).unwrap().face).unwrap();
    assert_eq!(again.write_project().unwrap(), project);
    for base_colour in BaseColour::ALL {
        let options = FileOptions { base_colour, texture_size: TextureSize::Px1024, ..FileOptions::default() };
        let [first, second] = [&mut mesh, &mut again].map(|mesh| written(mesh, Format::Glb, &options));
        assert!(first == second, "{base_colour:?}");
    }
}

#[test]
fn a_glb_restores_the_face_and_its_edits() {
    let mut mesh = edited().open().unwrap();
    for base_colour in [BaseColour::Photo, BaseColour::VertexColours] {
        let options = FileOptions { base_colour, ..FileOptions::default() };
        let opened = reopen(&written(&mut mesh, Format::Glb, &options)).unwrap();
        assert!(!opened.changed_elsewhere);
        let (photos, edits) = (opened.face.photos_json(), opened.face.edits.clone());
        let mut again = FaceMesh::reopen(opened.face).unwrap();
        assert_eq!(again.positions(), mesh.positions(), "bit for bit");
        assert_eq!(again.document().history().entries(), mesh.document().history().entries());
        let second = reopen(&written(&mut again, Format::Glb, &options)).unwrap().face;
        assert_eq!((second.photos_json(), second.edits), (photos, edits), "the same texts when it is written again");
    }
}

#[test]
fn each_format_is_written() {
    let mut mesh = edited().open().unwrap();
    let start = |format: Format| -> &[u8] {
        match format {
            Format::Glb => b"glTF",
            Format::Gltf => b"{\"accessors\"",
            Format::Obj => b"# Rosto",
            Format::Ply => b"ply\n",
            Format::Stl => &[],
            Format::ThreeMf | Format::Usdz => b"PK\x03\x04",
            Format::Png => b"\x89PNG",
            Format::Json => b"{\"units\":\"mm\"",
        }
    };
    let options = FileOptions { base_colour: BaseColour::Photo, ..FileOptions::default() };
    for format in Format::ALL {
        let file = mesh.write(format, &options, "face").unwrap();
        let found = &file.bytes[..file.bytes.len().min(20)];
        assert!(found.starts_with(start(format)) && file.bytes.len() > 1000, "{format:?}: {found:?}");
        assert_eq!(file.sidecars.len(), if format == Format::Obj { 2 } else { 0 });
        assert_eq!(file.solid.is_some(), format.supports(ExportOption::Solid), "{format:?}");
    }
    assert_eq!(mesh.counts(Format::Glb, &options), [7257, 14_368]);
    let printed = |solid| mesh.printed(Print { solid, ..Print::default() }).unwrap();
    assert!(printed(Solid::FlatBack { depth_mm: None }).unwrap().body.volume_m3() > 1e-5);
    assert_eq!(printed(Solid::Surface), None);
}

fn positions(json: &[u8]) -> Vec<[f64; 3]> {
    let json: Value = serde_json::from_slice(json).unwrap();
    let rows = json["positions"].as_array().unwrap().iter();
    rows.map(|row| [0, 1, 2].map(|axis| row[axis].as_f64().unwrap())).collect()
}

#[test]
fn json_in_image_coordinates_holds_the_landmarks() {
    let cage = MeshRequest { density: 0, ..unedited() };
    let landmarks: Vec<[f64; 3]> = observation().landmarks.iter().map(|point| point.map(f64::from)).collect();
    let options = FileOptions { units: Units::Image, ..FileOptions::default() };
    let of_mm = written(&mut cage.clone().open().unwrap(), Format::Json, &options);
    assert_eq!(positions(&of_mm), landmarks);
    let of_image = MeshRequest { units: Units::Image, ..cage };
    assert_eq!(positions(&written(&mut of_image.open().unwrap(), Format::Json, &options)), landmarks);
}

#[test]
fn edits_in_image_coordinates_move_by_their_offset() {
    let mut request = MeshRequest { units: Units::Image, density: 0, ..unedited() };
    let mut settings = Settings { constraint: constraint("exact").unwrap(), ..Settings::default() };
    settings.anchors = Anchors::explicit(vec![10, 152]);
    request.add_moves([Command::move_vertex(0, 1, glam::DVec3::new(0.0, 0.0, -0.05))], &settings);
    let mesh = request.open().unwrap();
    let z = f64::from(observation().landmarks[1][2]);
    assert!((mesh.positions()[1].z - (z - 0.05)).abs() < 1e-9);
    let rest_m = mesh.face().positions_m()[1];
    assert!(mesh.landmarks_m()[1].z > rest_m.z + 0.005, "towards the camera");
}

#[test]
fn the_whole_texture_is_made_once() {
    let mut mesh = unedited().open().unwrap();
    let texture = mesh.texture(1024).unwrap().clone();
    assert_eq!([texture.width(), texture.height()], [1024; 2]);
    assert_eq!(mesh.into_texture(), Some(texture));
    let marked = Photo::from_rgb(1024, 1024, vec![7; 3 << 20]).unwrap();
    let mut given = unedited().open().unwrap().with_texture(Some(marked.clone()));
    assert_eq!(given.texture(1024).unwrap(), &marked);
    let mut bare = MeshRequest::of(vec![Observation { picture: None, ..observation() }]).open().unwrap();
    assert!(matches!(bare.texture(1024), Err(Error::Studio(_))));
}
