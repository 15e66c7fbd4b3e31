use glam::{DVec2, DVec3};
use rosto_face::LANDMARK_COUNT;
use rosto_stage::{Axis, Pointer, Visibility};

use super::{Result, Session};
use crate::drag::{Drag, Pace};
use crate::gesture::{self, Gesture, Hovered};
use crate::open_face::{MM_PER_M, OpenFace};
use crate::{Changed, Selection, SessionError};

/// Sideways drags of a midline point below this length, in CSS px, stay in the mirror plane.
const STICKS_PX: f64 = 10.0;

/// Hovering and dragging.
impl Session {
    pub(super) fn hover(&mut self, position_px: Option<DVec2>) -> Changed {
        let before = (self.pointer_px, self.hovered);
        self.pointer_px = position_px;
        // The brush and the marks of a card do not select.
        let position_px = position_px.filter(|_| self.brush_px.is_none() && self.card_px.is_none());
        let hovered = position_px.map_or(Hovered::default(), |position_px| self.hit_at(position_px, Pointer::Fine));
        let shows_dots = self.face.as_ref().is_some_and(|face| face.selects_landmarks(self.mode));
        self.stage.set_pointer(position_px.filter(|_| shows_dots && hovered.vertex.is_some()));
        self.stage.set_gizmo_axis(hovered.axis);
        self.set_hovered(hovered);
        if (self.pointer_px, self.hovered) == before { Changed::Nothing } else { Changed::View }
    }

    pub(super) fn point_at(&mut self, landmark: Option<u32>) -> Result {
        let count = LANDMARK_COUNT;
        if let Some(vertex) = landmark.filter(|&vertex| vertex as usize >= count) {
            return Err(SessionError::NoSuchVertex { vertex, count });
        }
        self.stage.set_pointer(None);
        self.stage.set_gizmo_axis(None);
        self.set_hovered(Hovered { vertex: landmark.filter(|_| self.face.is_some()), ..Hovered::default() });
        Ok(Changed::View)
    }

    pub(super) fn set_hovered(&mut self, hovered: Hovered) {
        let before = self.pointed();
        self.hovered = hovered;
        self.stage.set_hovered(hovered.vertex);
        if before != self.pointed() {
            self.show_marks();
        }
    }

    /// The selection that a click would make under the pointer, unless it is the current one.
    pub(super) fn pointed(&self) -> Option<Selection> {
        let (face, vertex) = (self.face.as_ref()?, self.hovered.vertex?);
        let pointed = face.selection_around(vertex, self.mode);
        Some(pointed).filter(|pointed| Some(*pointed) != face.selection())
    }

    /// Clears the hovered vertex if it can no longer be selected, on another mesh or in another mode.
    pub(super) fn check_pointer(&mut self) {
        let count = self.face.as_ref().map_or(0, |face| face.selectable_count(self.mode));
        if self.hovered.vertex.is_some_and(|vertex| vertex as usize >= count) {
            self.hovered = Hovered::default();
            self.stage.set_hovered(None);
            self.stage.set_pointer(None);
        }
    }

    /// Starts a press. The grabbed vertex is highlighted, also for touch, which has no hover.
    pub(super) fn press(&mut self, position_px: DVec2, pointer: Pointer) -> Result {
        if self.card_px.is_some() {
            return self.mark_corner(position_px);
        }
        if let Some(brush_px) = self.brush_px {
            return Ok(self.paint(position_px, brush_px));
        }
        let hovered = self.hit_at(position_px, pointer);
        self.gesture = gesture::pressed(hovered, position_px);
        self.set_hovered(hovered);
        Ok(Changed::View)
    }

    pub(super) fn hit_at(&self, position_px: DVec2, pointer: Pointer) -> Hovered {
        match &self.face {
            Some(face) if position_px.is_finite() && self.view.print == Visibility::Hidden => {
                gesture::hit_test(face, &self.stage, self.mode, position_px, pointer)
            }
            _ => Hovered::default(),
        }
    }

    pub(super) fn drag(&mut self, position_px: DVec2, pace: Pace) -> Result {
        if !position_px.is_finite() {
            return Ok(Changed::Nothing);
        }
        if self.gesture == Gesture::Painting {
            return Ok(self.continue_stroke(position_px));
        }
        let mut grabbed = Changed::Nothing;
        if let Gesture::Pressed { vertex, axis, from_px } = self.gesture {
            grabbed = self.grab(vertex, axis, from_px)?;
        }
        let Gesture::Dragging { drag, axis, .. } = &self.gesture else { return Ok(Changed::Nothing) };
        Ok(self.drag_to(drag.clone(), *axis, position_px, pace)?.max(grabbed))
    }

    /// Selects the grabbed vertex unless the selection contains it. Commits an edit in progress.
    pub(super) fn grab(&mut self, vertex: u32, axis: Option<Axis>, from_px: DVec2) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        face.commit(&self.edit_options);
        if !face.holds(vertex) {
            self.select_at(vertex)?;
        }
        let face = self.open_face()?;
        let start_m = face.document().committed().get(vertex as usize).copied().unwrap_or_default();
        let limit_mm = face.selection().filter(|_| !self.is_expert()).map(|selection| selection.spread_mm());
        let drag = Drag::new(start_m, face.committed_mm(), from_px).limited(limit_mm);
        self.gesture = Gesture::Dragging { drag, axis, to_px: from_px, pace: Pace::Usual, is_at_end: false };
        self.stage.set_pointer(None);
        self.set_hovered(Hovered::default());
        Ok(Changed::Document)
    }

    pub(super) fn drag_along(&mut self, axis: Option<Axis>) -> Result {
        let Gesture::Dragging { drag, to_px, pace, .. } = &self.gesture else { return Ok(Changed::Nothing) };
        self.drag_to(drag.clone(), axis, *to_px, *pace)
    }

    /// Moves the drag to a position, unless the edit has no solution there.
    fn drag_to(&mut self, mut drag: Drag, axis: Option<Axis>, to_px: DVec2, pace: Pace) -> Result {
        let (mut changed, mut is_at_end) = (Changed::Nothing, self.is_at_end());
        if let Some(wanted) = self.offset_at(&mut drag, axis, to_px, pace) {
            changed = self.preview(wanted.0)?;
            is_at_end = wanted.1;
        }
        self.stage.set_gizmo_axis(axis);
        self.gesture = Gesture::Dragging { drag, axis, to_px, pace, is_at_end };
        Ok(changed)
    }

    /// Offset of the selection in mm for a pointer position, and whether it reaches the end of the sliders. `None` if
    /// the selection cannot be moved.
    fn offset_at(&self, drag: &mut Drag, axis: Option<Axis>, to_px: DVec2, pace: Pace) -> Option<(DVec3, bool)> {
        let (face, camera) = (self.face.as_ref().filter(|face| face.refusal().is_none())?, self.stage.camera());
        let mut offset_mm = drag.offset_m(camera, to_px, axis, pace) * MM_PER_M;
        // Keep small sideways movements of a midline point in the mirror plane.
        let sticks_mm = drag.mm_of_px(camera, STICKS_PX * self.stage.pixel_ratio());
        if axis != Some(Axis::X) && offset_mm.x.abs() < sticks_mm && face.lies_in_plane(&self.edit_options) {
            offset_mm.x = 0.0;
        }
        let offset_mm = drag.resisted(offset_mm, pace);
        offset_mm.is_finite().then(|| drag.within_sliders(face.offset_for(offset_mm)))
    }

    pub(super) fn release(&mut self) -> Result {
        let (is_dragging, was_painting) = (self.is_dragging(), self.gesture == Gesture::Painting);
        self.gesture = Gesture::Idle;
        if was_painting {
            return Ok(Changed::Document);
        }
        if is_dragging { self.finish(OpenFace::commit) } else { Ok(Changed::Nothing) }
    }
}
