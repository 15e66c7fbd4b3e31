//! The camera that took the photo of a face: where it stood, and the landmarks as it saw them, taken apart into places.
//!
//! Positions are in px of the picture, right-handed: x to the right, y up, z towards the camera, 0 in the landmarks' mean.
//! A camera with a focal length of f px then stands at z = f before its principal point, and sees a point at (X, Y, z) where
//! a parallel one would see ((X − c) · f / (f − z) + c, …).

mod depth;
mod distance;
mod projection;

use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};

pub(crate) use depth::{CanonicalShape, turn_rad};
pub(crate) use distance::{Evidence, evidence};

use crate::PhotoLens;

/// The camera that took a photo of a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// What it was taken from; [`PhotoLens::Estimated`], too, where the photo's own lens data contradict the landmarks.
    pub lens: PhotoLens,
    /// In px of the photo; infinite for [`PhotoLens::Parallel`].
    pub focal_px: f64,
    /// Where its axis meets the photo, in px from the top left, y down.
    pub principal_px: DVec2,
    /// So many px of the photo are a metre as deep as the middle of the face.
    pub px_per_m: f64,
    /// From the camera to the middle of the face, in metres; infinite for [`PhotoLens::Parallel`].
    pub distance_m: f64,
    /// One standard deviation of the distance, as a share of it: from the landmarks' evidence where it was estimated, and
    /// from the size of the face.
    pub distance_error: f64,
    /// From the model's frame to the camera's: metres, +X right, +Y up, and the camera looks along −Z. Rotation and
    /// translation alone; for [`PhotoLens::Parallel`] the camera is put very far away.
    pub camera_from_model: DAffine3,
}

/// How a head is turned, in degrees, as its camera sees it: the rotation is yaw about +Y, then pitch about +X, then roll
/// about +Z, each in the frame that the one before it left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Positive where the subject looks to its own left, which is the picture's right.
    pub yaw_deg: f64,
    /// Positive where the subject looks down.
    pub pitch_deg: f64,
    /// Positive where the head is tilted to the picture's left, counter-clockwise.
    pub roll_deg: f64,
}

/// Where a camera is put that sees everything from infinitely far away, in m.
pub(crate) const PARALLEL_M: f64 = 1e6;

impl Camera {
    /// One that sees from infinitely far away, at so many px a metre, with the model turned by a rotation and moved aside by so
    /// many metres: to the right, up, and towards the camera.
    pub fn parallel(rotation: DMat3, aside_m: DVec3, px_per_m: f64, principal_px: DVec2) -> Self {
        Self {
            lens: PhotoLens::Parallel,
            focal_px: f64::INFINITY,
            principal_px,
            px_per_m,
            distance_m: f64::INFINITY,
            distance_error: 0.0,
            camera_from_model: DAffine3::from_mat3_translation(rotation, aside_m - DVec3::Z * PARALLEL_M),
        }
    }

    /// How the head is turned.
    pub fn pose(&self) -> Pose {
        let rotation = DQuat::from_mat3(&self.camera_from_model.matrix3);
        let (yaw, pitch, roll) = rotation.to_euler(glam::EulerRot::YXZ);
        Pose { yaw_deg: yaw.to_degrees(), pitch_deg: pitch.to_degrees(), roll_deg: roll.to_degrees() }
    }
}

/// Diagonal in mm of the frame that focal lengths are given for: 36 × 24 mm.
const FRAME_DIAGONAL_MM: f64 = 43.266_615_305_567_87;

/// The focal length in px of a lens that takes in as much as one of `focal_length_mm` before a frame of 36 × 24 mm, by the
/// diagonals.
pub(crate) fn focal_px(focal_length_mm: f64, [width, height]: [u32; 2]) -> f64 {
    focal_length_mm * f64::from(width).hypot(f64::from(height)) / FRAME_DIAGONAL_MM
}

/// Where a point that is seen at `seen_px` lies if its depth is `z_px`: on the ray from the camera through it.
pub(crate) fn unprojected(seen_px: DVec2, z_px: f64, focal_px: f64, principal_px: DVec2) -> DVec3 {
    ((seen_px - principal_px) * (1.0 - z_px / focal_px) + principal_px).extend(z_px)
}
