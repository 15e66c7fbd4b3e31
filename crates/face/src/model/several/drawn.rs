use glam::DVec3;

use super::habits;
use crate::model::fitting::Fitted;

/// The rays of the photo that leads, on which its landmarks lie.
pub(super) struct Rays {
    /// Where the landmarks lie by that photo alone.
    pub(super) places_m: Vec<DVec3>,
    /// Where each goes in m for each m that it comes nearer.
    pub(super) ways: Vec<DVec3>,
}

impl Rays {
    pub(super) fn of(lead: &Fitted) -> Self {
        let camera = &lead.camera;
        let eye_m = camera.camera_from_model.inverse().translation;
        let way = |&place_m: &DVec3| (eye_m - place_m) / -camera.towards_camera_m(place_m);
        Self { places_m: lead.landmarks_m().to_vec(), ways: lead.landmarks_m().iter().map(way).collect() }
    }

    /// The shape as the network draws it from the side, with each landmark nearer by so many metres.
    pub(super) fn drawn_nearer_m(&self, nearer_m: &[f64]) -> Vec<DVec3> {
        let rays = self.places_m.iter().zip(&self.ways).zip(nearer_m.iter().zip(habits::all_drawn_out_m()));
        rays.map(|((&place_m, &way), (nearer_m, drawn_out_m))| place_m + way * (nearer_m + drawn_out_m)).collect()
    }

    /// The shape as the network draws it from the side.
    pub(super) fn drawn_m(&self) -> Vec<DVec3> {
        self.drawn_nearer_m(&vec![0.0; self.places_m.len()])
    }
}
