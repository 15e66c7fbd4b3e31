use glam::{DVec2, DVec3};
use rosto_face::LANDMARK_COUNT;
use rosto_stage::{Axis, Pointer};

use super::{Result, Session};
use crate::drag::{Drag, Pace};
use crate::gesture::{self, Gesture, Under};
use crate::open_face::{MM_PER_M, OpenFace};
use crate::{Changed, Selection, SessionError};

/// A point of the midline that is dragged sideways by less, in CSS px, stays in the mirror's plane.
const STICKS_PX: f64 = 10.0;

/// What the pointer is on, and what it drags.
impl Session {
    pub(super) fn hover(&mut self, place_px: Option<DVec2>) -> Changed {
        // The brush selects nothing.
        let place_px = place_px.filter(|_| self.brush_px.is_none());
        let under = place_px.map_or(Under::default(), |place_px| self.under_at(place_px, Pointer::Fine));
        let shows_dots = self.face.as_ref().is_some_and(|face| face.selects_landmarks(self.mode));
        self.stage.set_pointer(place_px.filter(|_| shows_dots && under.vertex.is_some()));
        self.stage.set_gizmo_axis(under.axis);
        self.set_under(under);
        Changed::View
    }

    pub(super) fn point_at(&mut self, landmark: Option<u32>) -> Result {
        let count = LANDMARK_COUNT;
        if let Some(vertex) = landmark.filter(|&vertex| vertex as usize >= count) {
            return Err(SessionError::NoSuchVertex { vertex, count });
        }
        self.stage.set_pointer(None);
        self.stage.set_gizmo_axis(None);
        self.set_under(Under { vertex: landmark.filter(|_| self.face.is_some()), ..Under::default() });
        Ok(Changed::View)
    }

    pub(super) fn set_under(&mut self, under: Under) {
        let before = self.pointed();
        self.under = under;
        self.stage.set_hovered(under.vertex);
        if before != self.pointed() {
            self.show_marks();
        }
    }

    /// What the pointer rests on and would select, unless it is selected.
    pub(super) fn pointed(&self) -> Option<Selection> {
        let (face, vertex) = (self.face.as_ref()?, self.under.vertex?);
        let pointed = face.at_or_grabbed(vertex, self.mode);
        Some(pointed).filter(|pointed| Some(*pointed) != face.selection())
    }

    /// What was under the pointer may be gone.
    pub(super) fn check_pointer(&mut self) {
        let count = self.face.as_ref().map_or(0, |face| face.document().rest().len());
        if self.under.vertex.is_some_and(|vertex| vertex as usize >= count) {
            self.under = Under::default();
            self.stage.set_hovered(None);
            self.stage.set_pointer(None);
        }
    }

    /// What is taken lights up, under a finger as well, which was not over it before.
    pub(super) fn press(&mut self, place_px: DVec2, pointer: Pointer) -> Changed {
        if let Some(brush_px) = self.brush_px {
            return self.paint(place_px, brush_px);
        }
        let under = self.under_at(place_px, pointer);
        self.gesture = gesture::pressed(under, place_px);
        self.set_under(under);
        Changed::View
    }

    fn under_at(&self, place_px: DVec2, pointer: Pointer) -> Under {
        match &self.face {
            Some(face) if place_px.is_finite() => gesture::under(face, &self.stage, self.mode, place_px, pointer),
            _ => Under::default(),
        }
    }

    pub(super) fn drag(&mut self, place_px: DVec2, pace: Pace) -> Result {
        if !place_px.is_finite() {
            return Ok(Changed::Nothing);
        }
        if self.gesture == Gesture::Painting {
            return Ok(self.go_on_painting(place_px));
        }
        let mut grabbed = Changed::Nothing;
        if let Gesture::Ready { vertex, axis, from_px } = self.gesture {
            grabbed = self.grab(vertex, axis, from_px)?;
        }
        let Gesture::Dragging { drag, axis, .. } = &self.gesture else { return Ok(Changed::Nothing) };
        Ok(self.drag_to(drag.clone(), *axis, place_px, pace)?.max(grabbed))
    }

    /// Selects what the pointer has grabbed, unless it is selected. An edit in progress is kept.
    pub(super) fn grab(&mut self, vertex: u32, axis: Option<Axis>, from_px: DVec2) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        face.commit(&self.choices);
        if !face.holds(vertex) {
            self.select_at(vertex)?;
        }
        let face = self.open_face()?;
        let start_m = face.document().committed().get(vertex as usize).copied().unwrap_or_default();
        let drag = Drag::new(start_m, face.kept_mm(), from_px);
        self.gesture = Gesture::Dragging { drag, axis, to_px: from_px, pace: Pace::Usual, is_at_end: false };
        self.stage.set_pointer(None);
        self.set_under(Under::default());
        Ok(Changed::Document)
    }

    pub(super) fn drag_along(&mut self, wanted: Axis) -> Result {
        let Gesture::Dragging { drag, axis, to_px, pace, .. } = &self.gesture else { return Ok(Changed::Nothing) };
        let axis = if *axis == Some(wanted) { None } else { Some(wanted) };
        self.drag_to(drag.clone(), axis, *to_px, *pace)
    }

    /// The drag goes to a place, unless what is selected has no answer there.
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

    /// How far in mm what is selected goes with the pointer, and whether that is the end of its sliders; none for what cannot be
    /// moved, which stays, as the state says.
    fn offset_at(&self, drag: &mut Drag, axis: Option<Axis>, to_px: DVec2, pace: Pace) -> Option<(DVec3, bool)> {
        let (face, camera) = (self.face.as_ref().filter(|face| face.refusal().is_none())?, self.stage.camera());
        let mut offset_mm = drag.offset_m(camera, to_px, axis, pace) * MM_PER_M;
        // No hand is straight: in the mirror's plane stays what is not meant to leave it.
        let sticks_mm = drag.mm_of_px(camera, STICKS_PX * self.stage.pixel_ratio());
        if axis != Some(Axis::X) && offset_mm.x.abs() < sticks_mm && face.lies_in_plane(&self.choices) {
            offset_mm.x = 0.0;
        }
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

    pub(super) fn vertex_at(&self, place_px: DVec2) -> Option<u32> {
        let ray = self.stage.camera().ray(place_px);
        self.face.as_ref().filter(|_| place_px.is_finite())?.pick(&ray, self.mode)
    }
}
