//! The files in `web/assets`, as installed by `cargo xtask setup`.

use std::path::Path;

use rosto_photo::{Limits, Photo};

/// The detector network.
pub fn detector_onnx() -> Vec<u8> {
    asset("face_detector.onnx")
}

/// The landmark network.
pub fn landmarks_onnx() -> Vec<u8> {
    asset("face_landmarks.onnx")
}

/// The landmark network with attention.
pub fn attention_onnx() -> Vec<u8> {
    asset("face_landmarks_attention.onnx")
}

/// The sample portrait, 512 × 512 px.
pub fn portrait() -> Photo {
    rosto_photo::decode(&asset("sample.png"), &Limits::default()).expect("the portrait is a valid picture")
}

fn asset(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}; run `cargo xtask setup`", path.display()))
}
