//! What the tests of this crate share: the networks, the portrait, and pictures made of it.

#![allow(dead_code, reason = "each test file is a program of its own and uses its part of this")]

pub mod assets;
pub mod video;
pub mod pictures;
pub mod scenes;
#[path = "../../../../tests/seeded.rs"]
pub mod seeded;

use rosto_landmarks::{FaceFinder, LandmarkNetwork};

/// The finder with the networks the app serves.
pub fn finder() -> FaceFinder {
    finder_with(LandmarkNetwork::Plain(&assets::landmarks_onnx()))
}

/// The finder whose landmark network looks closer at lips and eyes.
pub fn attentive_finder() -> FaceFinder {
    finder_with(LandmarkNetwork::Attention(&assets::attention_onnx()))
}

fn finder_with(network: LandmarkNetwork<'_>) -> FaceFinder {
    FaceFinder::new(&assets::detector_onnx(), network).expect("the networks are whole")
}
