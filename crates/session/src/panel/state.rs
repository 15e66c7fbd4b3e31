use rosto_studio::EditTarget;

use super::Phrase;
use crate::error::within;
use crate::{Changed, OpenFace, Session, SessionError};

/// State that only panels have.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PanelState {
    is_expert: bool,
    symmetry_share: f64,
    tape: Option<Tape>,
}

/// The measuring tape.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tape {
    /// Vertex at its start.
    pub from: u32,
    /// Vertex at its end, and the distance in mm: straight, and along the surface.
    pub measured: Option<(u32, [f64; 2])>,
}

impl Default for PanelState {
    fn default() -> Self {
        Self { is_expert: false, symmetry_share: 0.5, tape: None }
    }
}

impl PanelState {
    /// The state for another face.
    pub fn for_another_face(self) -> Self {
        Self { is_expert: self.is_expert, ..Self::default() }
    }
}

impl Session {
    pub(super) fn is_expert(&self) -> bool {
        self.panel.is_expert
    }

    pub(super) fn symmetry_share(&self) -> f64 {
        self.panel.symmetry_share
    }

    pub(super) fn tape(&self) -> Option<Tape> {
        self.panel.tape
    }

    pub(crate) fn set_expert(&mut self, is_expert: bool) -> Changed {
        self.panel.is_expert = is_expert;
        Changed::Document
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

    /// Name of a vertex, or its number if it is not a landmark.
    pub(super) fn vertex_name(&self, vertex: u32) -> Phrase {
        match vertex {
            landmark if (landmark as usize) < rosto_face::LANDMARK_COUNT => {
                self.name_of(EditTarget::Landmark(landmark))
            }
            other => Phrase::word("target.point").number("n", other.into(), 0),
        }
    }
}
