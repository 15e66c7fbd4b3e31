//! Tests of the façade on a canvas in a browser.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod editing;
mod pointing;
mod refusals;
mod restoring;
mod support;
mod view;

wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
