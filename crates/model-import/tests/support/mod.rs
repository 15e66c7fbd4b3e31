//! The npm package of the networks, as installed by `cargo xtask setup`.

use std::path::Path;

/// The loader script and the packed assets.
pub fn package() -> (String, Vec<u8>) {
    let loader_js = read("face_mesh_solution_packed_assets_loader.js");
    let packed = read("face_mesh_solution_packed_assets.data");
    (String::from_utf8(loader_js).expect("the script is UTF-8"), packed)
}

fn read(name: &str) -> Vec<u8> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../node_modules/@mediapipe/face_mesh");
    let path = package.join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}; run `cargo xtask setup`", path.display()))
}
