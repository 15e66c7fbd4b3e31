use glam::DVec3;

/// Where a camera is and looks, radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    pub target_m: DVec3,
    /// 0 looks at the face from +Z; positive from +X.
    pub azimuth: f64,
    /// Positive from above.
    pub elevation: f64,
    /// Above 1 is nearer than the distance that shows everything.
    pub zoom: f64,
}

impl Pose {
    pub fn home(centre_m: DVec3) -> Self {
        Self { target_m: centre_m, azimuth: 0.0, elevation: 0.0, zoom: 1.0 }
    }

    /// Unit vector from the target to the eye.
    pub fn back(&self) -> DVec3 {
        let (sin_azimuth, cos_azimuth) = self.azimuth.sin_cos();
        let (sin_elevation, cos_elevation) = self.elevation.sin_cos();
        DVec3::new(sin_azimuth * cos_elevation, sin_elevation, cos_azimuth * cos_elevation)
    }

    pub fn is_near(&self, other: &Self, radius_m: f64) -> bool {
        self.target_m.distance(other.target_m) < 1e-5 * radius_m
            && (self.azimuth - other.azimuth).abs() < 1e-5
            && (self.elevation - other.elevation).abs() < 1e-5
            && (self.zoom - other.zoom).abs() < 1e-5 * other.zoom
    }

    pub fn towards(&self, goal: &Self, share: f64) -> Self {
        Self {
            target_m: self.target_m.lerp(goal.target_m, share),
            azimuth: self.azimuth + (goal.azimuth - self.azimuth) * share,
            elevation: self.elevation + (goal.elevation - self.elevation) * share,
            zoom: self.zoom * (goal.zoom / self.zoom).powf(share),
        }
    }
}
