//! What must hold for every mesh and every edit, run natively and, with the same bodies, in a browser.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

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
