use glam::{DVec2, DVec3};

use super::Camera;

/// Projection and distance changes.
impl Camera {
    /// Projects a point of the model to px of the photo, y down; `None` if it is not in front of the camera.
    pub fn project(&self, position_m: DVec3) -> Option<DVec2> {
        let seen_m = self.camera_from_model.transform_point3(position_m);
        let px_per_m = match self.focal_px.is_finite() {
            true => self.focal_px / -seen_m.z,
            false => self.px_per_m,
        };
        let projected_px = self.principal_px + DVec2::new(seen_m.x, -seen_m.y) * px_per_m;
        (seen_m.z < 0.0 && projected_px.is_finite()).then_some(projected_px)
    }

    /// z of a point in the camera's frame, in metres: negative in front of the camera, larger when nearer.
    pub fn towards_camera_m(&self, position_m: DVec3) -> f64 {
        self.camera_from_model.transform_point3(position_m).z
    }

    /// Moves the camera to another distance, with a focal length and lens shift that keep the plane of `pivot_m`
    /// unchanged in the photo (a dolly zoom).
    ///
    /// Let the pivot be at P in the camera's frame, and the distance change by a factor k. The pivot moves to k·P, and
    /// the focal length becomes k·f. A point P + (x, y, 0) is then seen at (k·P.x + x) · k·f / (k·|P.z|), which differs
    /// from before by the same amount for all x. The lens shift removes that difference.
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
        let offset = DVec2::new(moved_m.x, -moved_m.y) * (focal_px / -moved_m.z);
        camera.principal_px = pivot_px - offset;
        camera
    }
}
