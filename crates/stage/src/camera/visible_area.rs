use glam::DVec2;

/// The part of the picture that is not covered, in shares of its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct VisibleArea {
    pub centre: DVec2,
    pub size: DVec2,
}

/// Minimum size of the visible area, for any insets.
const MIN_VISIBLE: f64 = 0.2;

impl VisibleArea {
    pub const ALL: Self = Self { centre: DVec2::splat(0.5), size: DVec2::ONE };

    /// The visible area for insets in px at the top, right, bottom and left.
    pub fn without([top, right, bottom, left]: [f64; 4], size_px: DVec2) -> Self {
        let share = |px: f64, of_px: f64| if px > 0.0 { (px / of_px).min(1.0) } else { 0.0 };
        let from = DVec2::new(share(left, size_px.x), share(top, size_px.y));
        let to = DVec2::ONE - DVec2::new(share(right, size_px.x), share(bottom, size_px.y));
        let size = (to - from).max(DVec2::splat(MIN_VISIBLE));
        let centre = (0.5 * (from + to)).clamp(0.5 * size, DVec2::ONE - 0.5 * size);
        Self { centre, size }
    }

    pub fn towards(self, goal: Self, share: f64) -> Self {
        Self { centre: self.centre.lerp(goal.centre, share), size: self.size.lerp(goal.size, share) }
    }

    pub fn is_near(self, other: Self) -> bool {
        self.centre.distance(other.centre) + self.size.distance(other.size) < 1e-5
    }
}
