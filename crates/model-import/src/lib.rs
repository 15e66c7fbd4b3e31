//! The published face networks, read out of the npm package `@mediapipe/face_mesh` and written as ONNX.
//!
//! Bytes in, bytes out: nothing here touches a file or the network. The package keeps its assets in one raw
//! concatenation and says in a loader script which bytes are which file; [`import`] cuts out the two TFLite networks,
//! checks them against their known SHA-256, and converts them mechanically:
//!
//! * NHWC becomes NCHW; a reshape of a picture-shaped tensor goes through a transpose back to NHWC, so that the order
//!   of the values in the outputs stays TFLite's.
//! * `SAME` padding becomes explicit pads (the `Window` of the `tflite` module).
//! * Half-precision weights stay half-precision in the file, each behind a `Cast`, so that the pair is about 1.5 MB.
//!
//! Opset 13. The one input is f32 `[1, 3, side, side]`. Outputs, by name: for the detector `regressors` `[1, 896, 16]` and
//! `classificators` `[1, 896, 1]`; for the landmarks `conv2d_21` `[1, 1404, 1, 1]` and `conv2d_31` `[1, 1, 1, 1]`.

mod convert;
mod error;
mod flatbuffer;
mod onnx;
mod package;
#[cfg(test)]
#[path = "../tests/support/mod.rs"]
mod support;
mod tflite;

pub use convert::onnx_from_tflite;
pub use error::ImportError;

use package::Package;

/// The two networks as ONNX files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Networks {
    /// Picture 128² → 896 boxes with six key points each, and their scores.
    pub detector_onnx: Vec<u8>,
    /// Face 192² → 468 landmarks and the face flag.
    pub landmarks_onnx: Vec<u8>,
}

const DETECTOR_FILE: &str = "face_detection_short_range.tflite";
const DETECTOR_SHA256: &str = "3bc182eb9f33925d9e58b5c8d59308a760f4adea8f282370e428c51212c26633";
const LANDMARKS_FILE: &str = "face_landmark.tflite";
const LANDMARKS_SHA256: &str = "c603fa6149219a3e9487dc9abd7a0c24474c77263273d24868378cdf40aa26d1";

/// Reads both networks out of the package's packed assets and converts them.
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
    })
}
