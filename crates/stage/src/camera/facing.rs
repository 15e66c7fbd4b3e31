use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DMat3, DVec3};

/// Angles, in radians, at which a turn begins to hide the picture behind the mesh, and at which it has hidden it.
const NEAR: f64 = 0.05;
const FAR: f64 = 0.5;

/// Viewing direction as angles in radians.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Facing {
    /// 0 looks from +Z; positive looks from +X.
    pub azimuth: f64,
    /// Positive looks from above.
    pub elevation: f64,
    /// Rotation of the camera to its left around the optical axis: positive tilts the picture to the right.
    pub roll: f64,
}

impl Facing {
    /// Just below vertical, so that the up direction stays defined.
    pub const MAX_ELEVATION: f64 = FRAC_PI_2 - 1e-3;

    /// Angles of a camera with these orthonormal axes.
    pub fn of_axes(right: DVec3, up: DVec3, back: DVec3) -> Self {
        let upright = Self { azimuth: back.x.atan2(back.z), elevation: back.y.clamp(-1.0, 1.0).asin(), roll: 0.0 };
        Self { roll: upright.axes().x_axis.dot(-up).atan2(upright.axes().x_axis.dot(right)), ..upright }
    }

    /// Axes of the camera in the model's frame: right, up, and back towards the viewer.
    pub fn axes(&self) -> DMat3 {
        let (sin_azimuth, cos_azimuth) = self.azimuth.sin_cos();
        let (sin_elevation, cos_elevation) = self.elevation.sin_cos();
        let back = DVec3::new(sin_azimuth * cos_elevation, sin_elevation, cos_azimuth * cos_elevation);
        let level = DVec3::new(cos_azimuth, 0.0, -sin_azimuth);
        let (sin_roll, cos_roll) = self.roll.sin_cos();
        let right = level * cos_roll + back.cross(level) * sin_roll;
        DMat3::from_cols(right, back.cross(right), back)
    }

    /// The same orientation with angles nearest to those of `other`.
    pub fn nearest_to(&self, other: &Self) -> Self {
        let near = |angle: f64, to: f64| angle + ((to - angle) / TAU).round() * TAU;
        Self { azimuth: near(self.azimuth, other.azimuth), roll: near(self.roll, other.roll), ..*self }
    }

    /// Turned around the upright axis.
    pub fn turned(self, radians: f64) -> Self {
        Self { azimuth: self.azimuth + radians, ..self }
    }

    /// Whether another direction is turned away from this one: 0 up to [`NEAR`], 1 from [`FAR`], smooth in between.
    pub fn turned_share(&self, other: &Self) -> f64 {
        let cosine = self.axes().z_axis.dot(other.axes().z_axis).clamp(-1.0, 1.0);
        let share = ((cosine.acos() - NEAR) / (FAR - NEAR)).clamp(0.0, 1.0);
        share * share * (3.0 - 2.0 * share)
    }

    pub fn is_near(&self, other: &Self) -> bool {
        let apart = [self.azimuth - other.azimuth, self.elevation - other.elevation, self.roll - other.roll];
        apart.into_iter().all(|radians| radians.abs() < 1e-5)
    }

    pub fn towards(&self, goal: &Self, share: f64) -> Self {
        let mix = |from: f64, to: f64| from + (to - from) * share;
        Self {
            azimuth: mix(self.azimuth, goal.azimuth),
            elevation: mix(self.elevation, goal.elevation),
            roll: mix(self.roll, goal.roll),
        }
    }
}
