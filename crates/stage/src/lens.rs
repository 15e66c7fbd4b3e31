use glam::{DAffine3, DVec3};

use crate::camera::{Eye, Facing};

rosto_mesh::named! {
    /// Viewing distance, which sets the strength of the perspective. The apparent size is set by the zoom.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Lens {
        /// 1.5 m, as for portraits.
        #[default]
        Portrait = "portrait",
        /// Infinite: parallel projection.
        Parallel = "parallel",
        /// 0.5 m, an arm's length.
        Near = "near",
        /// Distance and pose from which the picture on the mesh was taken ([`Pinhole`]); without a pinhole the same as
        /// [`Self::Portrait`].
        AsTaken = "as-taken",
    }
}

/// Minimum distance of a lens' eye from the centre, in radii.
const MIN_RADII: f64 = 2.5;

/// Minimum distance of a pinhole from the centre, in radii; closer ones are ignored.
const MIN_RADII_OF_PINHOLE: f64 = 1.1;

impl Lens {
    /// Eye for a sphere of this radius, without a pinhole.
    pub(crate) fn eye(self, radius_m: f64) -> Eye {
        let distance_m = match self {
            Self::Portrait | Self::AsTaken => 1.5,
            Self::Near => 0.5,
            Self::Parallel => f64::INFINITY,
        };
        Eye::before(distance_m.max(MIN_RADII * radius_m))
    }
}

/// Pose of the camera that took the picture on a mesh.
///
/// A pinhole projects to (cx + f·X/−Z, cy − f·Y/−Z) in px. Focal length f and principal point (cx, cy) only scale and
/// shift the picture, as framing does, so they are not needed here.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pinhole {
    /// Rigid transform in metres; camera axes are +X right, +Y up, with the view along −Z.
    pub camera_from_model: DAffine3,
}

impl Pinhole {
    /// Eye and orientation relative to a sphere; `None` if the pinhole is not in front of it or too close.
    pub(crate) fn before(&self, centre_m: DVec3, radius_m: f64) -> Option<(Eye, Facing)> {
        let eye_m = -self.camera_from_model.transform_point3(centre_m);
        let model_from_camera = self.camera_from_model.matrix3.transpose();
        let eye = Eye { nearness_per_m: eye_m.z.recip(), lateral: eye_m.truncate() / eye_m.z };
        let facing = Facing::of_axes(model_from_camera.x_axis, model_from_camera.y_axis, model_from_camera.z_axis);
        (eye_m.z > MIN_RADII_OF_PINHOLE * radius_m && eye_m.is_finite()).then_some((eye, facing))
    }
}
