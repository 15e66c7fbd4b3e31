//! Rendering tests in the browser: known meshes are drawn and their pixels read back.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "in a test, a panic is the report")]

mod canvas;
mod follow;
mod marks;
mod paints;
mod photo_layer;
mod support;

wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
