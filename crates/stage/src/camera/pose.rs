use glam::DVec3;

use super::eye::Eye;
use super::facing::Facing;

/// State of the camera: target, direction, eye and zoom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    /// Point at the centre of the visible area.
    pub target_m: DVec3,
    pub facing: Facing,
    pub eye: Eye,
    /// Radius of the framed sphere.
    pub radius_m: f64,
    /// Magnification; 1 shows the whole sphere.
    pub zoom: f64,
}

impl Pose {
    pub fn is_near(&self, other: &Self) -> bool {
        self.target_m.distance(other.target_m) < 1e-5 * self.radius_m
            && self.facing.is_near(&other.facing)
            && self.eye.is_near(&other.eye, self.radius_m)
            && (self.radius_m - other.radius_m).abs() < 1e-5 * other.radius_m
            && (self.zoom - other.zoom).abs() < 1e-5 * other.zoom
    }

    pub fn towards(&self, goal: &Self, share: f64) -> Self {
        let mix = |from: f64, to: f64| from * (to / from).powf(share);
        Self {
            target_m: self.target_m.lerp(goal.target_m, share),
            facing: self.facing.towards(&goal.facing, share),
            eye: self.eye.towards(&goal.eye, share),
            radius_m: mix(self.radius_m, goal.radius_m),
            zoom: mix(self.zoom, goal.zoom),
        }
    }

    /// Transfers a pose relative to `from` to one relative to `to`, preserving offset on the screen and relative zoom.
    pub fn carried(&self, from: &Self, to: &Self) -> Self {
        let lateral_m = from.facing.axes().transpose() * (self.target_m - from.target_m);
        let larger = to.zoom / from.zoom;
        let mix = |own: f64, from: f64, to: f64| own + (to - from);
        Self {
            target_m: to.target_m + to.facing.axes() * lateral_m / larger,
            facing: Facing {
                azimuth: mix(self.facing.azimuth, from.facing.azimuth, to.facing.azimuth),
                elevation: mix(self.facing.elevation, from.facing.elevation, to.facing.elevation),
                roll: mix(self.facing.roll, from.facing.roll, to.facing.roll),
            },
            eye: Eye {
                nearness_per_m: mix(self.eye.nearness_per_m, from.eye.nearness_per_m, to.eye.nearness_per_m),
                lateral: self.eye.lateral + (to.eye.lateral - from.eye.lateral),
            },
            radius_m: self.radius_m,
            zoom: self.zoom * larger,
        }
    }
}
