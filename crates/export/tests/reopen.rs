//! A GLB opened again: what went in comes out, and nothing of a stranger's file is trusted.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use base64::prelude::{BASE64_STANDARD, Engine};
use common::{Glb, SIDE, face, gradient, model, source};
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use proptest::prelude::*;
use rosto_export::*;
use rosto_face::{FaceInput, FaceModel, Triangulation};

const HISTORY: &str = r#"{"entries":[0.1,"é"],"version":1}"#;

/// A PNG file up to its size.
const PNG_START: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR";

fn file(triangulation: Triangulation, base_colour: BaseColour) -> Vec<u8> {
    let face = face(triangulation);
    let source = Some(Source { density: 2, ..source(&face, Some(HISTORY)) });
    glb(&model(&face), &GlbOptions { base_colour, source, ..GlbOptions::default() }).unwrap()
}

#[test]
fn the_face_comes_back_as_it_was_saved() {
    for triangulation in [Triangulation::Tessellation, Triangulation::Canonical] {
        for base_colour in BaseColour::ALL {
            let saved = face(triangulation);
            let bytes = file(triangulation, base_colour);
            let opened = reopen(&bytes).unwrap();
            assert_eq!((opened.triangulation, opened.density), (triangulation, 2));
            assert_eq!(opened.history.as_deref(), Some(HISTORY));
            assert_eq!(opened.further, None, "one photo");
            assert_eq!(opened.texture.is_some(), base_colour != BaseColour::VertexColours);
            let [width, height] = opened.photo_size_px;
            let input = FaceInput {
                landmarks: &opened.landmarks,
                width,
                height,
                colours: &opened.colours_srgb,
                picture: gradient(),
                lens: opened.lens,
            };
            let again = FaceModel::new(input, opened.triangulation).unwrap();
            assert_eq!(again.positions_m(), saved.positions_m(), "to the last bit");
            assert_eq!(again.positions_image(), saved.positions_image());
            assert_eq!(again.colours_srgb(), saved.colours_srgb());
        }
    }
}

#[test]
fn the_texture_lies_where_it_was_cut_out() {
    for base_colour in [BaseColour::Photo, BaseColour::Whole] {
        let bytes = file(Triangulation::Canonical, base_colour);
        let texture = reopen(&bytes).unwrap().texture.unwrap();
        assert_eq!(texture.picture_size_px, [SIDE, SIDE]);
        let crop = rosto_photo::decode(&texture.encoded, &rosto_photo::Limits::default()).unwrap();
        let photo = gradient();
        let [left, top] = texture.at_px.map(|at| u32::try_from(at).unwrap());
        for (x, y) in [(0, 0), (crop.width() / 2, crop.height() / 3), (crop.width() - 1, crop.height() - 1)] {
            let [found, cut] = [crop.pixel(x, y), photo.pixel(left + x, top + y)];
            assert!(found.iter().zip(cut).all(|(a, b)| a.abs_diff(b) <= 6), "{found:?} at {x}, {y} for {cut:?}");
        }
    }
}

#[test]
fn a_part_of_the_photo_that_is_no_picture_of_a_size_that_can_be_held_is_refused() {
    let bytes = file(Triangulation::Canonical, BaseColour::Whole);
    let jpeg = Glb::read(&bytes).json["scenes"][0]["extras"]["picture"]["jpeg"].as_str().unwrap().to_owned();
    let png = |side: u32| [PNG_START, &side.to_be_bytes(), &side.to_be_bytes()].concat();
    for (other, opens) in [
        ("", false),
        ("***", false),
        (&*BASE64_STANDARD.encode(png(9000)), false),
        (&*BASE64_STANDARD.encode(png(9)), true),
    ] {
        let damaged = with_json(&bytes, |json| json.replace(&jpeg, other));
        let expected = Err(ReopenError::Field { field: "picture" });
        assert_eq!(reopen(&damaged).map(|_| ()), if opens { Ok(()) } else { expected }, "{other}");
    }
}

#[test]
fn without_a_photo_the_colours_are_painted_where_the_face_is() {
    let bytes = file(Triangulation::Canonical, BaseColour::VertexColours);
    let opened = reopen(&bytes).unwrap();
    let picture = opened.painted();
    assert_eq!((picture.width, picture.height), (SIDE, SIDE));
    let pixel = |x: f32, y: f32| {
        let at = ((y * SIDE as f32) as usize * SIDE as usize + (x * SIDE as f32) as usize) * 4;
        <[u8; 4]>::try_from(&picture.rgba[at..at + 4]).unwrap()
    };
    let [x, y, _] = opened.landmarks[1];
    let [red, green, blue, alpha] = pixel(x, y);
    let nose = [red, green, blue].iter().zip(opened.colours_srgb[1]).map(|(a, b)| a.abs_diff(b)).max().unwrap();
    assert!(nose <= 3 && alpha == u8::MAX, "{nose} levels off at the nose tip");
    assert_eq!(pixel(0.0, 0.0), [0; 4], "nothing beside the face");
}

#[test]
fn a_file_of_another_program_or_version_is_refused() {
    let with_extras = |extras: &str| {
        let json = format!(r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"extras":{extras}}}]}}"#);
        let json = format!("{json:<width$}", width = json.len().next_multiple_of(4));
        let lengths = [20 + json.len() as u32, json.len() as u32].map(u32::to_le_bytes);
        [b"glTF".as_slice(), &2u32.to_le_bytes(), &lengths[0], &lengths[1], b"JSON", json.as_bytes()].concat()
    };
    assert_eq!(reopen(&with_extras("{}")), Err(ReopenError::Foreign));
    assert_eq!(reopen(&with_extras(r#"{"rosto":"history","version":1}"#)), Err(ReopenError::Foreign));
    let other = with_extras(r#"{"rosto":"face","version":2}"#);
    assert_eq!(reopen(&other), Err(ReopenError::Version { found: 2, known: 1 }));
    let empty = with_extras(r#"{"rosto":"face","version":1}"#);
    assert_eq!(reopen(&empty), Err(ReopenError::Field { field: "landmarks" }));
    assert_eq!(reopen(b"a photo, perhaps"), Err(ReopenError::NotGlb));
}

#[test]
fn a_file_that_ends_too_early_is_refused_wherever_it_ends() {
    let bytes = file(Triangulation::Tessellation, BaseColour::Photo);
    for end in (0..bytes.len()).step_by(61).chain(0..64) {
        assert!(reopen(&bytes[..end]).is_err(), "opened with {end} of {} bytes", bytes.len());
    }
}

#[test]
fn places_outside_the_file_and_pictures_too_large_to_hold_are_refused() {
    let bytes = file(Triangulation::Tessellation, BaseColour::Photo);
    let view = Glb::read(&bytes).json["images"][0]["bufferView"].as_u64().unwrap();
    let length = Glb::read(&bytes).json["bufferViews"][view as usize]["byteLength"].as_u64().unwrap();
    for (from, to) in [
        (format!("\"byteLength\":{length}"), "\"byteLength\":9999999"),
        (format!("\"size_px\":[{SIDE},{SIDE}]"), "\"size_px\":[99999,99]"),
        (format!("\"size_px\":[{SIDE},{SIDE}]"), "\"size_px\":[0,99]"),
    ] {
        let damaged = with_json(&bytes, |json| json.replace(&from, to));
        assert_eq!(reopen(&damaged), Err(ReopenError::Field { field: "picture" }), "{to}");
    }
}

#[test]
fn a_texture_that_was_halved_elsewhere_still_tells_how_large_it_is_in_the_picture() {
    let bytes = file(Triangulation::Canonical, BaseColour::Photo);
    let whole = reopen(&bytes).unwrap().texture.unwrap();
    let crop = rosto_photo::decode(&whole.encoded, &rosto_photo::Limits::default()).unwrap();
    assert_eq!(whole.size_px, [crop.width(), crop.height()]);
    let halved = with_texture(&bytes, &halved(&crop));
    let opened = reopen(&halved).unwrap();
    let texture = opened.texture.unwrap();
    assert_ne!(texture.encoded.len(), whole.encoded.len());
    assert_eq!((texture.size_px, texture.at_px), (whole.size_px, whole.at_px));
    assert!(!opened.changed_elsewhere, "the mesh is the same");
}

#[test]
fn a_mesh_that_was_changed_elsewhere_says_so() {
    for base_colour in BaseColour::ALL {
        let bytes = file(Triangulation::Canonical, base_colour);
        assert!(!reopen(&bytes).unwrap().changed_elsewhere);
        let glb = Glb::read(&bytes);
        let view = glb.json["accessors"][glb.attribute("POSITION")]["bufferView"].as_u64().unwrap() as usize;
        let start = glb.json["bufferViews"][view]["byteOffset"].as_u64().unwrap() as usize;
        let mut moved = bytes.clone();
        let at = bytes.len() - glb.binary.len() + start + 4;
        let y = f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        moved[at..at + 4].copy_from_slice(&(y + 0.01).to_le_bytes());
        assert!(reopen(&moved).unwrap().changed_elsewhere);
    }
}

#[test]
fn a_mesh_that_was_only_stored_otherwise_is_unchanged() {
    let bytes = file(Triangulation::Canonical, BaseColour::VertexColours);
    let glb = Glb::read(&bytes);
    let positions = glb.floats::<3>(glb.attribute("POSITION"));
    // Each position between two other numbers, at the end of the file, as programs do that interleave.
    let mut binary = glb.binary.clone();
    let start = binary.len();
    for [x, y, z] in positions {
        binary.extend([9.0, x, y, z, 9.0].into_iter().flat_map(f32::to_le_bytes));
    }
    let mut json = glb.json.clone();
    let views = json["bufferViews"].as_array_mut().unwrap();
    views.push(serde_json::json!({"buffer": 0, "byteOffset": start, "byteLength": 468 * 20, "byteStride": 20}));
    let view = views.len() - 1;
    let accessor = &mut json["accessors"][glb.attribute("POSITION")];
    accessor["bufferView"] = view.into();
    accessor["byteOffset"] = 4.into();
    assert!(!reopen(&assembled(json.to_string(), &binary)).unwrap().changed_elsewhere);
}

#[test]
fn what_could_not_be_opened_is_refused() {
    let bytes = file(Triangulation::Canonical, BaseColour::VertexColours);
    let landmarks = Glb::read(&bytes).json["scenes"][0]["extras"]["landmarks"].as_str().unwrap().to_owned();
    let zeros = "A".repeat(landmarks.len());
    let sizes = format!("\"photo_px\":[{SIDE},{SIDE}]");
    for (from, to, field) in [
        (landmarks.as_str(), zeros.as_str(), "landmarks"),
        ("\"lens\"", "\"_\"", "lens"),
        (sizes.as_str(), "\"photo_px\":[0,300]", "photo_px"),
        ("\"density\":2", "\"density\":5", "density"),
        (HISTORY, "null", "history"),
    ] {
        let wrong = with_json(&bytes, |json| json.replace(from, to));
        assert_eq!(reopen(&wrong), Err(ReopenError::Field { field }), "{field}");
    }
}

/// A picture of half the size as PNG, as a program writes it that makes textures smaller.
fn halved(picture: &rosto_photo::Photo) -> Vec<u8> {
    let half = picture.scaled_down(picture.width().max(picture.height()) / 2);
    let mut file = Vec::new();
    PngEncoder::new(&mut file)
        .write_image(half.pixels(), half.width(), half.height(), ExtendedColorType::Rgb8)
        .unwrap();
    file
}

/// The file with another texture, at the end of the binary chunk.
fn with_texture(bytes: &[u8], texture: &[u8]) -> Vec<u8> {
    let Glb { mut json, mut binary } = Glb::read(bytes);
    let view = json["images"][0]["bufferView"].as_u64().unwrap() as usize;
    json["bufferViews"][view]["byteOffset"] = binary.len().into();
    json["bufferViews"][view]["byteLength"] = texture.len().into();
    binary.extend(texture);
    assembled(json.to_string(), &binary)
}

/// A GLB of its two parts.
fn assembled(json: String, binary: &[u8]) -> Vec<u8> {
    let json = format!("{json:<width$}", width = json.len().next_multiple_of(4));
    let length = |bytes: usize| (bytes as u32).to_le_bytes();
    let head = [b"glTF".as_slice(), &2u32.to_le_bytes(), &length(28 + json.len() + binary.len())].concat();
    [head.as_slice(), &length(json.len()), b"JSON".as_slice(), json.as_bytes(), &length(binary.len()), b"BIN\0", binary]
        .concat()
}

/// The file with another description; JSON may grow, so that the header is written anew.
fn with_json(bytes: &[u8], change: impl Fn(String) -> String) -> Vec<u8> {
    let old = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let json = change(String::from_utf8(bytes[20..20 + old].to_vec()).unwrap());
    assert_ne!(json.as_bytes(), &bytes[20..20 + old], "nothing was changed");
    let total = (bytes.len() - old + json.len()) as u32;
    let head = [b"glTF".as_slice(), &2u32.to_le_bytes(), &total.to_le_bytes(), &(json.len() as u32).to_le_bytes()];
    [head.concat().as_slice(), b"JSON", json.as_bytes(), &bytes[20 + old..]].concat()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn whatever_bytes_come_they_are_read_or_refused(noise in prop::collection::vec(any::<u8>(), 0..400)) {
        let _ = reopen(&noise);
        let headed = [b"glTF".as_slice(), &2u32.to_le_bytes(), &noise].concat();
        prop_assert!(reopen(&headed).is_err());
    }
}
