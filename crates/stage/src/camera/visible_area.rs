use glam::DVec2;

/// The part of the picture that nothing lies over, in shares of its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct VisibleArea {
    pub middle: DVec2,
    pub size: DVec2,
}

/// However much lies over the picture, this share of it counts as visible.
const LEAST_VISIBLE: f64 = 0.2;

impl VisibleArea {
    pub const ALL: Self = Self { middle: DVec2::splat(0.5), size: DVec2::ONE };

    /// What is left of a picture of that size where so many px at its top, right, bottom and left have something lying
    /// over them.
    pub fn without([top, right, bottom, left]: [f64; 4], size_px: DVec2) -> Self {
        let share = |px: f64, of_px: f64| if px > 0.0 { (px / of_px).min(1.0) } else { 0.0 };
        let from = DVec2::new(share(left, size_px.x), share(top, size_px.y));
        let to = DVec2::ONE - DVec2::new(share(right, size_px.x), share(bottom, size_px.y));
        let size = (to - from).max(DVec2::splat(LEAST_VISIBLE));
        let middle = (0.5 * (from + to)).clamp(0.5 * size, DVec2::ONE - 0.5 * size);
        Self { middle, size }
    }

    pub fn towards(self, goal: Self, share: f64) -> Self {
        Self { middle: self.middle.lerp(goal.middle, share), size: self.size.lerp(goal.size, share) }
    }

    pub fn is_near(self, other: Self) -> bool {
        self.middle.distance(other.middle) + self.size.distance(other.size) < 1e-5
    }
}
