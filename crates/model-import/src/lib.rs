//! The published face networks, read out of the npm package `@mediapipe/face_mesh` and written as ONNX.
//!
//! Bytes in, bytes out: nothing here touches a file or the network. The package keeps its assets in one raw
//! concatenation and says in a loader script which bytes are which file; [`import`] cuts out the three TFLite networks,
//! checks them against their known SHA-256, and converts them mechanically:
//!
//! * NHWC becomes NCHW; a reshape of a picture-shaped tensor goes through a transpose back to NHWC, so that the order
//!   of the values in the outputs stays TFLite's.
//! * `SAME` padding becomes explicit pads (the `Window` of the `tflite` module).
//! * Half-precision weights stay half-precision in the file, each behind a `Cast`, so that detector and landmarks are about 1.5 MB.
//! * The network with attention has operators of MediaPipe's own, which cut turned regions out of its features. It is
//!   written without them: what comes before is the graph's trunk, what comes after are three heads, each with its own
//!   input; whoever runs it cuts out the regions in between.
//!
//! Opset 13. The picture comes in as f32 `[1, 3, side, side]`. Outputs, by name: for the detector `regressors`
//! `[1, 896, 16]` and `classificators` `[1, 896, 1]`; for the landmarks `conv2d_21` `[1, 1404, 1, 1]` and `conv2d_31`
//! `[1, 1, 1, 1]`. With attention: `output_mesh` `[1, 1404, 1, 1]`, `conv_faceflag` `[1, 1, 1, 1]` and the features
//! `p_re_lu_3` `[1, 32, 48, 48]`; of the inputs `transform_tensor_bilinear_v2`, `…_1` and `…_2` (`[1, 32, 16, 16]` each):
//! `conv_lips` `[1, 160, 1, 1]`, `conv_left_eye` `[1, 142, 1, 1]` and `conv_left_iris` `[1, 10, 1, 1]`, and the same of the
//! right eye, where left and right are the picture's.

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
    /// Picture 128² → 896 boxes with six key points each, and their scores.
    pub detector_onnx: Vec<u8>,
    /// Face 192² → 468 landmarks and the face flag.
    pub landmarks_onnx: Vec<u8>,
    /// Face 192² → 468 landmarks, the face flag and features; regions of the features → lips, eyes and irises.
    pub attention_onnx: Vec<u8>,
}

const DETECTOR_FILE: &str = "face_detection_short_range.tflite";
const DETECTOR_SHA256: &str = "3bc182eb9f33925d9e58b5c8d59308a760f4adea8f282370e428c51212c26633";
const LANDMARKS_FILE: &str = "face_landmark.tflite";
const LANDMARKS_SHA256: &str = "c603fa6149219a3e9487dc9abd7a0c24474c77263273d24868378cdf40aa26d1";
const ATTENTION_FILE: &str = "face_landmark_with_attention.tflite";
const ATTENTION_SHA256: &str = "883b7411747bac657c30c462d305d312e9dec6adbf8b85e2f5d8d722fca9455d";
/// The picture, and where the regions of lips and eyes come back in.
const ATTENTION_INPUTS: [&str; 4] =
    ["input_1", "transform_tensor_bilinear_v2", "transform_tensor_bilinear_v2_1", "transform_tensor_bilinear_v2_2"];
/// What the trunk finds, the features that the regions are cut out of, and what the three heads find.
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

/// Reads the networks out of the package's packed assets and converts them.
///
/// `loader_js` is `face_mesh_solution_packed_assets_loader.js`, `packed` is `face_mesh_solution_packed_assets.data`.
///
/// # Errors
/// If the script lists no such files, if a file is not the one known by its SHA-256, or if it cannot be converted.
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
