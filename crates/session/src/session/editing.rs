use glam::DVec3;
use rosto_face::{PhotoLens, Triangulation};
use rosto_studio::{Document, Expression, FaceSlider, StudioError, Switch};

use super::opening::prepare;
use super::{Result, Session};
use crate::error::within;
use crate::gesture::{Gesture, Hovered};
use crate::open_face::{MAX_OFFSET_M, MIN_MM, MM_PER_M, OpenFace};
use crate::saved::MAX_SHOWN_DENSITY;
use crate::{Changed, EditOptions, Look, SessionError};

fn check_offset(offset_mm: DVec3) -> Result<(), SessionError> {
    let max_mm = MAX_OFFSET_M * MM_PER_M;
    offset_mm.to_array().into_iter().try_for_each(|along| within("an offset in mm", along, -max_mm, max_mm).map(drop))
}

/// Edits, undo and redo.
impl Session {
    /// Moves the selection to an offset, which includes earlier entries.
    pub(super) fn offset(&mut self, offset_mm: DVec3) -> Result {
        check_offset(offset_mm)?;
        let committed_mm = self.face.as_ref().map(OpenFace::committed_mm).unwrap_or_default();
        // Sums of entries differ from the typed number by rounding.
        self.preview((offset_mm - committed_mm).map(|by_mm| if by_mm.abs() > MIN_MM { by_mm } else { 0.0 }))
    }

    /// Moves the selection by an offset from the last commit.
    pub(super) fn preview(&mut self, offset_mm: DVec3) -> Result {
        check_offset(offset_mm)?;
        let Some(face) = &mut self.face else { return Ok(Changed::Nothing) };
        let was_sliding = face.is_sliding();
        if was_sliding {
            face.commit(&self.edit_options);
        }
        let was_prepared = face.preview(offset_mm, &self.edit_options)?;
        Ok(if was_sliding || was_prepared { Changed::Document } else { Changed::Tick })
    }

    pub(super) fn slide(&mut self, slider: FaceSlider, to_mm: f64) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        let max_mm = slider.range_m() * MM_PER_M;
        within("a ready-made slider in mm", to_mm, -max_mm - 1e-9, max_mm + 1e-9)?;
        let is_current = face.slider() == Some(slider);
        if !is_current {
            self.gesture = Gesture::Idle;
            face.start_slider(slider, &self.edit_options)?;
        }
        face.slide(slider, to_mm)?;
        Ok(if is_current { Changed::Tick } else { Changed::Document })
    }

    pub(super) fn express(&mut self, expression: Expression, to: f64) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        within("an expression's weight", to, 0.0, 1.0)?;
        let is_current = face.expression() == Some(expression);
        if !is_current {
            self.gesture = Gesture::Idle;
            face.commit(&self.edit_options);
        }
        face.express(expression, to, &self.edit_options)?;
        Ok(if is_current { Changed::Tick } else { Changed::Document })
    }

    pub(super) fn set_look(&mut self, look: Option<Look>) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        face.set_weights(&look.map(Look::weights).unwrap_or([0.0; Expression::ALL.len()]), &self.edit_options)?;
        self.gesture = Gesture::Idle;
        Ok(Changed::Document)
    }

    pub(super) fn reset_expressions(&mut self) -> Result {
        self.open_face()?;
        self.finish(|face, edit_options| {
            face.commit(edit_options);
            face.change_history(edit_options, Document::reset_expressions);
        })
    }

    /// Ends an edit in progress with `end`.
    pub(super) fn finish(&mut self, end: impl FnOnce(&mut OpenFace, &EditOptions)) -> Result {
        self.gesture = Gesture::Idle;
        let Some(face) = &mut self.face else { return Ok(Changed::Nothing) };
        end(face, &self.edit_options);
        Ok(Changed::Document)
    }

    pub(super) fn cancel(&mut self) -> Result {
        let was_dragging = self.has_grabbed();
        let changed = self.finish(OpenFace::cancel)?;
        if was_dragging {
            self.gesture = Gesture::Cancelled;
        }
        Ok(changed)
    }

    pub(super) fn undo(&mut self) -> Result {
        self.finish(|face, edit_options| {
            face.commit(edit_options);
            face.change_history(edit_options, Document::undo);
        })
    }

    pub(super) fn reset(&mut self) -> Result {
        self.finish(|face, edit_options| {
            face.change_history(edit_options, |document| {
                document.reset();
                Some(0)
            });
        })
    }

    pub(super) fn reset_selected(&mut self) -> Result {
        let target = self.open_face()?.selection().ok_or(SessionError::NothingSelected)?.target();
        self.finish(|face, edit_options| face.change_history(edit_options, |document| document.switch_off(target)))
    }

    pub(super) fn switch(&mut self, index: usize, switch: Switch) -> Result {
        let count = self.open_face()?.document().history().entries().len();
        if index >= count {
            return Err(StudioError::NoSuchEntry { index, count }.into());
        }
        self.finish(|face, edit_options| {
            face.change_history(edit_options, |document| document.switch(index, switch).unwrap_or_default());
        })
    }

    pub(super) fn symmetrise(&mut self, share: f64) -> Result {
        within("the share", share, 0.0, 1.0)?;
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        face.symmetrise(share, &self.edit_options)?;
        self.gesture = Gesture::Idle;
        Ok(Changed::Document)
    }

    pub(super) fn set_density(&mut self, density: u32) -> Result {
        within("the density", density.into(), 0.0, MAX_SHOWN_DENSITY.into())?;
        if let Some(face) = &mut self.face {
            face.set_density(density, self.mode, &self.edit_options)?;
            prepare(face, self.mode, &self.edit_options, self.seeds.peek());
        }
        self.new_mesh();
        self.view.density = density;
        Ok(Changed::Mesh)
    }

    pub(super) fn set_triangulation(&mut self, triangulation: Triangulation) -> Result {
        if let Some(face) = &mut self.face {
            face.set_triangulation(triangulation, &self.edit_options)?;
        }
        self.new_mesh();
        self.view.triangulation = triangulation;
        Ok(Changed::Mesh)
    }

    pub(super) fn set_photo_lens(&mut self, lens: PhotoLens) -> Result {
        if self.open_face()?.model().lens() == lens {
            return Ok(Changed::Nothing);
        }
        self.change_photos(|face, edit_options| face.set_photo_lens(lens, edit_options))
    }

    pub(super) fn new_mesh(&mut self) {
        (self.gesture, self.hovered) = (Gesture::Idle, Hovered::default());
    }
}
