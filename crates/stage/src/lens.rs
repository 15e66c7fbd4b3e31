use glam::{DAffine3, DVec3};

use crate::camera::{Eye, Facing};

rosto_mesh::named! {
    /// From how far away something is seen, and so how strong the perspective is. How large it appears is the zoom's.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Lens {
        /// From 1.5 m, as portraits are taken.
        #[default]
        Portrait = "portrait",
        /// From infinitely far: what is as large appears as large, however deep it lies.
        Parallel = "parallel",
        /// From half a metre, an arm's length.
        Near = "near",
        /// From where the picture on the mesh was taken, as its [`Pinhole`] tells; as a portrait while there is none.
        AsTaken = "as-taken",
    }
}

/// No eye of a named distance comes nearer to the middle of what is framed than so many of its radii.
const LEAST_RADII: f64 = 2.5;

/// A pinhole inside what is framed, or hardly out of it, shows nothing that could be framed.
const LEAST_RADII_OF_PINHOLE: f64 = 1.1;

impl Lens {
    /// The eye of a lens that stands by itself, for a sphere of that radius.
    pub(crate) fn eye(self, radius_m: f64) -> Eye {
        let distance_m = match self {
            Self::Portrait | Self::AsTaken => 1.5,
            Self::Near => 0.5,
            Self::Parallel => f64::INFINITY,
        };
        Eye::before(distance_m.max(LEAST_RADII * radius_m))
    }
}

/// The camera that took the picture on a mesh: where it stood, and how it was held.
///
/// A pinhole's picture is (cx + f·X/−Z, cy − f·Y/−Z) in px. Focal length f and principal point (cx, cy) only scale and shift
/// it, as framing does anyway: they are not needed to see a mesh as it did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pinhole {
    /// Rigid, metres; the camera's axes are +X right, +Y up, and it looks along −Z.
    pub camera_from_model: DAffine3,
}

impl Pinhole {
    /// Its eye and how it faces a sphere; none if it is not well in front of it.
    pub(crate) fn before(&self, centre_m: DVec3, radius_m: f64) -> Option<(Eye, Facing)> {
        let eye_m = -self.camera_from_model.transform_point3(centre_m);
        let model_from_camera = self.camera_from_model.matrix3.transpose();
        let eye = Eye { nearness_per_m: eye_m.z.recip(), aside: eye_m.truncate() / eye_m.z };
        let facing = Facing::of_axes(model_from_camera.x_axis, model_from_camera.y_axis, model_from_camera.z_axis);
        (eye_m.z > LEAST_RADII_OF_PINHOLE * radius_m && eye_m.is_finite()).then_some((eye, facing))
    }
}
