use glam::{DVec2, DVec3};

/// Position of the eye relative to the framed centre. The picture plane passes through that centre.
///
/// View coordinates are metres from the centre: right, up, and towards the viewer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Eye {
    /// Inverse distance of the eye from the plane; 0 for parallel projection.
    pub nearness_per_m: f64,
    /// Position of the eye right of and above the centre, divided by its distance from the plane.
    pub lateral: DVec2,
}

impl Eye {
    /// An eye straight in front of the centre.
    pub fn before(distance_m: f64) -> Self {
        Self { nearness_per_m: distance_m.recip(), lateral: DVec2::ZERO }
    }

    /// Relative distance of a depth from the eye: 1 on the plane, 0 at the eye.
    pub fn relative_distance(&self, depth_m: f64) -> f64 {
        1.0 - self.nearness_per_m * depth_m
    }

    /// Projection of a point to the plane, in metres from the centre. With the eye at distance D and lateral position
    /// e: (p·D − e·z) / (D − z), which has a limit for D → ∞ with e/D constant.
    pub fn on_plane_m(&self, view_m: DVec3) -> DVec2 {
        // Points at or behind the eye have no projection; the bound keeps the result finite.
        (view_m.truncate() - self.lateral * view_m.z) / self.relative_distance(view_m.z).max(1e-3)
    }

    /// The point at a depth that projects to a position on the plane, in view coordinates.
    pub fn at_depth_m(&self, plane_m: DVec2, depth_m: f64) -> DVec3 {
        (plane_m * self.relative_distance(depth_m) + self.lateral * depth_m).extend(depth_m)
    }

    /// Direction from the eye through a position on the plane, not normalised.
    pub fn through(&self, plane_m: DVec2) -> DVec3 {
        (plane_m * self.nearness_per_m - self.lateral).extend(-1.0)
    }

    /// Centre and half size of the bounding box, on the plane, of a sphere around the centre.
    ///
    /// A ray from the eye through x on the plane, with direction (k·x − a, −1), is tangent to the sphere of radius R if
    /// x² = R²·((k·x − a)² + 1).
    pub fn silhouette_m(&self, radius_m: f64) -> (DVec2, DVec2) {
        let sine_squared = (self.nearness_per_m * radius_m).powi(2).min(0.9);
        let scale = radius_m / (1.0 - sine_squared);
        let root = |lateral: f64| (lateral * lateral + 1.0 - sine_squared).sqrt();
        let half_m = DVec2::new(root(self.lateral.x), root(self.lateral.y)) * scale;
        (self.lateral * (-self.nearness_per_m * radius_m * scale), half_m)
    }

    pub fn is_near(&self, other: &Self, radius_m: f64) -> bool {
        (self.nearness_per_m - other.nearness_per_m).abs() * radius_m < 1e-5
            && self.lateral.distance(other.lateral) < 1e-5
    }

    pub fn towards(&self, goal: &Self, share: f64) -> Self {
        Self {
            nearness_per_m: self.nearness_per_m + (goal.nearness_per_m - self.nearness_per_m) * share,
            lateral: self.lateral.lerp(goal.lateral, share),
        }
    }
}
