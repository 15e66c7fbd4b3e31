//! Converts the face networks of the npm package `@mediapipe/face_mesh` to ONNX.
//!
//! The functions map bytes to bytes and do not access files or the network. The package concatenates its assets in one
//! file, and a loader script lists the byte range of each. [`import`] extracts the three TFLite networks, verifies
//! their SHA-256, and converts them:
//!
//! * NHWC becomes NCHW. A reshape of a rank 4 tensor is preceded by a transpose to NHWC, which preserves the order of
//!   the output values.
//! * `SAME` padding becomes explicit padding (`Window` in the `tflite` module).
//! * Weights stay in half precision, each followed by a `Cast`. The detector and the landmark network together take
//!   about 1.5 MB.
//! * The attention network has custom MediaPipe operators, which crop rotated regions from its feature map. The
//!   conversion omits them: the graph consists of a trunk and three heads with separate inputs, and the caller crops the
//!   regions.
//!
//! The opset is 13. The picture is f32 `[1, 3, side, side]`. The outputs of the detector are `regressors`
//! `[1, 896, 16]` and `classificators` `[1, 896, 1]`. Those of the landmark network are `conv2d_21` `[1, 1404, 1, 1]`
//! and `conv2d_31` `[1, 1, 1, 1]`. The trunk of the attention network outputs `output_mesh` `[1, 1404, 1, 1]`,
//! `conv_faceflag` `[1, 1, 1, 1]` and the features `p_re_lu_3` `[1, 32, 48, 48]`. Its heads take
//! `transform_tensor_bilinear_v2`, `…_1` and `…_2`, each `[1, 32, 16, 16]`. They output `conv_lips` `[1, 160, 1, 1]`,
//! `conv_left_eye` `[1, 142, 1, 1]`, `conv_left_iris` `[1, 10, 1, 1]`, and the same for the right eye. Left and right
//! are the picture's.

mod convert;
mod error;
mod flatbuffer;
mod onnx;
mod package;
#[cfg(test)]
#[path = "../tests/support/mod.rs"]
mod support;
mod tflite;

pub use convert::{onnx_from_tflite, onnx_of_part};
pub use error::ImportError;

use package::Package;

/// The three networks as ONNX files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Networks {
    /// 128 × 128 picture → 896 boxes with six key points each, and their scores.
    pub detector_onnx: Vec<u8>,
    /// 192 × 192 face → 468 landmarks and the face flag.
    pub landmarks_onnx: Vec<u8>,
    /// 192 × 192 face → 468 landmarks, the face flag and features; crops of the features → lips, eyes and irises.
    pub attention_onnx: Vec<u8>,
}

const DETECTOR_FILE: &str = "face_detection_short_range.tflite";
const DETECTOR_SHA256: &str = "3bc182eb9f33925d9e58b5c8d59308a760f4adea8f282370e428c51212c26633";
const LANDMARKS_FILE: &str = "face_landmark.tflite";
const LANDMARKS_SHA256: &str = "c603fa6149219a3e9487dc9abd7a0c24474c77263273d24868378cdf40aa26d1";
const ATTENTION_FILE: &str = "face_landmark_with_attention.tflite";
const ATTENTION_SHA256: &str = "883b7411747bac657c30c462d305d312e9dec6adbf8b85e2f5d8d722fca9455d";
/// The picture, and the crops for the lips and the eyes.
const ATTENTION_INPUTS: [&str; 4] =
    ["input_1", "transform_tensor_bilinear_v2", "transform_tensor_bilinear_v2_1", "transform_tensor_bilinear_v2_2"];
/// The trunk's outputs, including the features to crop, then the heads' outputs.
const ATTENTION_OUTPUTS: [&str; 8] = [
    "output_mesh",
    "conv_faceflag",
    "p_re_lu_3",
    "conv_lips",
    "conv_left_eye",
    "conv_left_iris",
    "conv_right_eye",
    "conv_right_iris",
];

/// Extracts the networks from the package's assets and converts them.
///
/// `loader_js` is `face_mesh_solution_packed_assets_loader.js`, `packed` is `face_mesh_solution_packed_assets.data`.
///
/// # Errors
/// If the script does not list the files, a file has another SHA-256, or a conversion fails.
pub fn import(loader_js: &str, packed: &[u8]) -> Result<Networks, ImportError> {
    let package = Package::new(loader_js, packed)?;
    Ok(Networks {
        detector_onnx: onnx_from_tflite(package.file(DETECTOR_FILE, DETECTOR_SHA256)?)?,
        landmarks_onnx: onnx_from_tflite(package.file(LANDMARKS_FILE, LANDMARKS_SHA256)?)?,
        attention_onnx: onnx_of_part(
            package.file(ATTENTION_FILE, ATTENTION_SHA256)?,
            &ATTENTION_INPUTS,
            &ATTENTION_OUTPUTS,
        )?,
    })
}
