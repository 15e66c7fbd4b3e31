//! The page's façade: studio, viewport and export behind wasm-bindgen.
