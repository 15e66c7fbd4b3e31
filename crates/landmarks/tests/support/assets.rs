//! The files that `cargo xtask setup` puts into `web/assets`.

use std::path::Path;

use rosto_landmarks::FaceFinder;
use rosto_photo::{Limits, Photo};

/// The finder with the two networks the app serves.
pub fn finder() -> FaceFinder {
    FaceFinder::new(&asset("face_detector.onnx"), &asset("face_landmarks.onnx")).expect("the networks are whole")
}

/// The sample portrait, 512 × 512 px.
pub fn portrait() -> Photo {
    rosto_photo::decode(&asset("sample.png"), &Limits::default()).expect("the portrait is a picture")
}

fn asset(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}; run `cargo xtask setup`", path.display()))
}
