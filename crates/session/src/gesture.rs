use glam::DVec2;
use rosto_stage::{Axis, Pointer, Stage};

use crate::drag::{Drag, Pace};
use crate::open_face::OpenFace;
use crate::{Selection, SelectionMode};

/// Radius in CSS px within which the selected vertex takes precedence over a nearer one.
fn grab_radius_px(pointer: Pointer) -> f64 {
    match pointer {
        Pointer::Fine => 9.0,
        Pointer::Coarse => 28.0,
    }
}

/// Action of the pressed pointer.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) enum Gesture {
    /// None in the session.
    #[default]
    Idle,
    /// It is pressed on a vertex, selected alone or with its region, and has not moved yet.
    Pressed { vertex: u32, axis: Option<Axis>, from_px: DVec2 },
    /// It drags the selection, which stops at the end of the sliders' range.
    Dragging { drag: Drag, axis: Option<Axis>, to_px: DVec2, pace: Pace, is_at_end: bool },
    /// It paints a stroke that protects the photo.
    Painting,
    /// The drag was cancelled; the pointer is still pressed.
    Cancelled,
}

/// The vertex and gizmo axis under the pointer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Hovered {
    /// The vertex nearest to the point at which the pointer meets the face, or the selected one if the pointer is on
    /// its ring or gizmo. It is highlighted, alone or with its region, and a press grabs it.
    pub vertex: Option<u32>,
    /// The gizmo axis under the pointer.
    pub axis: Option<Axis>,
}

/// Finds the vertex and gizmo axis at a position on the canvas.
pub(crate) fn hit_test(
    face: &OpenFace,
    stage: &Stage,
    mode: SelectionMode,
    position_px: DVec2,
    pointer: Pointer,
) -> Hovered {
    let axis = stage.pick_axis(position_px, face.document().positions(), pointer);
    if axis.is_some() {
        return Hovered { vertex: face.selected(), axis };
    }
    let picked = face.pick(&stage.camera().ray(position_px), mode);
    let vertex = picked.map(|vertex| selected_nearby(face, stage, vertex, position_px, pointer).unwrap_or(vertex));
    Hovered { vertex, axis }
}

/// The gesture that a press starts: grabbing the highlighted vertex, or none outside the face.
pub(crate) fn pressed(hovered: Hovered, position_px: DVec2) -> Gesture {
    match hovered.vertex {
        Some(vertex) => Gesture::Pressed { vertex, axis: hovered.axis, from_px: position_px },
        None => Gesture::Idle,
    }
}

/// The selected vertex, if the position is within its ring. On a dense mesh its neighbours are within the ring too, and
/// touch is inexact.
fn selected_nearby(face: &OpenFace, stage: &Stage, vertex: u32, position_px: DVec2, pointer: Pointer) -> Option<u32> {
    let selected = match face.selection()? {
        Selection::Region(_) => return None,
        Selection::Landmark(selected) | Selection::Point { vertex: selected, .. } => selected,
    };
    let committed = face.document().committed();
    let [selected_m, vertex_m] = [selected, vertex].map(|v| committed.get(v as usize).copied());
    let (selected_m, vertex_m, camera) = (selected_m?, vertex_m?, stage.camera());
    let grab_radius_px = grab_radius_px(pointer) * stage.pixel_ratio();
    let is_near = camera.project(selected_m)?.distance(position_px) <= grab_radius_px;
    // Excludes vertices that project nearby but lie on the other side of the face.
    let is_adjacent = selected_m.distance(vertex_m) <= 2.0 * grab_radius_px * camera.m_per_px_at(selected_m);
    (is_near && is_adjacent).then_some(selected)
}
