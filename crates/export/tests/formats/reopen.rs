//! Round trips and validation of GLB files.

use crate::common::{Glb, SIDE, edits, face, gradient, model, rebuilt};
use base64::prelude::{BASE64_STANDARD, Engine};
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use proptest::prelude::*;
use rosto_export::*;
use rosto_face::{Photo, Triangulation};

const HISTORY: &str = r#"{"entries":[0.1,"é"],"version":1}"#;

/// A PNG file up to its size field.
const PNG_START: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR";

fn file(triangulation: Triangulation, base_colour: BaseColour) -> Vec<u8> {
    let face = face(triangulation);
    let edits = SavedEdits { density: 2, ..edits(&face, Some(HISTORY)) };
    let source = Some(Source { face: &face, edits: &edits });
    glb(&model(&face), &GlbOptions { base_colour, source, ..GlbOptions::default() }).unwrap()
}

#[test]
fn a_face_round_trips() {
    for triangulation in [Triangulation::Tessellation, Triangulation::Canonical] {
        for base_colour in BaseColour::ALL {
            let saved = face(triangulation);
            let opened = reopen(&file(triangulation, base_colour)).unwrap().face;
            let edits = opened.edits.clone().unwrap();
            assert_eq!((edits.triangulation, edits.density), (triangulation, 2));
            assert_eq!((edits.history.as_deref(), edits.photo_edit), (Some(HISTORY), None));
            assert_eq!(opened.photos.len(), 1);
            let again = rebuilt(opened);
            assert_eq!(again.positions_m(), saved.positions_m(), "bit for bit");
            assert_eq!(again.positions_image(), saved.positions_image());
            assert_eq!(again.colours_srgb(), saved.colours_srgb());
        }
    }
}

#[test]
fn the_picture_shows_the_photo_where_it_was_cropped() {
    for base_colour in [BaseColour::Photo, BaseColour::Whole] {
        let picture = picture_in(&file(Triangulation::Canonical, base_colour));
        assert_eq!([picture.width(), picture.height()], [SIDE; 2]);
        assert_close(&picture, 6);
    }
}

fn picture_in(file: &[u8]) -> Photo {
    reopen(file).unwrap().face.photos.remove(0).picture.unwrap()
}

/// Asserts that a picture equals the gradient where it is opaque, within `levels`, and is transparent elsewhere.
fn assert_close(picture: &Photo, levels: u8) {
    let (alpha, gradient) = (picture.alpha().unwrap(), gradient());
    let opaque = alpha.iter().filter(|alpha| **alpha == u8::MAX).count();
    assert_eq!(alpha.iter().filter(|alpha| **alpha == 0).count(), alpha.len() - opaque);
    assert!((256 * 200..300 * 300).contains(&opaque), "{opaque} px");
    for (at, alpha) in (0..).zip(alpha).filter(|(_, alpha)| **alpha != 0) {
        let [found, cut] = [picture, &gradient].map(|picture| picture.pixel(at % SIDE, at / SIDE));
        assert!(found.iter().zip(cut).all(|(a, b)| a.abs_diff(b) <= levels), "{found:?} for {cut:?} at {at}, {alpha}");
    }
}

#[test]
fn an_invalid_or_oversized_photo_crop_is_refused() {
    let bytes = file(Triangulation::Canonical, BaseColour::Whole);
    let jpeg =
        Glb::read(&bytes).json["scenes"][0]["extras"]["photos"][0]["picture"]["jpeg"].as_str().unwrap().to_owned();
    let png = |side: u32| [PNG_START, &side.to_be_bytes(), &side.to_be_bytes()].concat();
    for other in ["", "***", &BASE64_STANDARD.encode(png(9000)), &BASE64_STANDARD.encode(png(9))] {
        let damaged = with_json(&bytes, |json| json.replace(&jpeg, other));
        assert_eq!(reopen(&damaged), Err(ReopenError::Field { field: "picture" }), "{other}");
    }
}

#[test]
fn vertex_colours_are_painted_if_there_is_no_photo() {
    let bytes = file(Triangulation::Canonical, BaseColour::VertexColours);
    let photo = reopen(&bytes).unwrap().face.photos.remove(0);
    let picture = photo.picture.unwrap();
    assert_eq!([picture.width(), picture.height()], [SIDE; 2]);
    let rgba = picture.rgba();
    let pixel = |x: f32, y: f32| {
        rgba.as_chunks::<4>().0[(y * SIDE as f32) as usize * SIDE as usize + (x * SIDE as f32) as usize]
    };
    let [x, y, _] = photo.landmarks[1];
    let [red, green, blue, alpha] = pixel(x, y);
    let nose = [red, green, blue].iter().zip(photo.colours_srgb[1]).map(|(a, b)| a.abs_diff(b)).max().unwrap();
    assert!(nose <= 3 && alpha == u8::MAX, "{nose} levels off at the nose tip");
    assert_eq!(pixel(0.0, 0.0)[3], 0, "transparent outside the face");
}

#[test]
fn files_of_other_programs_or_versions_are_refused() {
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
    assert_eq!(reopen(&empty), Err(ReopenError::Field { field: "photos" }));
    assert_eq!(reopen(b"a photo, perhaps"), Err(ReopenError::NotGlb));
}

#[test]
fn a_truncated_file_is_refused() {
    let bytes = file(Triangulation::Tessellation, BaseColour::Photo);
    for end in (0..bytes.len()).step_by(61).chain(0..64) {
        assert!(reopen(&bytes[..end]).is_err(), "opened with {end} of {} bytes", bytes.len());
    }
}

#[test]
fn out_of_range_offsets_and_picture_sizes_are_refused() {
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
fn a_texture_resized_elsewhere_keeps_its_placement() {
    let bytes = file(Triangulation::Canonical, BaseColour::Photo);
    let Glb { json, binary } = Glb::read(&bytes);
    let view = &json["bufferViews"][json["images"][0]["bufferView"].as_u64().unwrap() as usize];
    let [start, length] = ["byteOffset", "byteLength"].map(|name| view[name].as_u64().unwrap() as usize);
    let crop = rosto_photo::decode(&binary[start..start + length], &rosto_photo::Limits::default()).unwrap();
    let halved = with_texture(&bytes, &halved(&crop));
    assert_close(&picture_in(&halved), 8);
    assert!(!reopen(&halved).unwrap().changed_elsewhere, "the mesh is the same");
}

#[test]
fn a_mesh_changed_elsewhere_is_detected() {
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
fn a_mesh_stored_in_another_layout_is_unchanged() {
    let bytes = file(Triangulation::Canonical, BaseColour::VertexColours);
    let glb = Glb::read(&bytes);
    let positions = glb.floats::<3>(glb.attribute("POSITION"));
    // Each position between two other numbers, at the end of the file, as in interleaved attributes.
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
fn invalid_fields_are_named() {
    let bytes = file(Triangulation::Canonical, BaseColour::VertexColours);
    let json = Glb::read(&bytes).json;
    let observation = json["scenes"][0]["extras"]["photos"][0]["observation"].as_str().unwrap().to_owned();
    for (from, to, field) in [
        (observation.as_str(), "****", "observation"),
        ("\"photos\"", "\"_\"", "photos"),
        ("\"triangulation\"", "\"_\"", "triangulation"),
        ("\"density\":2", "\"density\":5", "density"),
        (HISTORY, "null", "history"),
    ] {
        let wrong = with_json(&bytes, |json| json.replace(from, to));
        assert_eq!(reopen(&wrong), Err(ReopenError::Field { field }), "{field}");
    }
}

/// Halves a picture and encodes it as PNG, like a program that reduces textures.
fn halved(picture: &rosto_photo::Photo) -> Vec<u8> {
    let half = picture.scaled_down(picture.width().max(picture.height()) / 2);
    let mut file = Vec::new();
    PngEncoder::new(&mut file)
        .write_image(half.pixels(), half.width(), half.height(), ExtendedColorType::Rgb8)
        .unwrap();
    file
}

/// Replaces the texture with another, at the end of the binary chunk.
fn with_texture(bytes: &[u8], texture: &[u8]) -> Vec<u8> {
    let Glb { mut json, mut binary } = Glb::read(bytes);
    let view = json["images"][0]["bufferView"].as_u64().unwrap() as usize;
    json["bufferViews"][view]["byteOffset"] = binary.len().into();
    json["bufferViews"][view]["byteLength"] = texture.len().into();
    binary.extend(texture);
    assembled(json.to_string(), &binary)
}

/// Assembles a GLB from its two chunks.
fn assembled(json: String, binary: &[u8]) -> Vec<u8> {
    let json = format!("{json:<width$}", width = json.len().next_multiple_of(4));
    let length = |bytes: usize| (bytes as u32).to_le_bytes();
    let head = [b"glTF".as_slice(), &2u32.to_le_bytes(), &length(28 + json.len() + binary.len())].concat();
    [head.as_slice(), &length(json.len()), b"JSON".as_slice(), json.as_bytes(), &length(binary.len()), b"BIN\0", binary]
        .concat()
}

/// Changes the JSON chunk and rewrites the header, since the length may change.
fn with_json(bytes: &[u8], change: impl Fn(String) -> String) -> Vec<u8> {
    let old = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let json = change(String::from_utf8(bytes[20..20 + old].to_vec()).unwrap());
    assert_ne!(json.as_bytes(), &bytes[20..20 + old], "the pattern was not found");
    let total = (bytes.len() - old + json.len()) as u32;
    let head = [b"glTF".as_slice(), &2u32.to_le_bytes(), &total.to_le_bytes(), &(json.len() as u32).to_le_bytes()];
    [head.concat().as_slice(), b"JSON", json.as_bytes(), &bytes[20 + old..]].concat()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn arbitrary_bytes_do_not_panic(noise in prop::collection::vec(any::<u8>(), 0..400)) {
        let _ = reopen(&noise);
        let headed = [b"glTF".as_slice(), &2u32.to_le_bytes(), &noise].concat();
        prop_assert!(reopen(&headed).is_err());
    }
}
