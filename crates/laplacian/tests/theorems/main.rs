//! Properties that must hold for any mesh and edit. The same tests run natively and in a browser.
#![allow(clippy::unwrap_used, reason = "a failed set-up fails the test")]

mod distortion;
mod edits;
mod fairing;
mod golden;
mod golden_edits;
mod meshes;
mod operators;
mod references;
mod refusals;
mod regions;
mod rigid;
mod robustness;
#[path = "../../../../tests/seeded.rs"]
mod seeded;

#[cfg(target_arch = "wasm32")]
wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
