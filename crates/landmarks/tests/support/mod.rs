//! What the tests of this crate share: the networks, the portrait, and pictures made of it.

#![allow(dead_code, reason = "each test file is a program of its own and uses its part of this")]

pub mod assets;
pub mod pictures;
pub mod scenes;
#[path = "../../../../tests/seeded.rs"]
pub mod seeded;

/// The finder with the networks the app serves.
pub fn finder() -> rosto_landmarks::FaceFinder {
    rosto_landmarks::FaceFinder::new(&assets::detector_onnx(), &assets::landmarks_onnx())
        .expect("the networks are whole")
}
