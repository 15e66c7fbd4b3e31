use glam::{DVec2, DVec3};
use rosto_stage::{Axis, Camera};

use crate::edit_options::SLIDER_MM;
use crate::open_face::MM_PER_M;

/// Speed of a fine drag relative to a normal one.
const FINE: f64 = 0.1;

/// An axis is end-on if its projection is shorter than this share of its length.
const END_ON: f64 = 0.2;

/// Ratio of a landmark's movement to the pointer's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pace {
    /// The same movement as the pointer's.
    Usual,
    /// A tenth of the pointer's movement.
    Fine,
}

/// A drag of a landmark: its start position and the pointer's movement since.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Drag {
    start_m: DVec3,
    /// Sum of the offsets in the history, in mm.
    committed_mm: DVec3,
    pointer_px: DVec2,
    moved_px: DVec2,
    /// Movement in mm beyond which the drag meets resistance; none for experts.
    limit_mm: Option<f64>,
}

impl Drag {
    pub fn new(start_m: DVec3, committed_mm: DVec3, pointer_px: DVec2) -> Self {
        Self { start_m, committed_mm, pointer_px, moved_px: DVec2::ZERO, limit_mm: None }
    }

    /// Sets the movement in mm beyond which the drag meets resistance.
    pub fn limited(self, limit_mm: Option<f64>) -> Self {
        Self { limit_mm, ..self }
    }

    /// Resists an offset in mm beyond the limit: it keeps its direction, and the distance from the start of all edits
    /// approaches 1.5 limits. An offset of earlier edits is not resisted. A fine drag lifts the limit, and continues from
    /// where the resistance has held it.
    pub fn resisted(&mut self, offset_mm: DVec3, pace: Pace) -> DVec3 {
        let Some(limit_mm) = self.limit_mm else { return offset_mm };
        let free_mm = limit_mm.max(self.committed_mm.length());
        let beyond_mm = (self.committed_mm + offset_mm).length() - free_mm;
        if beyond_mm <= 0.0 {
            return offset_mm;
        }
        let room_mm = 0.5 * limit_mm;
        let share = self.share_within(offset_mm, free_mm + room_mm * (1.0 - (-beyond_mm / room_mm).exp()));
        if pace == Pace::Fine {
            self.limit_mm = None;
            self.moved_px *= share;
        }
        offset_mm * share
    }

    /// Share of an offset at which it leaves the sphere around the start of all edits.
    fn share_within(&self, offset_mm: DVec3, radius_mm: f64) -> f64 {
        let along = self.committed_mm.dot(offset_mm);
        let room = (radius_mm * radius_mm - self.committed_mm.length_squared()).max(0.0);
        ((along * along + room * offset_mm.length_squared()).sqrt() - along) / offset_mm.length_squared()
    }

    /// Clamps an offset in mm to the sliders' range; the flag reports whether it was clamped. An offset that already
    /// exceeds the range is retained.
    pub fn within_sliders(&self, offset_mm: DVec3) -> (DVec3, bool) {
        let min_mm = self.committed_mm.min(DVec3::splat(SLIDER_MM.min));
        let max_mm = self.committed_mm.max(DVec3::splat(SLIDER_MM.max));
        let reached_mm = (self.committed_mm + offset_mm).clamp(min_mm, max_mm) - self.committed_mm;
        (reached_mm, reached_mm.distance(offset_mm) > 1e-9)
    }

    /// Length in mm of `px` pixels at the start position.
    pub fn mm_of_px(&self, camera: &Camera, px: f64) -> f64 {
        px * camera.m_per_px_at(self.start_m) * MM_PER_M
    }

    /// Offset in metres for the pointer at `pointer_px`: in the view plane, or along one axis.
    pub fn offset_m(&mut self, camera: &Camera, pointer_px: DVec2, axis: Option<Axis>, pace: Pace) -> DVec3 {
        let step_px = pointer_px - self.pointer_px;
        self.pointer_px = pointer_px;
        self.moved_px += if pace == Pace::Fine { step_px * FINE } else { step_px };
        match axis {
            None => camera.view_plane_offset_m(self.start_m, self.moved_px),
            Some(axis) => axis.direction() * self.distance_along_m(camera, axis),
        }
    }

    /// Distance along an axis at which the landmark is nearest to the pointer. If the axis is end-on, moving the
    /// pointer up brings the landmark nearer.
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
    fn a_free_drag_keeps_the_landmark_under_the_pointer() {
        let camera = camera();
        let start = DVec3::new(0.01, 0.02, 0.05);
        let from = camera.project(start).unwrap();
        let to = from + DVec2::new(40.0, -25.0);
        let offset = Drag::new(start, DVec3::ZERO, from).offset_m(&camera, to, None, Pace::Usual);
        assert!(camera.project(start + offset).unwrap().distance(to) < 1e-9);
    }

    #[test]
    fn an_axis_drag_changes_one_coordinate() {
        let camera = camera();
        let mut drag = Drag::new(DVec3::ZERO, DVec3::ZERO, DVec2::splat(300.0));
        let offset = drag.offset_m(&camera, DVec2::new(340.0, 250.0), Some(Axis::X), Pace::Usual);
        assert!(offset.x > 0.0 && offset.y == 0.0 && offset.z == 0.0);
        assert!((camera.project(offset).unwrap().x - 440.0).abs() < 0.5);
    }

    #[test]
    fn dragging_up_along_an_end_on_axis_moves_nearer() {
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
    fn a_drag_is_clamped_to_the_sliders_range() {
        let at = |committed_mm: DVec3| Drag::new(DVec3::ZERO, committed_mm, DVec2::ZERO);
        let far = DVec3::new(50.0, -30.0, 0.0);
        assert_eq!(at(DVec3::ZERO).within_sliders(far), (DVec3::new(40.0, -30.0, 0.0), true));
        assert_eq!(at(DVec3::new(-20.0, 0.0, 0.0)).within_sliders(far), (far, false));
        let further = DVec3::new(60.0, 0.0, 0.0);
        assert_eq!(at(further).within_sliders(far), (DVec3::new(0.0, -30.0, 0.0), true));
        assert_eq!(at(further).within_sliders(-far), (-far, false));
    }

    #[test]
    fn a_drag_meets_resistance_beyond_its_limit() {
        let mut drag = Drag::new(DVec3::ZERO, DVec3::ZERO, DVec2::ZERO).limited(Some(8.0));
        let mut at = |mm: f64| drag.resisted(DVec3::new(0.0, -mm, 0.0), Pace::Usual).length();
        assert_eq!((at(3.0), at(8.0)), (3.0, 8.0));
        let mut before_mm = 8.0;
        for mm in [9.0, 12.0, 20.0, 50.0] {
            let reached_mm = at(mm);
            assert!(reached_mm > before_mm && reached_mm < 12.0, "{mm}: {reached_mm}");
            before_mm = reached_mm;
        }
        let mut expert = Drag::new(DVec3::ZERO, DVec3::ZERO, DVec2::ZERO);
        assert_eq!(expert.resisted(DVec3::X * 50.0, Pace::Usual), DVec3::X * 50.0);
        let mut far = Drag::new(DVec3::ZERO, DVec3::X * 30.0, DVec2::ZERO).limited(Some(8.0));
        assert_eq!(far.resisted(DVec3::X * -10.0, Pace::Usual), DVec3::X * -10.0, "earlier edits stay");
        let mut beside = Drag::new(DVec3::ZERO, DVec3::X * 6.0, DVec2::ZERO).limited(Some(8.0));
        let up = beside.resisted(DVec3::Y * 20.0, Pace::Usual);
        assert!(up.x == 0.0 && up.z == 0.0 && up.y > 5.0 && up.y < 11.0, "it keeps its direction: {up}");
    }

    #[test]
    fn shift_lifts_the_limit_without_a_jump() {
        let camera = camera();
        let mut drag = Drag::new(DVec3::ZERO, DVec3::ZERO, DVec2::ZERO).limited(Some(5.0));
        let mut go = |x: f64, pace| {
            let offset_mm = drag.offset_m(&camera, DVec2::new(x, 0.0), None, pace) * MM_PER_M;
            drag.resisted(offset_mm, pace).length()
        };
        let held_mm = go(200.0, Pace::Usual);
        let (fine_mm, further_mm) = (go(200.0, Pace::Fine), go(400.0, Pace::Fine));
        assert!((fine_mm - held_mm).abs() < 1e-9, "{held_mm} to {fine_mm}");
        assert!(further_mm > fine_mm + 1.0 && go(500.0, Pace::Usual) > 10.0);
    }

    #[test]
    fn a_fine_drag_moves_a_tenth() {
        let camera = camera();
        let drag = || Drag::new(DVec3::ZERO, DVec3::ZERO, DVec2::ZERO);
        let go = |pace| drag().offset_m(&camera, DVec2::new(100.0, 0.0), None, pace);
        assert!((go(Pace::Usual) * 0.1).distance(go(Pace::Fine)) < 1e-15);
    }
}
