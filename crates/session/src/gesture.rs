use glam::DVec2;
use rosto_stage::{Axis, Pointer, Stage};

use crate::drag::{Drag, Pace};
use crate::open_face::OpenFace;
use crate::{Selection, SelectionMode};

/// What is selected is taken from this near, in CSS px, even where something else lies nearer.
fn reach_px(pointer: Pointer) -> f64 {
    match pointer {
        Pointer::Fine => 9.0,
        Pointer::Coarse => 28.0,
    }
}

/// What the pressed pointer does.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) enum Gesture {
    /// Nothing that concerns the session.
    #[default]
    Idle,
    /// It has grabbed a vertex, alone or with its region, and has not moved yet.
    Ready { vertex: u32, axis: Option<Axis>, from_px: DVec2 },
    /// It drags what is selected; at the end of the sliders it goes no further.
    Dragging { drag: Drag, axis: Option<Axis>, to_px: DVec2, pace: Pace, is_at_end: bool },
    /// It paints what of the photo is kept.
    Painting,
    /// What it dragged was put back, and the rest of the press does nothing.
    Over,
}

/// What lies under the pointer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Under {
    /// The vertex nearest to where it meets the face, or the one in whose ring or on whose arm it is. It lights up, alone or
    /// with its region, and is what a press takes.
    pub vertex: Option<u32>,
    /// The arm of the gizmo that it is on.
    pub axis: Option<Axis>,
}

/// What lies under a place on the canvas.
pub(crate) fn under(face: &OpenFace, stage: &Stage, mode: SelectionMode, place_px: DVec2, pointer: Pointer) -> Under {
    let axis = stage.pick_axis(place_px, face.document().positions(), pointer);
    if axis.is_some() {
        return Under { vertex: face.selected(), axis };
    }
    let picked = face.pick(&stage.camera().ray(place_px), mode);
    let vertex = picked.map(|vertex| selected_beside(face, stage, vertex, place_px, pointer).unwrap_or(vertex));
    Under { vertex, axis }
}

/// What a press takes hold of: what lights up under the pointer. One beside the face takes nothing, and turns it.
pub(crate) fn pressed(under: Under, place_px: DVec2) -> Gesture {
    match under.vertex {
        Some(vertex) => Gesture::Ready { vertex, axis: under.axis, from_px: place_px },
        None => Gesture::Idle,
    }
}

/// What is selected, if a place on the canvas where the mesh shows `vertex` is within its ring: on a dense mesh its
/// neighbours are there, too, and a finger is not exact.
fn selected_beside(face: &OpenFace, stage: &Stage, vertex: u32, place_px: DVec2, pointer: Pointer) -> Option<u32> {
    let held = match face.selection()? {
        Selection::Region(_) => return None,
        Selection::Landmark(held) | Selection::Point { vertex: held, .. } => held,
    };
    let committed = face.document().committed();
    let [held_m, vertex_m] = [held, vertex].map(|v| committed.get(v as usize).copied());
    let (held_m, vertex_m, camera) = (held_m?, vertex_m?, stage.camera());
    let reach_px = reach_px(pointer) * stage.pixel_ratio();
    let is_near = camera.project(held_m)?.distance(place_px) <= reach_px;
    // On the other side of the face, it would only seem to be near.
    let is_beside = held_m.distance(vertex_m) <= 2.0 * reach_px * camera.m_per_px_at(held_m);
    (is_near && is_beside).then_some(held)
}
