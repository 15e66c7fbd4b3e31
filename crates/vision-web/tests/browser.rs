//! Tests of the worker's module in a browser: inference on the portrait, and thrown errors.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![cfg(target_arch = "wasm32")]

use js_sys::{Array, Error, Function, Object, Reflect};
use rosto::{BaseColour, EditsAs, FaceMesh, Format, Limits, Observation, PhotoLens, SavedFace, decode};
use rosto_face::canonical_positions_m;
use rosto_vision_web::{FaceRequest, FileOptions, Vision};
use serde::Serialize;
use serde_json::{Value, json};
use tsify::Ts;
use tsify::serde_wasm_bindgen::Serializer;
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_dedicated_worker);

// Downloaded by `cargo xtask setup`.
const DETECTOR: &[u8] = include_bytes!("../../../web/assets/face_detector.onnx");
const LANDMARKS: &[u8] = include_bytes!("../../../web/assets/face_landmarks_attention.onnx");
const PORTRAIT: &[u8] = include_bytes!("../../../web/assets/sample.png");
const GOLDEN: &str = include_str!("../../../tests/golden/refined_landmarks.json");

/// Edits of one landmark and of an expression, with a distance of the photo.
const EDITS: &str = r#"{"density":1,"history":{"entries":[{"label":"nose-tip","move":{"anchors":{"kind":"oval","pins":[]},"constraint":"exact","details":"kept","handles":[4],"influence":{"within":0.04},"level":0,"mirror":"on","offsets":[[0.0,0.002,0.006]],"operator":"cotangent"},"switch":"on"},{"express":{"expression":"jawOpen","weight":0.5},"label":"jawOpen","switch":"on"}],"rosto":"history","version":1},"photo_edit":{"protected_px":[[[250.0,200.0,12.5]]],"seen_from_m":1.5},"triangulation":"canonical"}"#;

/// The canonical face, found in the middle of the portrait.
fn canonical_face() -> Observation {
    let landmark = |p: &glam::DVec3| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|part| part as f32);
    Observation {
        landmarks: canonical_positions_m().iter().map(landmark).collect(),
        photo_size_px: [512, 512],
        colours_srgb: vec![[180, 120, 90]; 468],
        found_lens: PhotoLens::Exif(26.0),
        card: None,
        lens: PhotoLens::Distance(0.5),
        picture: None,
    }
}

fn vision() -> Vision {
    let mut vision = Vision::new();
    vision.load_networks(DETECTOR, LANDMARKS).unwrap();
    vision
}

/// Opens a file as "file".
fn open(vision: &mut Vision, bytes: &[u8]) -> Result<Value, Error> {
    let opened = vision.open("file", bytes, 1, &Function::new_no_args(""), None)?;
    Ok(value(&opened.into()))
}

/// The face of an opened file with one face.
fn face(opened: &Value) -> &Value {
    let faces = opened["faces"].as_array().unwrap();
    assert_eq!(faces.len(), 1);
    &faces[0]
}

/// The landmarks of an opened face.
fn landmarks(face: &Value) -> Vec<[f32; 3]> {
    SavedFace::from_json(face["photos"].as_str().unwrap(), None).unwrap().photos.remove(0).landmarks
}

/// A plain object as JSON; typed arrays are left out.
fn value(object: &JsValue) -> Value {
    serde_json::from_str(&String::from(js_sys::JSON::stringify(object).unwrap())).unwrap()
}

fn object(value: &Value) -> JsValue {
    value.serialize(&Serializer::json_compatible()).unwrap()
}

/// A request of an opened face, with these edits.
fn request(face: &Value, edits: Option<&str>) -> Ts<FaceRequest> {
    let edits = edits.map_or(Value::Null, Value::from);
    Ts::new_unchecked(object(&json!({"photos": face["photos"], "edits": edits, "pictures": face["pictures"]})))
}

fn options(options: Value) -> Ts<FileOptions> {
    Ts::new_unchecked(object(&options))
}

fn bytes(written: &JsValue) -> Vec<u8> {
    js_sys::Uint8Array::new(&Reflect::get(written, &"bytes".into()).unwrap()).to_vec()
}

/// Width, height and RGBA pixels of a picture.
fn pixels(picture: &JsValue) -> (u32, u32, Vec<u8>) {
    let side = |name: &str| Reflect::get(picture, &name.into()).unwrap().as_f64().unwrap() as u32;
    let rgba = Reflect::get(picture, &"rgba".into()).unwrap();
    assert!(rgba.is_instance_of::<js_sys::Uint8ClampedArray>());
    (side("width"), side("height"), js_sys::Uint8Array::new(&rgba).to_vec())
}

/// A property of a thrown error.
fn property(error: &Error, name: &str) -> String {
    Reflect::get(error, &name.into()).unwrap().as_string().unwrap()
}

#[wasm_bindgen_test]
fn landmarks_and_irises_of_the_portrait_are_close_to_mediapipe() {
    let opened = open(&mut vision(), PORTRAIT).unwrap();
    let face = face(&opened);
    assert_eq!((&opened["kind"], &face["sizePx"], &face["lead"]), (&json!("photo"), &json!([512, 512]), &json!(0)));
    let golden: Value = serde_json::from_str(GOLDEN).unwrap();
    let expected_px = golden["portrait"]["faces"][0].as_array().unwrap().iter().map(|n| n.as_f64().unwrap() / 1000.0);
    let landmarks = landmarks(face);
    assert_eq!(landmarks.len(), 478);
    let off_px: f64 = landmarks
        .as_flattened()
        .iter()
        .zip(expected_px)
        .map(|(&found, expected)| (f64::from(found) * 512.0 - expected).abs())
        .sum();
    // Additional passes refine MediaPipe's single pass slightly.
    assert!(off_px / (478.0 * 3.0) < 1.0, "{off_px} px in total");
    assert_eq!(face["remarks"], serde_json::json!([]));
    let found: Vec<f32> = serde_json::from_value(face["landmarks"].clone()).unwrap();
    assert_eq!(found, landmarks.as_flattened());
}

#[wasm_bindgen_test]
fn colours_are_those_of_the_pixels_at_the_landmarks() {
    let mut vision = vision();
    let opened = open(&mut vision, PORTRAIT).unwrap();
    let face = face(&opened);
    let observation = SavedFace::from_json(face["photos"].as_str().unwrap(), None).unwrap().photos.remove(0);
    let (width, height, picture) = pixels(&vision.picture("file/0").unwrap().into());
    assert_eq!((width, height, picture.len()), (512, 512, 512 * 512 * 4));
    for (landmark, colour) in observation.landmarks.iter().zip(&observation.colours_srgb) {
        let [x, y] = [0, 1].map(|axis| (landmark[axis] * 512.0) as usize);
        let pixel = 4 * (y * 512 + x);
        assert_eq!(picture[pixel..pixel + 4], [colour[0], colour[1], colour[2], 255]);
    }
}

#[wasm_bindgen_test]
fn an_edited_face_reopens_from_its_glb_and_project() {
    let mut vision = vision();
    let opened = open(&mut vision, PORTRAIT).unwrap();
    let found = face(&opened).clone();
    let edited = || request(&found, Some(EDITS));
    let glb = vision.write(edited(), "glb", options(json!({"texture-size": "1024"})), "portrait").unwrap().into();
    assert_eq!(value(&glb)["extension"], "glb");
    assert_eq!(value(&glb)["mediaType"], "model/gltf-binary");
    for file in [bytes(&glb), vision.write_project(edited()).unwrap()] {
        let reopened = open(&mut Vision::new(), &file).unwrap();
        assert_eq!((&reopened["kind"], &reopened["changedElsewhere"]), (&json!("saved"), &json!(false)));
        let face = face(&reopened);
        assert_eq!(face["photos"], found["photos"]);
        assert_eq!(face["edits"], EDITS);
    }
}

#[wasm_bindgen_test]
fn the_glb_of_a_request_has_the_librarys_bytes() {
    let mut vision = Vision::new();
    vision.keep("photo", PORTRAIT, None).unwrap();
    let photos = SavedFace { photos: vec![canonical_face()], edits: None }.photos_json();
    let face = json!({"photos": photos, "pictures": ["photo/0"]});
    let chosen = options(json!({"base-colour": "photo", "edits": "morph-targets"}));
    let glb = bytes(&vision.write(request(&face, Some(EDITS)), "glb", chosen, "face").unwrap().into());

    let mut saved = SavedFace::from_json(&photos, Some(EDITS)).unwrap();
    saved.photos[0].picture = Some(decode(PORTRAIT, &Limits::default()).unwrap());
    let chosen =
        rosto::FileOptions { base_colour: BaseColour::Photo, edits: EditsAs::MorphTargets, ..Default::default() };
    assert_eq!(glb, FaceMesh::reopen(saved).unwrap().write(Format::Glb, &chosen, "face").unwrap().bytes);
}

#[wasm_bindgen_test]
fn edits_do_not_change_the_texture() {
    let mut vision = vision();
    let opened = open(&mut vision, PORTRAIT).unwrap();
    let face = face(&opened);
    let mut texture = |edits| pixels(&vision.texture(request(face, edits), "1024").unwrap().into());
    let first = texture(None);
    assert_eq!((first.0, first.1), (1024, 1024));
    assert_eq!(texture(Some(EDITS)), first);
}

#[wasm_bindgen_test]
fn an_edited_photo_has_the_photos_size_and_other_pixels() {
    let mut vision = vision();
    let opened = open(&mut vision, PORTRAIT).unwrap();
    let face = face(&opened);
    let original = pixels(&vision.picture("file/0").unwrap().into());
    let edited = |edits| pixels(&vision.edited_photo(request(face, edits), PORTRAIT, 0.35).unwrap().into());
    assert!(edited(None) == original);
    let edited = edited(Some(EDITS));
    assert_eq!((edited.0, edited.1), (original.0, original.1));
    assert!(edited.2 != original.2);
}

#[wasm_bindgen_test]
fn a_body_is_measured_and_its_limits_are_reported() {
    let mut vision = vision();
    let opened = open(&mut vision, PORTRAIT).unwrap();
    let face = face(&opened);
    let printed = vision.print(request(face, None), options(json!({"solid": "flat:60"}))).unwrap().unwrap();
    let printed: JsValue = printed.into();
    let length = |name: &str| Reflect::get(&Reflect::get(&printed, &name.into()).unwrap(), &"length".into()).unwrap();
    assert!(length("positionsM") == length("colours") && length("triangles").as_f64().unwrap() > 80_000.0);
    let facts = value(&Reflect::get(&printed, &"facts".into()).unwrap());
    assert!(facts["volumeCm3"].as_f64().unwrap() > 50.0 && facts["plaGrams"].as_f64().unwrap() > 60.0, "{facts}");
    assert!(vision.print(request(face, None), options(json!({"solid": "surface"}))).unwrap().is_none());
    let thick = vision.print(request(face, None), options(json!({"solid": "thickness:50"}))).err().unwrap();
    assert_eq!(property(&thick, "code"), "too-thick");
    assert!(Reflect::get(&thick, &"maxMm".into()).unwrap().as_f64().unwrap() < 50.0);
}

#[wasm_bindgen_test]
fn the_pictures_of_the_last_six_files_are_kept() {
    let mut vision = Vision::new();
    for key in ["a", "b", "c", "d", "e", "f"] {
        vision.keep(key, PORTRAIT, None).unwrap();
    }
    vision.picture("a/0").unwrap();
    vision.keep("g", PORTRAIT, None).unwrap();
    assert!(vision.has("a/0") && vision.has("g/0") && !vision.has("b/0"));
    assert!(!vision.has("a/1") && !vision.has("a"));
}

#[wasm_bindgen_test]
fn wrong_requests_throw_a_code() {
    let mut vision = vision();
    let opened = open(&mut vision, PORTRAIT).unwrap();
    let face = face(&opened);
    let code = |error: Option<Error>| property(&error.unwrap(), "code");
    let mut write = |face: Ts<FaceRequest>, format: &str, chosen: Value| {
        code(vision.write(face, format, options(chosen), "face").err())
    };
    assert_eq!(write(request(face, None), "doc", json!({})), "bad-choice");
    assert_eq!(write(request(face, None), "glb", json!({"eyes": "glass"})), "bad-choice");
    assert_eq!(write(request(face, Some("{}")), "glb", json!({})), "bad-history");
    assert_eq!(write(request(face, None), "3mf", json!({"solid": "surface"})), "surface-alone");
    assert_eq!(write(Ts::new_unchecked(Object::new().into()), "glb", json!({})), "bad-choice");
    let lost = json!({"photos": face["photos"], "pictures": ["lost/0"]});
    assert_eq!(write(request(&lost, None), "glb", json!({})), "internal");
    assert_eq!(code(open(&mut Vision::new(), PORTRAIT).err()), "internal");
    assert_eq!(code(open(&mut Vision::new(), b"glTF").err()), "damaged-glb");
    assert_eq!(code(open(&mut Vision::new(), b"{\"format\":\"rosto-project\"}").err()), "bad-project");
}

#[wasm_bindgen_test]
fn progress_reports_the_stages_in_order() {
    let received = Array::new();
    let on_progress = {
        let received = received.clone();
        Closure::<dyn Fn(String, f64)>::new(move |stage: String, fraction: f64| {
            received.push(&Array::of2(&stage.into(), &fraction.into()));
        })
    };
    vision().open("file", PORTRAIT, 1, on_progress.as_ref().unchecked_ref(), None).unwrap();
    let reports: Vec<(String, f64)> = received.iter().map(|report| stage_and_fraction(&report.into())).collect();
    let bars: Vec<f64> = reports.iter().map(|(_, fraction)| *fraction).collect();
    let mut stages: Vec<&str> = reports.iter().map(|(stage, _)| stage.as_str()).collect();
    stages.dedup();
    assert_eq!(stages, ["decode", "detect", "landmarks"]);
    assert!(bars.is_sorted() && bars.windows(2).all(|two| two[1] - two[0] < 0.34), "{bars:?}");
}

fn stage_and_fraction(report: &Array) -> (String, f64) {
    (report.get(0).as_string().unwrap(), report.get(1).as_f64().unwrap())
}

/// The portrait's pixels as a browser delivers them, and its size.
fn frame() -> (Vec<u8>, u32, u32) {
    let mut vision = Vision::new();
    vision.keep("file", PORTRAIT, None).unwrap();
    let (width, height, rgba) = pixels(&vision.picture("file/0").unwrap().into());
    (rgba, width, height)
}

#[wasm_bindgen_test]
fn a_followed_face_matches_the_one_found() {
    let (rgba, width, height) = frame();
    let mut vision = vision();
    let opened = open(&mut vision, PORTRAIT).unwrap();
    let photo = landmarks(face(&opened));
    for time_ms in [0.0, 33.0, 66.0] {
        let landmarks = vision.follow(&rgba, width, height, time_ms).unwrap().unwrap();
        assert_eq!(landmarks.len(), 478 * 3);
        let off_px: f32 = landmarks.iter().zip(photo.as_flattened()).map(|(a, b)| (a - b).abs() * 512.0).sum();
        assert!(off_px / (478.0 * 3.0) < 1.0, "{off_px} px in total at {time_ms} ms");
    }
}

#[wasm_bindgen_test]
fn following_needs_a_face_and_can_be_reset() {
    let (rgba, width, height) = frame();
    let mut vision = vision();
    assert_eq!(vision.follow(&vec![90; rgba.len()], width, height, 0.0).unwrap(), None);
    let first = vision.follow(&rgba, width, height, 33.0).unwrap().unwrap();
    vision.follow(&rgba, width, height, 66.0).unwrap();
    vision.stop_following();
    assert_eq!(vision.follow(&rgba, width, height, 99.0).unwrap().unwrap(), first);
}

#[wasm_bindgen_test]
fn a_truncated_frame_throws() {
    let error = vision().follow(&[0; 15], 2, 2, 0.0).err().unwrap();
    assert_eq!(property(&error, "code"), "damaged-picture");
}

#[wasm_bindgen_test]
fn errors_have_a_code_a_message_and_a_hint() {
    let error = open(&mut Vision::new(), b"only words").err().unwrap();
    assert!(error.is_instance_of::<Error>());
    assert_eq!(property(&error, "code"), "not-a-picture");
    assert!(!property(&error, "message").is_empty());
    assert!(property(&error, "hint").contains("JPEG"));
}

#[wasm_bindgen_test]
fn errors_of_photos_have_distinct_codes() {
    let mut huge = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
    huge.extend([0, 0, 0x4E, 0x20, 0, 0, 0x4E, 0x20, 8, 2, 0, 0, 0]);
    let cases: [(&[u8], &str); 3] = [
        (&PORTRAIT[..PORTRAIT.len() / 2], "damaged-picture"),
        (&huge, "too-many-pixels"),
        (b"\0\0\0\x18ftypheic\0\0\0\0", "unsupported-format"),
    ];
    for (bytes, code) in cases {
        assert_eq!(property(&open(&mut Vision::new(), bytes).err().unwrap(), "code"), code);
    }
}

#[wasm_bindgen_test]
fn damaged_networks_throw() {
    let mut infinite = LANDMARKS.to_vec();
    // Half-precision infinities and NaNs: all exponent bits set.
    for at in (LANDMARKS.len() / 2..LANDMARKS.len() / 2 + 400).step_by(2) {
        infinite[at..at + 2].fill(0x7C);
    }
    for (detector, landmarks) in [(&DETECTOR[..1000], LANDMARKS), (DETECTOR, &infinite)] {
        let error = Vision::new().load_networks(detector, landmarks).err().unwrap();
        assert_eq!(property(&error, "code"), "networks-damaged");
    }
}
