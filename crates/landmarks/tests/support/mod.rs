//! Shared test support: networks, the portrait, and pictures derived from it.

#![allow(dead_code, reason = "each test program uses a part of this module")]

pub mod assets;
pub mod pictures;
pub mod scenes;
#[path = "../../../../tests/seeded.rs"]
pub mod seeded;
pub mod video;

use rosto_landmarks::{FaceFinder, LandmarkNetwork};

/// A finder with the plain landmark network.
pub fn finder() -> FaceFinder {
    finder_with(LandmarkNetwork::Plain(&assets::landmarks_onnx()))
}

/// A finder with the attention network.
pub fn attention_finder() -> FaceFinder {
    finder_with(LandmarkNetwork::Attention(&assets::attention_onnx()))
}

fn finder_with(network: LandmarkNetwork<'_>) -> FaceFinder {
    FaceFinder::new(&assets::detector_onnx(), network).expect("the networks are intact")
}
