//! The worker's façade: photo and landmarks behind wasm-bindgen.
