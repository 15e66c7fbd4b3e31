use glam::{DVec2, DVec3};

use super::observed::{fit_to, in_px};
use crate::camera::Camera;
use crate::{FaceError, LANDMARK_COUNT};

/// Fit of a known face to a video frame, which may show another expression and pose.
#[derive(Debug, Clone)]
pub struct PoseFit {
    /// Parallel camera: orientation, position and scale of the head in the frame.
    pub camera: Camera,
    /// The frame's 468 landmarks in the known face's frame, in metres.
    pub positions_m: Vec<DVec3>,
}

impl PoseFit {
    /// Fits 468 known landmarks, in metres in the model's frame, to those found in a frame of `size_px`.
    ///
    /// Solves the weighted Procrustes problem of [`FaceModel::new`](crate::FaceModel::new), with the known face instead
    /// of the canonical one. Perspective is ignored, which is accurate enough for video and faster.
    ///
    /// # Errors
    /// See [`check_landmarks`](crate::check_landmarks); [`FaceError::WrongCount`] if there are not 468 known landmarks.
    pub fn new(known_m: &[DVec3], landmarks: &[[f32; 3]], size_px: [u32; 2]) -> Result<Self, FaceError> {
        super::check_count("landmarks", LANDMARK_COUNT, known_m.len())?;
        let seen = in_px(landmarks, size_px)?;
        let px_from_model = fit_to(known_m, &seen)?;
        let model_from_px = px_from_model.inverse();
        let centre_px = DVec2::from(size_px.map(f64::from)) / 2.0;
        let offset_px = px_from_model.translation - DVec3::new(centre_px.x, -centre_px.y, 0.0);
        let px_per_m = px_from_model.scale;
        let camera = Camera::parallel(px_from_model.rotation, offset_px / px_per_m, px_per_m, centre_px);
        let positions_m = seen[..LANDMARK_COUNT].iter().map(|&point| model_from_px.apply(point)).collect();
        Ok(Self { camera, positions_m })
    }
}
