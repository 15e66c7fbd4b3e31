//! Embeds the face networks in release builds, so that `rosto` is a single file. Other builds read them from the source
//! tree.

use std::env;
use std::path::Path;

/// Same names as in `src/main.rs`.
const NETWORKS: [&str; 3] = ["face_detector.onnx", "face_landmarks.onnx", "face_landmarks_attention.onnx"];

fn main() {
    println!("cargo::rustc-check-cfg=cfg(embedded_networks)");
    let paths = NETWORKS.map(|name| Path::new("../../web/assets").join(name));
    paths.iter().for_each(|path| println!("cargo::rerun-if-changed={}", path.display()));
    if env::var("PROFILE").as_deref() != Ok("release") {
        return;
    }
    match paths.iter().all(|path| path.is_file()) {
        true => println!("cargo::rustc-cfg=embedded_networks"),
        false => println!(
            "cargo::warning=the face networks are not in web/assets and will not be embedded: run `cargo xtask setup`, then build again"
        ),
    }
}
