//! What must hold for every document, run natively and, with the same bodies, in a browser.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod density;
mod faces;
mod golden_edits;
mod history;
mod in_photo;
mod mirror;
mod paper;
mod reach;
mod robust;
#[path = "../../../../tests/seeded.rs"]
mod seeded;
mod sliders;
mod targets;

#[cfg(target_arch = "wasm32")]
wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
