//! The camera that took the photo of a face, and unprojection of the landmarks.
//!
//! Positions are in px of the picture, right-handed: x to the right, y up, z towards the camera, 0 at the landmarks'
//! mean. A camera with a focal length of f px is at z = f on the axis through its principal point c. It sees a point
//! whose parallel projection is (X, Y), at depth z, at ((X − c) · f / (f − z) + c, …).

mod depth;
mod distance;
mod projection;

use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};

pub(crate) use depth::CanonicalShape;
pub(crate) use distance::{Distance, estimated, interval_m, log_interval, turn_rad};

use crate::PhotoLens;

/// Intrinsics and pose of the camera that took a photo of a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Lens data that the camera was derived from; [`PhotoLens::Estimated`] if the photo's own are implausible.
    pub lens: PhotoLens,
    /// Focal length in px of the photo; infinite for [`PhotoLens::Parallel`].
    pub focal_px: f64,
    /// Principal point in px from the top left, y down.
    pub principal_px: DVec2,
    /// Scale at the depth of the face's centre, in px of the photo per metre.
    pub px_per_m: f64,
    /// Distance from the camera to the face's centre, in metres; infinite for [`PhotoLens::Parallel`].
    pub distance_m: f64,
    /// 90 % interval of the distance, in metres: from the landmarks if it was estimated, and from the size of the face.
    pub distance_interval_m: [f64; 2],
    /// Rigid transform from the model's frame to the camera's: metres, +X right, +Y up, looking along −Z. For
    /// [`PhotoLens::Parallel`] the camera is placed very far away.
    pub camera_from_model: DAffine3,
}

/// Orientation of a head relative to its camera, in degrees: yaw about +Y, then pitch about +X, then roll about +Z,
/// each in the rotated frame (intrinsic).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Positive if the subject looks to its own left, the picture's right.
    pub yaw_deg: f64,
    /// Positive if the subject looks down.
    pub pitch_deg: f64,
    /// Positive if the head is tilted to the picture's left, counter-clockwise.
    pub roll_deg: f64,
}

/// Distance at which a parallel camera is placed, in metres.
pub(crate) const PARALLEL_M: f64 = 1e6;

impl Camera {
    /// A parallel camera, `px_per_m` in scale, with the model rotated and then shifted by `offset_m`: to the right, up,
    /// and towards the camera.
    pub fn parallel(rotation: DMat3, offset_m: DVec3, px_per_m: f64, principal_px: DVec2) -> Self {
        Self {
            lens: PhotoLens::Parallel,
            focal_px: f64::INFINITY,
            principal_px,
            px_per_m,
            distance_m: f64::INFINITY,
            distance_interval_m: [f64::INFINITY; 2],
            camera_from_model: DAffine3::from_mat3_translation(rotation, offset_m - DVec3::Z * PARALLEL_M),
        }
    }

    /// Orientation of the head.
    pub fn pose(&self) -> Pose {
        let rotation = DQuat::from_mat3(&self.camera_from_model.matrix3);
        let (yaw, pitch, roll) = rotation.to_euler(glam::EulerRot::YXZ);
        Pose { yaw_deg: yaw.to_degrees(), pitch_deg: pitch.to_degrees(), roll_deg: roll.to_degrees() }
    }
}

/// Diagonal of the 36 × 24 mm frame, in mm.
const FRAME_DIAGONAL_MM: f64 = 43.266_615_305_567_87;

/// Focal length in px of a lens with a 35-mm-equivalent focal length of `focal_length_mm`, matched by the frame's
/// diagonal.
pub(crate) fn focal_px(focal_length_mm: f64, [width, height]: [u32; 2]) -> f64 {
    focal_length_mm * f64::from(width).hypot(f64::from(height)) / FRAME_DIAGONAL_MM
}

/// Unprojects a point seen at `seen_px` to the depth `z_px`, on its ray from the camera.
pub(crate) fn unprojected(seen_px: DVec2, z_px: f64, focal_px: f64, principal_px: DVec2) -> DVec3 {
    ((seen_px - principal_px) * (1.0 - z_px / focal_px) + principal_px).extend(z_px)
}
