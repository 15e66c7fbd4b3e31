//! The command line `rosto`.

use std::process::ExitCode;

use rosto_cli::EmbeddedNetworks;

#[cfg(embedded_networks)]
const NETWORKS: EmbeddedNetworks = &[
    ("face_detector.onnx", include_bytes!("../../../web/assets/face_detector.onnx")),
    ("face_landmarks.onnx", include_bytes!("../../../web/assets/face_landmarks.onnx")),
    ("face_landmarks_attention.onnx", include_bytes!("../../../web/assets/face_landmarks_attention.onnx")),
];
#[cfg(not(embedded_networks))]
const NETWORKS: EmbeddedNetworks = &[];

fn main() -> ExitCode {
    ExitCode::from(rosto_cli::command_line_with(std::env::args_os(), NETWORKS))
}
