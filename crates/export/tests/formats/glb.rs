//! Contents of exported GLB files.

use crate::common::{Glb, SIDE, by_photo, edits, face, gradient, model};
use glam::DVec3;
use rosto_export::*;
use rosto_face::Triangulation;

#[test]
fn positions_match_the_model_with_exact_bounds() {
    let face = face(Triangulation::Canonical);
    let file = Glb::read(&glb(&Model::of_face(&face), &by_photo()).unwrap());
    let accessor = file.attribute("POSITION");
    let positions = file.floats::<3>(accessor);
    let expected: Vec<[f32; 3]> = face.positions_m().iter().map(|p| p.as_vec3().to_array()).collect();
    assert_eq!(positions, expected);
    for axis in 0..3 {
        let low = positions.iter().map(|p| p[axis]).fold(f32::INFINITY, f32::min);
        let high = positions.iter().map(|p| p[axis]).fold(f32::NEG_INFINITY, f32::max);
        let bounds = &file.json["accessors"][accessor];
        assert_eq!(bounds["min"][axis].as_f64().unwrap(), f64::from(low));
        assert_eq!(bounds["max"][axis].as_f64().unwrap(), f64::from(high));
    }
}

#[test]
fn normals_have_unit_length_and_face_the_viewer() {
    let face = face(Triangulation::Canonical);
    let file = Glb::read(&glb(&Model::of_face(&face), &by_photo()).unwrap());
    let normals = file.floats::<3>(file.attribute("NORMAL"));
    assert!(normals.iter().all(|n| (glam::Vec3::from(*n).length() - 1.0).abs() < 1e-6));
    assert!(normals[4][2] > 0.5, "the nose tip faces +Z");
}

#[test]
fn indices_match_the_triangles_and_ids_the_landmarks() {
    let face = face(Triangulation::Tessellation);
    let file = Glb::read(&glb(&Model::of_face(&face), &by_photo()).unwrap());
    let accessor = file.json["meshes"][0]["primitives"][0]["indices"].as_u64().unwrap() as usize;
    let view = file.json["accessors"][accessor]["bufferView"].as_u64().unwrap() as usize;
    let corner = |bytes: &[u8]| u32::from(u16::from_le_bytes(bytes.try_into().unwrap()));
    let corners: Vec<u32> = file.view(view).chunks_exact(2).map(corner).collect();
    assert_eq!(corners, face.topology().triangles().concat());
    let ids = file.floats::<1>(file.attribute("_LANDMARK_ID"));
    assert!(ids.iter().enumerate().all(|(vertex, &[id])| id == vertex as f32));
}

#[test]
fn texture_colours_match_the_photo_at_each_landmark() {
    let face = face(Triangulation::Canonical);
    let file = Glb::read(&glb(&Model::of_face(&face), &by_photo()).unwrap());
    let view = file.json["images"][0]["bufferView"].as_u64().unwrap() as usize;
    let crop = rosto_photo::decode(file.view(view), &rosto_photo::Limits::default()).unwrap();
    assert!(crop.width().is_power_of_two() && crop.height().is_power_of_two());
    assert!(crop.width() < SIDE, "the photo is cropped");
    let photo = gradient();
    for (uv, image) in file.floats::<2>(file.attribute("TEXCOORD_0")).iter().zip(face.uvs()) {
        let textured = crop.colour_under(uv[0].into(), uv[1].into());
        let photographed = photo.colour_under(image.x, image.y);
        let worst = textured.iter().zip(photographed).map(|(a, b)| a.abs_diff(b)).max().unwrap();
        assert!(worst <= 6, "{textured:?} for {photographed:?} at {image}");
    }
}

#[test]
fn a_face_larger_than_the_texture_is_scaled_down() {
    let face = face(Triangulation::Canonical);
    let options = GlbOptions { max_texture_px: 64, ..by_photo() };
    let file = Glb::read(&glb(&Model::of_face(&face), &options).unwrap());
    let view = file.json["images"][0]["bufferView"].as_u64().unwrap() as usize;
    let crop = rosto_photo::decode(file.view(view), &rosto_photo::Limits::default()).unwrap();
    assert!(crop.width() <= 64 && crop.height() <= 64);
    let photo = gradient();
    for (uv, image) in file.floats::<2>(file.attribute("TEXCOORD_0")).iter().zip(face.uvs()) {
        let textured = crop.colour_under(uv[0].into(), uv[1].into());
        let photographed = photo.colour_under(image.x, image.y);
        // A pixel of the smaller picture spans five levels of the gradient.
        let worst = textured.iter().zip(photographed).map(|(a, b)| a.abs_diff(b)).max().unwrap();
        assert!(worst <= 10, "{textured:?} for {photographed:?} at {image}");
    }
}

#[test]
fn the_whole_face_texture_is_not_cropped() {
    let face = face(Triangulation::Canonical);
    let model = model(&face);
    let whole = model.whole.unwrap();
    let file = Glb::read(&glb(&model, &GlbOptions::default()).unwrap());
    assert_eq!(file.json["images"].as_array().unwrap().len(), 1, "programs may drop an unused image");
    let view = file.json["images"][0]["bufferView"].as_u64().unwrap() as usize;
    let texture = rosto_photo::decode(file.view(view), &rosto_photo::Limits::default()).unwrap();
    assert_eq!((texture.width(), texture.height()), (whole.pixels.width(), whole.pixels.height()));
    for (uv, expected_uv) in file.floats::<2>(file.attribute("TEXCOORD_0")).iter().zip(whole.uvs) {
        assert_eq!(*uv, expected_uv.as_vec2().to_array());
        let (found, expected) = (
            texture.colour_under(expected_uv.x, expected_uv.y),
            whole.pixels.colour_under(expected_uv.x, expected_uv.y),
        );
        assert!(found.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= 8), "{found:?} for {expected:?}");
    }
    let smaller = GlbOptions { max_texture_px: 128, ..GlbOptions::default() };
    let file = Glb::read(&glb(&model, &smaller).unwrap());
    let texture = rosto_photo::decode(file.view(view), &rosto_photo::Limits::default()).unwrap();
    assert_eq!(texture.width(), 128);
}

#[test]
fn vertex_colours_are_linear_and_exclude_the_texture() {
    let face = face(Triangulation::Canonical);
    let options = GlbOptions { base_colour: BaseColour::VertexColours, ..GlbOptions::default() };
    let file = Glb::read(&glb(&Model::of_face(&face), &options).unwrap());
    assert!(file.json.get("images").is_none() && file.json.get("textures").is_none());
    assert!(file.json["meshes"][0]["primitives"][0]["attributes"].get("TEXCOORD_0").is_none());
    let accessor = &file.json["accessors"][file.attribute("COLOR_0")];
    assert_eq!((accessor["normalized"].as_bool(), accessor["componentType"].as_u64()), (Some(true), Some(5123)));
    let stored = file.view(accessor["bufferView"].as_u64().unwrap() as usize);
    let channel = |at: usize| u16::from_le_bytes(stored[at * 2..at * 2 + 2].try_into().unwrap());
    for (vertex, colour) in face.colours_srgb().iter().enumerate() {
        let linear = colour.map(|c| (linear_from_srgb(c) * 65535.0).round() as u16);
        assert_eq!([0, 1, 2].map(|axis| channel(vertex * 4 + axis)), linear);
        assert_eq!(channel(vertex * 4 + 3), u16::MAX);
    }
}

#[test]
fn linear_from_srgb_matches_the_standard() {
    assert_eq!((linear_from_srgb(0), linear_from_srgb(255)), (0.0, 1.0));
    assert!((linear_from_srgb(188) - 0.5029).abs() < 1e-4);
}

#[test]
fn morph_targets_source_and_unlit_material_are_exported() {
    let face = face(Triangulation::Canonical);
    let wider = vec![DVec3::X * 0.01; 468];
    let morphs = [Morph { name: "jaw wider", displacements_m: &wider, weight: 0.5 }];
    let edits = edits(&face, Some(r#"{"version":1}"#));
    let options = GlbOptions {
        material: Material::Unlit,
        morphs: &morphs,
        source: Some(Source { face: &face, edits: &edits }),
        ..by_photo()
    };
    let file = Glb::read(&glb(&Model::of_face(&face), &options).unwrap());
    assert_eq!(file.json["meshes"][0]["extras"]["targetNames"][0], "jaw wider");
    assert_eq!(file.json["meshes"][0]["weights"][0], 0.5);
    assert_eq!(file.json["scenes"][0]["extras"]["history"]["version"], 1);
    assert_eq!(file.json["extensionsUsed"][0], "KHR_materials_unlit");
    let target = file.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"].as_u64().unwrap() as usize;
    assert!(file.floats::<3>(target).iter().all(|d| *d == [0.01, 0.0, 0.0]));
}

#[test]
fn invalid_models_are_refused() {
    let face = face(Triangulation::Canonical);
    let model = Model::of_face(&face);
    let photo = model.photo.unwrap();
    let few = Picture { uvs: &photo.uvs[..7], ..photo };
    let expected = |what| ExportError::LengthMismatch { what, expected: 468, found: 7 };
    let short = Model { photo: Some(few), ..model };
    assert_eq!(glb(&short, &by_photo()), Err(expected("UVs")));
    let short = Model { whole: Some(few), ..model };
    assert_eq!(glb(&short, &by_photo()), Err(expected("UVs of the whole texture")));
    let short = model.at(&face.positions_m()[..5]);
    let expected = ExportError::LengthMismatch { what: "positions", expected: 468, found: 5 };
    assert_eq!(glb(&short, &by_photo()), Err(expected));
    let mut far = face.positions_m().to_vec();
    far[7].y = 1e300;
    assert_eq!(glb(&model.at(&far), &by_photo()), Err(ExportError::NotFinite { vertex: 7 }));
    assert_eq!(glb(&model, &GlbOptions::default()), Err(ExportError::NoWholePicture));
    assert_eq!(glb(&Model { photo: None, ..model }, &by_photo()), Err(ExportError::NoPicture));
    let edits = edits(&face, Some("[1]"));
    let list = GlbOptions { source: Some(Source { face: &face, edits: &edits }), ..by_photo() };
    assert_eq!(glb(&model, &list), Err(ExportError::HistoryNotAnObject));
}
