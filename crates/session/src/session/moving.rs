use glam::DVec3;
use rosto_face::{PhotoLens, Triangulation};
use rosto_studio::{Document, EditsInRig, Expression, FaceSlider, Rig, StudioError, Switch};

use super::opening::prepare;
use super::{Result, Session};
use crate::error::within;
use crate::gesture::{Gesture, Under};
use crate::incoming::DENSEST_SHOWN;
use crate::open_face::{MAX_OFFSET_M, MM_PER_M, OpenFace};
use crate::{Changed, Choices, SessionError};

/// What is done to the face, and taken back.
impl Session {
    pub(super) fn preview(&mut self, offset_mm: DVec3) -> Result {
        let most_mm = MAX_OFFSET_M * MM_PER_M;
        for along in offset_mm.to_array() {
            within("an offset in mm", along, -most_mm, most_mm)?;
        }
        let Some(face) = &mut self.face else { return Ok(Changed::Nothing) };
        let was_sliding = face.is_sliding();
        if was_sliding {
            face.commit(&self.choices);
        }
        let is_held_anew = face.preview(offset_mm, &self.choices)?;
        Ok(if was_sliding || is_held_anew { Changed::Document } else { Changed::Tick })
    }

    pub(super) fn slide(&mut self, slider: FaceSlider, to_mm: f64) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        let most_mm = slider.range_m() * MM_PER_M;
        within("a ready-made slider in mm", to_mm, -most_mm - 1e-9, most_mm + 1e-9)?;
        let is_taken = face.slider() == Some(slider);
        if !is_taken {
            self.gesture = Gesture::Idle;
            face.take_slider(slider, &self.choices)?;
        }
        face.slide(slider, to_mm)?;
        Ok(if is_taken { Changed::Tick } else { Changed::Document })
    }

    pub(super) fn express(&mut self, expression: Expression, to: f64) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        within("an expression's weight", to, 0.0, 1.0)?;
        let is_taken = face.expression() == Some(expression);
        if !is_taken {
            self.gesture = Gesture::Idle;
            face.commit(&self.choices);
        }
        face.express(expression, to, &self.choices)?;
        Ok(if is_taken { Changed::Tick } else { Changed::Document })
    }

    pub(super) fn come_to_rest(&mut self) -> Result {
        self.open_face()?;
        self.finish(|face, choices| {
            face.commit(choices);
            face.change_history(choices, Document::come_to_rest);
        })
    }

    /// Ends an edit in progress, one way or the other.
    pub(super) fn finish(&mut self, end: impl FnOnce(&mut OpenFace, &Choices)) -> Result {
        self.gesture = Gesture::Idle;
        let Some(face) = &mut self.face else { return Ok(Changed::Nothing) };
        end(face, &self.choices);
        Ok(Changed::Document)
    }

    pub(super) fn cancel(&mut self) -> Result {
        let was_dragging = self.has_grabbed();
        let changed = self.finish(OpenFace::cancel)?;
        if was_dragging {
            self.gesture = Gesture::Over;
        }
        Ok(changed)
    }

    pub(super) fn undo(&mut self) -> Result {
        self.finish(|face, choices| {
            face.commit(choices);
            face.change_history(choices, Document::undo);
        })
    }

    pub(super) fn reset(&mut self) -> Result {
        self.finish(|face, choices| {
            face.change_history(choices, |document| {
                document.reset();
                Some(0)
            });
        })
    }

    pub(super) fn reset_selected(&mut self) -> Result {
        let target = self.open_face()?.selection().ok_or(SessionError::NothingSelected)?.target();
        self.finish(|face, choices| face.change_history(choices, |document| document.switch_off(target)))
    }

    pub(super) fn switch(&mut self, index: usize, switch: Switch) -> Result {
        let count = self.open_face()?.document().history().entries().len();
        if index >= count {
            return Err(StudioError::NoSuchEntry { index, count }.into());
        }
        self.finish(|face, choices| {
            face.change_history(choices, |document| document.switch(index, switch).unwrap_or_default());
        })
    }

    pub(super) fn symmetrise(&mut self, share: f64) -> Result {
        within("the share", share, 0.0, 1.0)?;
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        face.symmetrise(share, &self.choices)?;
        self.gesture = Gesture::Idle;
        Ok(Changed::Document)
    }

    pub(super) fn set_density(&mut self, density: u32) -> Result {
        within("the density", density.into(), 0.0, DENSEST_SHOWN.into())?;
        if let Some(face) = &mut self.face {
            face.set_density(density, self.mode, &self.choices)?;
            prepare(face, self.mode, &self.choices, self.seeds.peek());
        }
        self.new_mesh();
        self.view.density = density;
        Ok(Changed::Mesh)
    }

    pub(super) fn set_triangulation(&mut self, triangulation: Triangulation) -> Result {
        if let Some(face) = &mut self.face {
            face.set_triangulation(triangulation, &self.choices)?;
        }
        self.new_mesh();
        self.view.triangulation = triangulation;
        Ok(Changed::Mesh)
    }

    pub(super) fn set_photo_lens(&mut self, lens: PhotoLens) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        if face.model().lens() == lens {
            return Ok(Changed::Nothing);
        }
        face.set_photo_lens(lens, &self.choices)?;
        self.new_mesh();
        self.show_pinhole();
        Ok(Changed::Mesh)
    }

    pub(super) fn new_mesh(&mut self) {
        (self.gesture, self.under) = (Gesture::Idle, Under::default());
    }

    /// The face for others to move.
    pub(crate) fn rig(&mut self, edits: EditsInRig) -> Result<Rig, SessionError> {
        Ok(Rig::new(self.face.as_mut().ok_or(SessionError::NoFace)?.document_mut(), edits)?)
    }

    /// The face in its pieces as it is shown.
    pub(crate) fn still_rig(&mut self, edits: EditsInRig) -> Result<Rig, SessionError> {
        Ok(Rig::still(self.face.as_mut().ok_or(SessionError::NoFace)?.document_mut(), edits))
    }

    /// What each entry displaced the mesh by.
    pub(crate) fn displacements(&mut self) -> Result<Vec<Vec<DVec3>>, SessionError> {
        Ok(self.face.as_mut().ok_or(SessionError::NoFace)?.document_mut().displacements())
    }
}
