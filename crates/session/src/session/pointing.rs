use glam::{DVec2, DVec3};
use rosto_face::LANDMARK_COUNT;
use rosto_stage::{Axis, Pointer};

use super::{Result, Session};
use crate::drag::{Drag, Pace};
use crate::gesture::{self, Gesture, Under};
use crate::open_face::{MAX_OFFSET_M, MM_PER_M, OpenFace};
use crate::{Changed, Selection, SessionError};

/// What the pointer is on, and what it drags.
impl Session {
    pub(super) fn hover(&mut self, place_px: Option<DVec2>) -> Changed {
        let under = match (&self.face, place_px) {
            (Some(face), Some(place_px)) if place_px.is_finite() => {
                gesture::under(face, &self.stage, self.mode, place_px, Pointer::Fine)
            }
            _ => Under::default(),
        };
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
        let pointed = face.at_or_held(vertex, self.mode);
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

    pub(super) fn press(&mut self, place_px: DVec2, pointer: Pointer) -> Changed {
        self.gesture = match &self.face {
            Some(face) if place_px.is_finite() => gesture::pressed(face, &self.stage, self.mode, place_px, pointer),
            _ => Gesture::Idle,
        };
        Changed::Nothing
    }

    pub(super) fn drag(&mut self, place_px: DVec2, pace: Pace) -> Result {
        if !place_px.is_finite() {
            return Ok(Changed::Nothing);
        }
        let mut grabbed = Changed::Nothing;
        if let Gesture::Ready { vertex, axis, from_px } = self.gesture {
            grabbed = self.grab(vertex, axis, from_px)?;
        }
        let Gesture::Dragging { to_px, pace: now, .. } = &mut self.gesture else { return Ok(Changed::Nothing) };
        (*to_px, *now) = (place_px, pace);
        Ok(self.follow_pointer()?.max(grabbed))
    }

    /// Selects what the pointer has grabbed, unless it is selected. An edit in progress is kept.
    pub(super) fn grab(&mut self, vertex: u32, axis: Option<Axis>, from_px: DVec2) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        face.commit(&self.choices);
        if !face.holds(vertex) {
            self.select_at(vertex)?;
        }
        let start_m = self.open_face()?.document().committed().get(vertex as usize).copied().unwrap_or_default();
        let drag = Drag::new(start_m, from_px);
        self.gesture = Gesture::Dragging { drag, axis, to_px: from_px, pace: Pace::Usual };
        self.stage.set_pointer(None);
        self.set_under(Under::default());
        Ok(Changed::Document)
    }

    pub(super) fn drag_along(&mut self, wanted: Axis) -> Result {
        let Gesture::Dragging { axis, .. } = &mut self.gesture else { return Ok(Changed::Nothing) };
        *axis = if *axis == Some(wanted) { None } else { Some(wanted) };
        self.follow_pointer()
    }

    pub(super) fn follow_pointer(&mut self) -> Result {
        let (Some(face), Gesture::Dragging { drag, axis, to_px, pace }) = (&mut self.face, &mut self.gesture) else {
            return Ok(Changed::Nothing);
        };
        self.stage.set_gizmo_axis(*axis);
        let offset_mm = drag.offset_m(self.stage.camera(), *to_px, *axis, *pace) * MM_PER_M;
        let most_mm = MAX_OFFSET_M * MM_PER_M;
        // What cannot be moved stays, as the state says; what is dragged to the end of the world stops before it.
        if face.refusal().is_some() || !offset_mm.is_finite() {
            return Ok(Changed::Nothing);
        }
        face.preview(offset_mm.clamp(DVec3::splat(-most_mm), DVec3::splat(most_mm)))?;
        Ok(Changed::Tick)
    }

    pub(super) fn release(&mut self) -> Result {
        let is_dragging = self.is_dragging();
        self.gesture = Gesture::Idle;
        if is_dragging { self.finish(OpenFace::commit) } else { Ok(Changed::Nothing) }
    }

    pub(super) fn vertex_at(&self, place_px: DVec2) -> Option<u32> {
        let ray = self.stage.camera().ray(place_px);
        self.face.as_ref().filter(|_| place_px.is_finite())?.pick(&ray, self.mode)
    }
}
