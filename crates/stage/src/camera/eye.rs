use glam::{DVec2, DVec3};

/// Where the eye is, seen from the middle of what is framed. The picture lies on the plane through that middle.
///
/// View coordinates are metres from the middle: to the right and up in the picture, and towards the viewer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Eye {
    /// One by its distance from that plane; 0 for an eye infinitely far away, which sees without perspective.
    pub nearness_per_m: f64,
    /// How far it is to the right of the middle and above it, by its distance from the plane.
    pub aside: DVec2,
}

impl Eye {
    /// One straight before the middle.
    pub fn before(distance_m: f64) -> Self {
        Self { nearness_per_m: distance_m.recip(), aside: DVec2::ZERO }
    }

    /// How far a depth is from the eye, by how far the plane is: 1 on the plane, 0 at the eye.
    pub fn remoteness(&self, depth_m: f64) -> f64 {
        1.0 - self.nearness_per_m * depth_m
    }

    /// Where on the plane a point is seen, in metres from the middle. With D the distance and e the eye's place on the plane,
    /// (p·D − e·z) / (D − z), which has a limit for D → ∞ when e grows along.
    pub fn on_plane_m(&self, view_m: DVec3) -> DVec2 {
        // What is beside the eye or behind it has no place; what is steered by one stays finite.
        (view_m.truncate() - self.aside * view_m.z) / self.remoteness(view_m.z).max(1e-3)
    }

    /// The point at a depth that is seen at a place on the plane, in view coordinates.
    pub fn at_depth_m(&self, plane_m: DVec2, depth_m: f64) -> DVec3 {
        (plane_m * self.remoteness(depth_m) + self.aside * depth_m).extend(depth_m)
    }

    /// The way from the eye through a place on the plane, of any length.
    pub fn through(&self, plane_m: DVec2) -> DVec3 {
        (plane_m * self.nearness_per_m - self.aside).extend(-1.0)
    }

    /// Middle and half size of the box on the plane around a sphere of that radius around the middle.
    ///
    /// Of the lines from the eye through x on the plane, with direction (k·x − a, −1), those that pass the middle at the
    /// radius R touch the sphere: x² = R²·((k·x − a)² + 1).
    pub fn silhouette_m(&self, radius_m: f64) -> (DVec2, DVec2) {
        let sine_squared = (self.nearness_per_m * radius_m).powi(2).min(0.9);
        let scale = radius_m / (1.0 - sine_squared);
        let root = |aside: f64| (aside * aside + 1.0 - sine_squared).sqrt();
        let half_m = DVec2::new(root(self.aside.x), root(self.aside.y)) * scale;
        (self.aside * (-self.nearness_per_m * radius_m * scale), half_m)
    }

    pub fn is_near(&self, other: &Self, radius_m: f64) -> bool {
        (self.nearness_per_m - other.nearness_per_m).abs() * radius_m < 1e-5 && self.aside.distance(other.aside) < 1e-5
    }

    pub fn towards(&self, goal: &Self, share: f64) -> Self {
        Self {
            nearness_per_m: self.nearness_per_m + (goal.nearness_per_m - self.nearness_per_m) * share,
            aside: self.aside.lerp(goal.aside, share),
        }
    }
}
