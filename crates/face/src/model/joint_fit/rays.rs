use glam::DVec3;

use super::bias;
use crate::model::fitting::Fitted;

/// Rays of the lead photo, on which the landmarks lie.
pub(super) struct Rays {
    /// Positions of the landmarks from that photo alone.
    pub(super) positions_m: Vec<DVec3>,
    /// Displacement of each landmark per metre towards the camera.
    pub(super) directions: Vec<DVec3>,
}

impl Rays {
    pub(super) fn of(lead: &Fitted) -> Self {
        let camera = &lead.camera;
        let eye_m = camera.camera_from_model.inverse().translation;
        let direction = |&position_m: &DVec3| (eye_m - position_m) / -camera.towards_camera_m(position_m);
        Self {
            positions_m: lead.landmarks_m().to_vec(),
            directions: lead.landmarks_m().iter().map(direction).collect(),
        }
    }

    /// The shape as the network shows it in turned photos, with each landmark moved nearer by `nearer_m`.
    pub(super) fn biased_nearer_m(&self, nearer_m: &[f64]) -> Vec<DVec3> {
        let rays = self.positions_m.iter().zip(&self.directions).zip(nearer_m.iter().zip(bias::depth_biases_m()));
        rays.map(|((&position_m, &direction), (nearer_m, depth_bias_m))| {
            position_m + direction * (nearer_m + depth_bias_m)
        })
        .collect()
    }

    /// The shape as the network shows it in turned photos.
    pub(super) fn biased_m(&self) -> Vec<DVec3> {
        self.biased_nearer_m(&vec![0.0; self.positions_m.len()])
    }
}
