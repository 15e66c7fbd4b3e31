//! The face networks: names of their files and, with the feature `embed-networks`, the networks themselves.

use rosto_landmarks::LandmarkNetwork;
#[cfg(feature = "embed-networks")]
use rosto_landmarks::{FaceFinder, LandmarksError};

/// File name of the detector.
pub const DETECTOR: &str = "face_detector.onnx";

/// Choice of the landmark network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Landmarks {
    /// 468 landmarks.
    Plain,
    /// 478 landmarks, with refined lips, eyes and irises.
    Attention,
}

impl Landmarks {
    /// File name of the network.
    pub fn file(self) -> &'static str {
        match self {
            Self::Plain => "face_landmarks.onnx",
            Self::Attention => "face_landmarks_attention.onnx",
        }
    }

    /// The network, from the bytes of its file.
    pub fn network(self, onnx: &[u8]) -> LandmarkNetwork<'_> {
        match self {
            Self::Plain => LandmarkNetwork::Plain(onnx),
            Self::Attention => LandmarkNetwork::Attention(onnx),
        }
    }
}

/// A finder with the embedded networks.
///
/// # Errors
/// [`LandmarksError`] if the networks were damaged before the build.
#[cfg(feature = "embed-networks")]
pub fn embedded(landmarks: Landmarks) -> Result<FaceFinder, LandmarksError> {
    const ONNX: [&[u8]; 3] = [
        include_bytes!("../../../web/assets/face_detector.onnx"),
        include_bytes!("../../../web/assets/face_landmarks.onnx"),
        include_bytes!("../../../web/assets/face_landmarks_attention.onnx"),
    ];
    let [detector, plain, attention] = ONNX;
    let onnx = match landmarks {
        Landmarks::Plain => plain,
        Landmarks::Attention => attention,
    };
    FaceFinder::new(detector, landmarks.network(onnx))
}
