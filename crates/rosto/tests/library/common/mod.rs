//! The sample portrait with its known landmarks.

use std::path::Path;

use rosto::{Command, Expression, FaceSlider, Limits, MeshRequest, Observation, Photo, decode};
use serde_json::Value;

/// The portrait, which `cargo xtask setup` downloads.
pub fn photo() -> Photo {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets/sample.png");
    decode(&std::fs::read(path).unwrap(), &Limits::default()).unwrap()
}

pub fn observation() -> Observation {
    let golden: Value =
        serde_json::from_str(include_str!("../../../../../tests/golden/portrait_landmarks.json")).unwrap();
    let rows = golden["landmarks"].as_array().unwrap().iter();
    let landmarks = rows.map(|row| [0, 1, 2].map(|axis| row[axis].as_f64().unwrap() as f32)).collect();
    Observation::in_photo(&photo(), landmarks)
}

pub fn unedited() -> MeshRequest {
    MeshRequest::of(vec![observation()])
}

/// A request with an edit, an expression and the sides made more alike.
pub fn edited() -> MeshRequest {
    let mut request = unedited();
    request.edits.push(FaceSlider::JawWidth.command(-0.004));
    request.edits.push(Command::Express { expression: Expression::JawOpen, weight: 0.5 });
    request.edits.push(Command::Symmetrise { share: 0.5 });
    request
}
