use glam::DVec2;
use rosto_stage::{Axis, Pointer, Stage};

use crate::drag::{Drag, Pace};
use crate::open_face::OpenFace;
use crate::{Selection, SelectionMode};

/// A drag that starts this near a landmark moves it, in CSS px; one that starts elsewhere turns the face.
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
    /// It drags what is selected.
    Dragging { drag: Drag, axis: Option<Axis>, to_px: DVec2, pace: Pace },
    /// What it dragged was put back, and the rest of the press does nothing.
    Over,
}

/// What lies under the pointer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Under {
    /// The vertex nearest to where it meets the face.
    pub vertex: Option<u32>,
    /// The arm of the gizmo that it is on.
    pub axis: Option<Axis>,
    /// Whether a drag from here moves something.
    pub is_movable: bool,
}

/// What lies under a place on the canvas.
pub(crate) fn under(face: &OpenFace, stage: &Stage, mode: SelectionMode, place_px: DVec2, pointer: Pointer) -> Under {
    let axis = stage.pick_axis(place_px, face.document().positions(), pointer);
    let vertex = face.pick(&stage.camera().ray(place_px), mode);
    let is_near = vertex.is_some_and(|vertex| is_at(face, stage, vertex, place_px, pointer));
    Under { vertex, axis, is_movable: axis.is_some() || is_near }
}

/// What a press takes hold of. A finger only takes what is selected, as it hides what it touches.
pub(crate) fn pressed(
    face: &OpenFace,
    stage: &Stage,
    mode: SelectionMode,
    place_px: DVec2,
    pointer: Pointer,
) -> Gesture {
    let under = under(face, stage, mode, place_px, pointer);
    let vertex = if under.axis.is_some() { face.selected() } else { under.vertex };
    let is_taken = |vertex: &u32| under.is_movable && (pointer == Pointer::Fine || face.holds(*vertex));
    match vertex.filter(is_taken) {
        Some(vertex) => {
            let vertex = point_beside(face, stage, vertex, place_px).unwrap_or(vertex);
            Gesture::Ready { vertex, axis: under.axis, from_px: place_px }
        }
        None => Gesture::Idle,
    }
}

fn is_at(face: &OpenFace, stage: &Stage, vertex: u32, place_px: DVec2, pointer: Pointer) -> bool {
    let position_m = face.document().positions().get(vertex as usize);
    let place = position_m.and_then(|position_m| stage.camera().project(*position_m));
    place.is_some_and(|place| place.distance(place_px) <= reach_px(pointer) * stage.pixel_ratio())
}

/// The point that is selected, if a place on the canvas where the mesh shows `vertex` is within its ring: on a dense mesh,
/// its neighbours are there, too.
fn point_beside(face: &OpenFace, stage: &Stage, vertex: u32, place_px: DVec2) -> Option<u32> {
    let Some(Selection::Point { vertex: held, .. }) = face.selection() else { return None };
    let committed = face.document().committed();
    let [held_m, vertex_m] = [held, vertex].map(|v| committed.get(v as usize).copied());
    let (held_m, vertex_m, camera) = (held_m?, vertex_m?, stage.camera());
    let reach_px = reach_px(Pointer::Fine) * stage.pixel_ratio();
    let is_near = camera.project(held_m)?.distance(place_px) <= reach_px;
    // On the other side of the face, it would only seem to be near.
    let depth_m = (camera.eye_m() - held_m).dot(camera.back());
    let is_beside = held_m.distance(vertex_m) <= 2.0 * reach_px * camera.m_per_px_at_distance(depth_m);
    (is_near && is_beside).then_some(held)
}
