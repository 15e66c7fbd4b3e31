//! Checks that the face networks are there if the library includes them.

use std::path::Path;

const NETWORK: &str = "../../web/assets/face_landmarks_attention.onnx";

fn main() {
    // Without this, a changed file anywhere in the package would run the script again.
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var_os("CARGO_FEATURE_EMBED_NETWORKS").is_none() {
        return;
    }
    println!("cargo::rerun-if-changed={NETWORK}");
    if !Path::new(NETWORK).is_file() {
        println!("cargo::error=the face networks are missing: run `cargo xtask networks`, then build again");
    }
}
