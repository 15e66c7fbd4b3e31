use glam::{DVec2, DVec3};

use crate::Camera;

/// Length in CSS px of the gizmo's arms; the viewport's `shaders/marks.wgsl` says the same.
const GIZMO_PX: f64 = 68.0;
const GIZMO_START_PX: f64 = 11.0;
/// Arms at a smaller sine to the line of sight have faded, as that file says too, and are not there.
const LEAST_SINE: f64 = 0.2;

rosto_mesh::named! {
    /// An axis of the model.
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

/// What points: a finger cannot be as exact as a mouse or a pen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pointer {
    /// A mouse or a pen.
    Fine,
    /// A finger.
    Coarse,
}

impl Pointer {
    /// How near it must come to an arm of the gizmo, in CSS px.
    fn reach_px(self) -> f64 {
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

/// What marks a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MarkKind {
    /// A ring in the accent: the selected vertex.
    Ring = 0,
    /// A small square: an anchor.
    Square = 1,
    /// A pin: pinned by hand.
    Pin = 2,
    /// A dot in the accent: under the pointer.
    Dot = 3,
    /// A small dot in the accent: one of many that move together.
    Speck = 7,
}

/// A mark that keeps its size on the screen and follows its vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mark {
    /// The vertex it follows.
    pub vertex: u32,
    /// What it looks like.
    pub kind: MarkKind,
}

/// What the GPU reads for each mark: vertex and kind; kinds 4 to 6 are the letters of the axes.
pub(crate) fn mark_words(marks: &[Mark], hovered: Option<u32>, gizmo: Option<u32>) -> Vec<[u32; 2]> {
    let hovered = hovered.map(|vertex| [vertex, MarkKind::Dot as u32]);
    let letters = gizmo.into_iter().flat_map(|vertex| Axis::ALL.map(|axis| [vertex, 4 + axis as u32]));
    hovered.into_iter().chain(marks.iter().map(|mark| [mark.vertex, mark.kind as u32])).chain(letters).collect()
}

/// The arm of the gizmo at `vertex_m` that the pointer is on, the nearest if several; none on the vertex itself.
pub(crate) fn axis_under(
    camera: &Camera,
    vertex_m: DVec3,
    place_px: DVec2,
    pixel_ratio: f64,
    pointer: Pointer,
) -> Option<Axis> {
    let reach_px = pointer.reach_px();
    let m_per_css_px = camera.m_per_px_at(vertex_m) * pixel_ratio;
    if camera.project(vertex_m)?.distance(place_px) < GIZMO_START_PX.max(reach_px) * pixel_ratio {
        return None;
    }
    let to_eye = camera.to_eye(vertex_m);
    let distance_px = |axis: Axis| {
        let end = |css_px: f64| camera.project(vertex_m + axis.direction() * css_px * m_per_css_px);
        Some(distance_to_segment(place_px, end(GIZMO_START_PX)?, end(GIZMO_PX)?))
    };
    Axis::ALL
        .into_iter()
        .filter(|axis| to_eye.cross(axis.direction()).length() > LEAST_SINE)
        .filter_map(|axis| Some((axis, distance_px(axis)?)))
        .filter(|&(_, distance_px)| distance_px < reach_px * pixel_ratio)
        .min_by(|(_, one), (_, other)| one.total_cmp(other))
        .map(|(axis, _)| axis)
}

fn distance_to_segment(place: DVec2, from: DVec2, to: DVec2) -> f64 {
    let line = to - from;
    let share = ((place - from).dot(line) / line.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    place.distance(from + line * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pointer_finds_the_arm_it_is_on() {
        let mut camera = Camera::default();
        camera.resize(600, 600);
        let middle = DVec2::splat(300.0);
        let at = |motion: DVec2| axis_under(&camera, DVec3::ZERO, middle + motion, 1.0, Pointer::Fine);
        assert_eq!(at(DVec2::new(40.0, 3.0)), Some(Axis::X));
        assert_eq!(at(DVec2::new(-2.0, -40.0)), Some(Axis::Y));
        assert_eq!(at(DVec2::new(40.0, -40.0)), None);
        assert_eq!(at(DVec2::new(95.0, 0.0)), None);
    }

    #[test]
    fn a_finger_finds_an_arm_from_further_away_and_the_vertex_too() {
        let mut camera = Camera::default();
        camera.resize(600, 600);
        let at = |x: f64, y: f64, pointer| {
            axis_under(&camera, DVec3::ZERO, DVec2::splat(300.0) + DVec2::new(x, y), 1.0, pointer)
        };
        assert_eq!((at(50.0, 15.0, Pointer::Fine), at(50.0, 15.0, Pointer::Coarse)), (None, Some(Axis::X)));
        assert_eq!((at(15.0, 0.0, Pointer::Fine), at(15.0, 0.0, Pointer::Coarse)), (Some(Axis::X), None));
    }

    #[test]
    fn an_arm_that_points_at_the_viewer_leaves_the_vertex_to_the_pointer() {
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
    fn the_hovered_dot_lies_under_the_marks_and_letters_on_top() {
        let marks = [Mark { vertex: 7, kind: MarkKind::Ring }];
        assert_eq!(mark_words(&marks, Some(3), Some(7)), [[3, 3], [7, 0], [7, 4], [7, 5], [7, 6]]);
        assert_eq!(mark_words(&[], None, None), [[0_u32; 2]; 0]);
    }
}
