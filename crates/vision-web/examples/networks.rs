//! The bare networks, for `tests/bench/browser.mjs`, which compares them with onnxruntime-web.

use std::hint::black_box;

use rosto_landmarks::Network;
use wasm_bindgen::prelude::*;

/// Both networks, loaded.
#[wasm_bindgen]
pub struct Networks {
    detector: Network,
    landmarks: Network,
}

#[wasm_bindgen]
impl Networks {
    /// Loads the networks from their ONNX files.
    #[wasm_bindgen(constructor)]
    pub fn new(detector: &[u8], landmarks: &[u8]) -> Result<Networks, JsError> {
        Ok(Self {
            detector: Network::of_picture("detector", detector, 128, &["regressors", "classificators"])?,
            landmarks: Network::of_picture("landmark", landmarks, 192, &["conv2d_21", "conv2d_31"])?,
        })
    }

    /// Runs the detector on three planes of 128 × 128.
    pub fn detect(&self, planes: &[f32]) -> Result<(), JsError> {
        black_box(self.detector.run(|_, input| input.copy_from_slice(planes), [896 * 16, 896])?);
        Ok(())
    }

    /// Runs the landmark network on three planes of 192 × 192.
    pub fn mesh(&self, planes: &[f32]) -> Result<(), JsError> {
        black_box(self.landmarks.run(|_, input| input.copy_from_slice(planes), [468 * 3, 1])?);
        Ok(())
    }
}
