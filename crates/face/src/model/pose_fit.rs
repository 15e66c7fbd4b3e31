use glam::{DVec2, DVec3};

use super::seen::{fit_to, in_px};
use crate::camera::Camera;
use crate::{FaceError, LANDMARK_COUNT};

/// A face that is known, as one frame of a film shows it: with another expression, elsewhere and turned.
#[derive(Debug, Clone)]
pub struct PoseFit {
    /// What sees it, from infinitely far away: how the head is turned, where it is in the frame, and how large.
    pub camera: Camera,
    /// The frame's 468 landmarks in the frame of the face that is known, in metres of that face.
    pub positions_m: Vec<DVec3>,
}

impl PoseFit {
    /// Fits the 468 landmarks that are known, in metres in the model's frame, to those that a frame of `size_px` shows: the
    /// weighted Procrustes problem of [`FaceModel::new`](crate::FaceModel::new), with the face itself in place of the
    /// canonical one. No perspective is taken out: in a film that would cost more than it shows.
    ///
    /// # Errors
    /// As [`check_landmarks`](crate::check_landmarks), and [`FaceError::WrongCount`] if there are not 468 that are known.
    pub fn new(known_m: &[DVec3], landmarks: &[[f32; 3]], size_px: [u32; 2]) -> Result<Self, FaceError> {
        super::check_count("landmarks", LANDMARK_COUNT, known_m.len())?;
        let seen = in_px(landmarks, size_px)?;
        let px_from_model = fit_to(known_m, &seen)?;
        let model_from_px = px_from_model.inverse();
        let middle_px = DVec2::from(size_px.map(f64::from)) / 2.0;
        let aside_px = px_from_model.translation - DVec3::new(middle_px.x, -middle_px.y, 0.0);
        let px_per_m = px_from_model.scale;
        let camera = Camera::parallel(px_from_model.rotation, aside_px / px_per_m, px_per_m, middle_px);
        let positions_m = seen[..LANDMARK_COUNT].iter().map(|&point| model_from_px.apply(point)).collect();
        Ok(Self { camera, positions_m })
    }
}
