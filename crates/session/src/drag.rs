use glam::{DVec2, DVec3};
use rosto_stage::{Axis, Camera};

use crate::choices::SLIDER_MM;
use crate::open_face::MM_PER_M;

/// How much slower a fine drag is.
const FINE: f64 = 0.1;

/// An axis that appears shorter than this share of its length is seen end-on.
const END_ON: f64 = 0.2;

/// How a landmark's offset follows the pointer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pace {
    /// As the pointer goes.
    Usual,
    /// Ten times slower.
    Fine,
}

/// A landmark being dragged: where it started, and how far the pointer has gone since.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Drag {
    start_m: DVec3,
    /// What the history holds for it, in mm.
    kept_mm: DVec3,
    pointer_px: DVec2,
    moved_px: DVec2,
}

impl Drag {
    pub fn new(start_m: DVec3, kept_mm: DVec3, pointer_px: DVec2) -> Self {
        Self { start_m, kept_mm, pointer_px, moved_px: DVec2::ZERO }
    }

    /// An offset in mm as far as the sliders of what is dragged go, and whether that is less than all of it. What has gone
    /// further before stays there.
    pub fn within_sliders(&self, offset_mm: DVec3) -> (DVec3, bool) {
        let least_mm = self.kept_mm.min(DVec3::splat(SLIDER_MM.least));
        let most_mm = self.kept_mm.max(DVec3::splat(SLIDER_MM.most));
        let reached_mm = (self.kept_mm + offset_mm).clamp(least_mm, most_mm) - self.kept_mm;
        (reached_mm, reached_mm.distance(offset_mm) > 1e-9)
    }

    /// How many mm so many px in the picture are where it started.
    pub fn mm_of_px(&self, camera: &Camera, px: f64) -> f64 {
        px * camera.m_per_px_at(self.start_m) * MM_PER_M
    }

    /// The offset in metres after the pointer has gone to `pointer_px`: in the view plane, or along one axis.
    pub fn offset_m(&mut self, camera: &Camera, pointer_px: DVec2, axis: Option<Axis>, pace: Pace) -> DVec3 {
        let step_px = pointer_px - self.pointer_px;
        self.pointer_px = pointer_px;
        self.moved_px += if pace == Pace::Fine { step_px * FINE } else { step_px };
        match axis {
            None => camera.view_plane_offset_m(self.start_m, self.moved_px),
            Some(axis) => axis.direction() * self.distance_along_m(camera, axis),
        }
    }

    /// The distance along an axis that takes the landmark nearest to the pointer. Along an axis seen end-on, up comes
    /// nearer and down goes away.
    fn distance_along_m(&self, camera: &Camera, axis: Axis) -> f64 {
        let step_m = 1e-3 * camera.radius_m();
        let ends = [-step_m, step_m].map(|step_m| camera.project(self.start_m + axis.direction() * step_m));
        let [Some(before), Some(after)] = ends else { return 0.0 };
        let px_per_m = (after - before) / (2.0 * step_m);
        let m_per_px_across = camera.m_per_px_at(self.start_m);
        if px_per_m.length() * m_per_px_across < END_ON {
            return -self.moved_px.y * m_per_px_across * axis.direction().dot(camera.to_eye(self.start_m)).signum();
        }
        self.moved_px.dot(px_per_m) / px_per_m.length_squared()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rosto_stage::{Glide, NamedView};

    fn camera() -> Camera {
        let mut camera = Camera::default();
        camera.resize(800, 600);
        camera.frame(DVec3::ZERO, 0.1);
        camera
    }

    #[test]
    fn in_the_view_plane_the_landmark_stays_under_the_pointer() {
        let camera = camera();
        let start = DVec3::new(0.01, 0.02, 0.05);
        let from = camera.project(start).unwrap();
        let to = from + DVec2::new(40.0, -25.0);
        let offset = Drag::new(start, DVec3::ZERO, from).offset_m(&camera, to, None, Pace::Usual);
        assert!(camera.project(start + offset).unwrap().distance(to) < 1e-9);
    }

    #[test]
    fn along_an_axis_only_that_coordinate_changes() {
        let camera = camera();
        let mut drag = Drag::new(DVec3::ZERO, DVec3::ZERO, DVec2::splat(300.0));
        let offset = drag.offset_m(&camera, DVec2::new(340.0, 250.0), Some(Axis::X), Pace::Usual);
        assert!(offset.x > 0.0 && offset.y == 0.0 && offset.z == 0.0);
        assert!((camera.project(offset).unwrap().x - 440.0).abs() < 0.5);
    }

    #[test]
    fn along_an_axis_seen_end_on_up_comes_nearer() {
        let mut camera = camera();
        camera.set_glide(Glide::Off);
        for (view, nearer) in [(NamedView::Front, DVec3::Z), (NamedView::Left, DVec3::X)] {
            camera.look(view);
            camera.advance(0.0);
            let axis = if view == NamedView::Front { Axis::Z } else { Axis::X };
            let mut drag = Drag::new(DVec3::ZERO, DVec3::ZERO, DVec2::splat(300.0));
            let offset = drag.offset_m(&camera, DVec2::new(500.0, 250.0), Some(axis), Pace::Usual);
            let across = camera.view_plane_offset_m(DVec3::ZERO, DVec2::new(0.0, -50.0)).length();
            assert!(offset.distance(nearer * across) < 1e-12, "{offset}");
        }
    }

    #[test]
    fn a_drag_goes_as_far_as_the_sliders_and_says_so() {
        let at = |kept_mm: DVec3| Drag::new(DVec3::ZERO, kept_mm, DVec2::ZERO);
        let far = DVec3::new(50.0, -30.0, 0.0);
        assert_eq!(at(DVec3::ZERO).within_sliders(far), (DVec3::new(40.0, -30.0, 0.0), true));
        assert_eq!(at(DVec3::new(-20.0, 0.0, 0.0)).within_sliders(far), (far, false));
        let further = DVec3::new(60.0, 0.0, 0.0);
        assert_eq!(at(further).within_sliders(far), (DVec3::new(0.0, -30.0, 0.0), true));
        assert_eq!(at(further).within_sliders(-far), (-far, false));
    }

    #[test]
    fn a_fine_drag_goes_a_tenth_of_the_way() {
        let camera = camera();
        let drag = || Drag::new(DVec3::ZERO, DVec3::ZERO, DVec2::ZERO);
        let go = |pace| drag().offset_m(&camera, DVec2::new(100.0, 0.0), None, pace);
        assert!((go(Pace::Usual) * 0.1).distance(go(Pace::Fine)) < 1e-15);
    }
}
