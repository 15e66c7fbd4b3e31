use glam::{DVec2, DVec3};

use crate::Camera;

/// Outer end of the gizmo's arms in CSS px; same value as in the viewport's `shaders/marks.wgsl`.
const GIZMO_PX: f64 = 68.0;
const GIZMO_START_PX: f64 = 11.0;
/// Arms closer to the line of sight than this sine are faded out, as in that shader, and cannot be picked.
const MIN_SINE: f64 = 0.2;

rosto_mesh::named! {
    /// Axis of the model.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Axis {
        /// To the face's left; red.
        X = "x",
        /// Up; green.
        Y = "y",
        /// Out of the face; blue.
        Z = "z",
    }
}

/// Pointing device, for hit tolerances.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pointer {
    /// Mouse or pen.
    Fine,
    /// Finger.
    Coarse,
}

impl Pointer {
    /// Hit tolerance of the gizmo's arms, in CSS px.
    fn tolerance_px(self) -> f64 {
        match self {
            Self::Fine => 8.0,
            Self::Coarse => 20.0,
        }
    }
}

impl Axis {
    /// Unit vector along the axis.
    pub fn direction(self) -> DVec3 {
        match self {
            Self::X => DVec3::X,
            Self::Y => DVec3::Y,
            Self::Z => DVec3::Z,
        }
    }
}

/// Appearance of a mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MarkKind {
    /// Ring in the accent colour: selected vertex.
    Ring = 0,
    /// Small square: anchor.
    Square = 1,
    /// Pin: anchor set by hand.
    Pin = 2,
    /// Dot in the accent colour: vertex under the pointer.
    Dot = 3,
    /// Small dot in the accent colour: one of several vertices that move together.
    Speck = 7,
}

/// Screen-sized mark on a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mark {
    /// The marked vertex.
    pub vertex: u32,
    /// Appearance.
    pub kind: MarkKind,
}

/// Marks as the GPU reads them: vertex and kind; kinds 4 to 6 are the axes' letters.
pub(crate) fn mark_words(marks: &[Mark], hovered: Option<u32>, gizmo: Option<u32>) -> Vec<[u32; 2]> {
    let hovered = hovered.map(|vertex| [vertex, MarkKind::Dot as u32]);
    let letters = gizmo.into_iter().flat_map(|vertex| Axis::ALL.map(|axis| [vertex, 4 + axis as u32]));
    hovered.into_iter().chain(marks.iter().map(|mark| [mark.vertex, mark.kind as u32])).chain(letters).collect()
}

/// Nearest arm of the gizmo within the pointer's tolerance; `None` close to the vertex itself.
pub(crate) fn axis_under(
    camera: &Camera,
    vertex_m: DVec3,
    position_px: DVec2,
    pixel_ratio: f64,
    pointer: Pointer,
) -> Option<Axis> {
    let tolerance_px = pointer.tolerance_px();
    let m_per_css_px = camera.m_per_px_at(vertex_m) * pixel_ratio;
    if camera.project(vertex_m)?.distance(position_px) < GIZMO_START_PX.max(tolerance_px) * pixel_ratio {
        return None;
    }
    let to_eye = camera.to_eye(vertex_m);
    let distance_px = |axis: Axis| {
        let end = |css_px: f64| camera.project(vertex_m + axis.direction() * css_px * m_per_css_px);
        Some(distance_to_segment(position_px, end(GIZMO_START_PX)?, end(GIZMO_PX)?))
    };
    Axis::ALL
        .into_iter()
        .filter(|axis| to_eye.cross(axis.direction()).length() > MIN_SINE)
        .filter_map(|axis| Some((axis, distance_px(axis)?)))
        .filter(|&(_, distance_px)| distance_px < tolerance_px * pixel_ratio)
        .min_by(|(_, one), (_, other)| one.total_cmp(other))
        .map(|(axis, _)| axis)
}

fn distance_to_segment(position: DVec2, from: DVec2, to: DVec2) -> f64 {
    let line = to - from;
    let share = ((position - from).dot(line) / line.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    position.distance(from + line * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pointer_picks_the_arm_under_it() {
        let mut camera = Camera::default();
        camera.resize(600, 600);
        let centre = DVec2::splat(300.0);
        let at = |motion: DVec2| axis_under(&camera, DVec3::ZERO, centre + motion, 1.0, Pointer::Fine);
        assert_eq!(at(DVec2::new(40.0, 3.0)), Some(Axis::X));
        assert_eq!(at(DVec2::new(-2.0, -40.0)), Some(Axis::Y));
        assert_eq!(at(DVec2::new(40.0, -40.0)), None);
        assert_eq!(at(DVec2::new(95.0, 0.0)), None);
    }

    #[test]
    fn a_finger_has_a_larger_tolerance() {
        let mut camera = Camera::default();
        camera.resize(600, 600);
        let at = |x: f64, y: f64, pointer| {
            axis_under(&camera, DVec3::ZERO, DVec2::splat(300.0) + DVec2::new(x, y), 1.0, pointer)
        };
        assert_eq!((at(50.0, 15.0, Pointer::Fine), at(50.0, 15.0, Pointer::Coarse)), (None, Some(Axis::X)));
        assert_eq!((at(15.0, 0.0, Pointer::Fine), at(15.0, 0.0, Pointer::Coarse)), (Some(Axis::X), None));
    }

    #[test]
    fn an_arm_towards_the_viewer_is_not_picked() {
        let mut camera = Camera::default();
        camera.resize(600, 600);
        let at = |camera: &Camera, motion: DVec2| {
            axis_under(camera, DVec3::ZERO, DVec2::splat(300.0) + motion, 1.0, Pointer::Fine)
        };
        assert_eq!(at(&camera, DVec2::ZERO), None);
        assert_eq!(at(&camera, DVec2::new(-9.0, 9.0)), None);
        camera.set_glide(crate::Glide::Off);
        camera.look(crate::NamedView::Left);
        camera.advance(0.0);
        assert_eq!(at(&camera, DVec2::ZERO), None);
        assert_eq!(at(&camera, DVec2::new(-40.0, 0.0)), Some(Axis::Z));
    }

    #[test]
    fn hovered_dot_marks_and_letters_are_drawn_in_order() {
        let marks = [Mark { vertex: 7, kind: MarkKind::Ring }];
        assert_eq!(mark_words(&marks, Some(3), Some(7)), [[3, 3], [7, 0], [7, 4], [7, 5], [7, 6]]);
        assert_eq!(mark_words(&[], None, None), [[0_u32; 2]; 0]);
    }
}
