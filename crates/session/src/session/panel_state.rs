use super::Session;
use crate::ShapePart;
use crate::changed::Changed;
use crate::error::{SessionError, within};
use crate::open_face::OpenFace;
use crate::panel_state::Tape;

impl Session {
    pub(crate) fn is_expert(&self) -> bool {
        self.panel.is_expert
    }

    pub(crate) fn shape_part(&self) -> ShapePart {
        self.panel.part
    }

    pub(crate) fn symmetry_share(&self) -> f64 {
        self.panel.symmetry_share
    }

    pub(crate) fn tape(&self) -> Option<Tape> {
        self.panel.tape
    }

    pub(crate) fn set_expert(&mut self, is_expert: bool) -> Changed {
        self.panel.is_expert = is_expert;
        Changed::Document
    }

    pub(crate) fn set_shape_part(&mut self, part: ShapePart) -> Changed {
        self.panel.part = part;
        Changed::View
    }

    /// Shows the controls of the part in which the selection lies, unless points are moved by hand.
    pub(crate) fn show_selected_part(&mut self) {
        let Some(selection) = self.face().and_then(OpenFace::selection) else { return };
        if self.panel.part != ShapePart::Point {
            self.panel.part = selection.part();
        }
    }

    pub(crate) fn set_symmetry_share(&mut self, share: f64) -> Result<Changed, SessionError> {
        self.panel.symmetry_share = within("the share", share, 0.0, 1.0)?;
        Ok(Changed::Document)
    }

    /// Starts the tape at the selection; removes it without one.
    pub(crate) fn start_tape(&mut self) -> Changed {
        let from = self.face().and_then(OpenFace::selected);
        self.panel.tape = from.map(|from| Tape { from, measured: None });
        Changed::Document
    }

    /// Measures to the selection. Measuring along a dense mesh takes too long for the ticks of an edit.
    pub(crate) fn update_tape(&mut self) {
        let (Some(tape), Some(face)) = (self.panel.tape, self.face().filter(|face| !face.is_moving())) else { return };
        // The start may not exist in the current mesh.
        if tape.from as usize >= face.document().topology().vertex_count() {
            self.panel.tape = None;
            return;
        }
        let to = face.selected().filter(|&to| to != tape.from);
        let measured = to.and_then(|to| Some((to, face.measured_mm(tape.from, to).ok()?)));
        self.panel.tape = Some(Tape { measured, ..tape });
    }
}
