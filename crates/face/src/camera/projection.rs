use glam::{DVec2, DVec3};

use super::Camera;

/// What a camera makes of places in the model.
impl Camera {
    /// Where it sees a place, in px of the photo, y down; what is beside it or behind it is nowhere.
    pub fn project(&self, place_m: DVec3) -> Option<DVec2> {
        let seen_m = self.camera_from_model.transform_point3(place_m);
        let px_per_m = match self.focal_px.is_finite() {
            true => self.focal_px / -seen_m.z,
            false => self.px_per_m,
        };
        let place_px = self.principal_px + DVec2::new(seen_m.x, -seen_m.y) * px_per_m;
        (seen_m.z < 0.0 && place_px.is_finite()).then_some(place_px)
    }

    /// How far a place is from it along its axis, with the sign of what lies before it, in metres: larger is nearer.
    pub fn towards_camera_m(&self, place_m: DVec3) -> f64 {
        self.camera_from_model.transform_point3(place_m).z
    }

    /// The same camera gone back, or come nearer, to a distance, and its lens changed and shifted so that all that lies as
    /// deep as `pivot_m` stays where it is in the photo, as large as it is.
    ///
    /// With the pivot at P in the camera's frame and the distance k times as long, the camera stands so that the pivot is at
    /// k·P, and has k times the focal length: a place at P + (x, y, 0) is then at (k·P.x + x) · k·f / (k·|P.z|), which differs
    /// from where it was by the same for all x. The shift of the lens takes that back.
    pub fn at_distance(&self, distance_m: f64, pivot_m: DVec3) -> Self {
        let Some(pivot_px) = self.project(pivot_m) else { return *self };
        let seen_m = self.camera_from_model.transform_point3(pivot_m);
        let is_parallel = !self.focal_px.is_finite();
        let (moved_m, focal_px) = match is_parallel {
            true => (DVec3::new(0.0, 0.0, -distance_m), self.px_per_m * distance_m),
            false => (seen_m * (distance_m / self.distance_m), self.focal_px * distance_m / self.distance_m),
        };
        let mut camera = *self;
        camera.camera_from_model.translation += moved_m - seen_m;
        (camera.focal_px, camera.distance_m) = (focal_px, distance_m);
        let aside = DVec2::new(moved_m.x, -moved_m.y) * (focal_px / -moved_m.z);
        camera.principal_px = pivot_px - aside;
        camera
    }
}
