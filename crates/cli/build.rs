//! Lets a release build hold the face networks, so that `rosto` is one file. Other builds read them in the source tree.

use std::env;
use std::path::Path;

/// As `src/main.rs` includes them.
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
            "cargo::warning=the face networks are not in web/assets, and the program will not hold them: run `cargo xtask setup`, then build again"
        ),
    }
}
