//! Property tests of the document, run natively and in a browser.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod density;
mod expressions;
mod faces;
mod golden_edits;
mod history;
mod influence_radius;
mod mirror;
mod paper;
mod photo_warp;
mod robust;
#[path = "../../../../tests/seeded.rs"]
mod seeded;
mod sliders;
mod targets;
#[path = "../../../../tests/texture_truth.rs"]
mod texture_truth;
mod whole_texture;

#[cfg(target_arch = "wasm32")]
wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
