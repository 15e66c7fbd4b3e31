//! Tests of the worker's module in a browser: inference on the portrait, and thrown errors.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![cfg(target_arch = "wasm32")]

use js_sys::{Array, Error, Function, Reflect};
use rosto_vision_web::{Found, Vision};
use serde_json::Value;
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_dedicated_worker);

// Downloaded by `cargo xtask setup`.
const DETECTOR: &[u8] = include_bytes!("../../../web/assets/face_detector.onnx");
const LANDMARKS: &[u8] = include_bytes!("../../../web/assets/face_landmarks_attention.onnx");
const PORTRAIT: &[u8] = include_bytes!("../../../web/assets/sample.png");
const GOLDEN: &str = include_str!("../../../tests/golden/refined_landmarks.json");

fn vision() -> Vision {
    Vision::new(DETECTOR, LANDMARKS).unwrap()
}

fn find(bytes: &[u8]) -> Result<Found, Error> {
    vision().find(bytes, 1, &Function::new_no_args(""), None)
}

/// A property of a thrown error.
fn property(error: &Error, name: &str) -> String {
    Reflect::get(error, &name.into()).unwrap().as_string().unwrap()
}

#[wasm_bindgen_test]
fn landmarks_and_irises_of_the_portrait_are_close_to_mediapipe() {
    let found = find(PORTRAIT).unwrap();
    assert_eq!((found.width(), found.height(), found.face_count()), (512, 512, 1));
    let golden: Value = serde_json::from_str(GOLDEN).unwrap();
    let expected_px = golden["portrait"]["faces"][0].as_array().unwrap().iter().map(|n| n.as_f64().unwrap() / 1000.0);
    let landmarks = found.landmarks(0);
    assert_eq!(landmarks.len(), 478 * 3);
    let off_px: f64 =
        landmarks.iter().zip(expected_px).map(|(&found, expected)| (f64::from(found) * 512.0 - expected).abs()).sum();
    // Additional passes refine MediaPipe's single pass slightly.
    assert!(off_px / (478.0 * 3.0) < 1.0, "{off_px} px in total");
    assert!(!found.is_doubtful(0) && found.is_doubtful(1));
}

#[wasm_bindgen_test]
fn colours_are_those_of_the_pixels_at_the_landmarks() {
    let mut found = find(PORTRAIT).unwrap();
    let (landmarks, colours) = (found.landmarks(0), found.colours(0));
    let picture = found.take_picture();
    assert_eq!((found.picture_width(), found.picture_height(), picture.len()), (512, 512, 512 * 512 * 4));
    for vertex in 0..468 {
        let [x, y] = [0, 1].map(|axis| (landmarks[3 * vertex + axis] * 512.0) as usize);
        let pixel = 4 * (y * 512 + x);
        assert_eq!(colours[3 * vertex..3 * vertex + 3], picture[pixel..pixel + 3], "landmark {vertex}");
    }
    assert!(found.take_picture().is_empty());
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
    vision().find(PORTRAIT, 1, on_progress.as_ref().unchecked_ref(), None).unwrap();
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
    let mut found = find(PORTRAIT).unwrap();
    (found.take_picture(), found.picture_width(), found.picture_height())
}

#[wasm_bindgen_test]
fn a_followed_face_matches_the_one_found() {
    let (rgba, width, height) = frame();
    let (photo, mut vision) = (find(PORTRAIT).unwrap().landmarks(0), vision());
    for time_ms in [0.0, 33.0, 66.0] {
        let landmarks = vision.follow(&rgba, width, height, time_ms).unwrap().unwrap();
        assert_eq!(landmarks.len(), 478 * 3);
        let off_px: f32 = landmarks.iter().zip(&photo).map(|(a, b)| (a - b).abs() * 512.0).sum();
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
    let error = find(b"only words").err().unwrap();
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
        assert_eq!(property(&find(bytes).err().unwrap(), "code"), code);
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
        let error = Vision::new(detector, landmarks).err().unwrap();
        assert_eq!(property(&error, "code"), "networks-damaged");
    }
}
