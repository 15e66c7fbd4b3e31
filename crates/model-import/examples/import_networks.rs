//! Converts the networks of an unpacked `@mediapipe/face_mesh` package to three ONNX files:
//!
//! `cargo run -p rosto-model-import --example import_networks -- PACKAGE_FOLDER OUTPUT_FOLDER`

use std::error::Error;
use std::fs;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let mut folders = std::env::args_os().skip(1).map(PathBuf::from);
    let (Some(package), Some(output)) = (folders.next(), folders.next()) else {
        return Err("usage: import_networks PACKAGE_FOLDER OUTPUT_FOLDER".into());
    };
    let loader_js = fs::read_to_string(package.join("face_mesh_solution_packed_assets_loader.js"))?;
    let packed = fs::read(package.join("face_mesh_solution_packed_assets.data"))?;
    let networks = rosto_model_import::import(&loader_js, &packed)?;
    fs::write(output.join("face_detector.onnx"), networks.detector_onnx)?;
    fs::write(output.join("face_landmarks.onnx"), networks.landmarks_onnx)?;
    fs::write(output.join("face_landmarks_attention.onnx"), networks.attention_onnx)?;
    Ok(())
}
