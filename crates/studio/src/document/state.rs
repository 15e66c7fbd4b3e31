use super::Document;
use super::editing::Preview;
use super::replay_cache::ReplayCache;
use crate::prepared_edit::PreparedEdit;
use crate::{History, InfluenceWeights};

/// What a document holds, apart from the factors of its meshes: a copy to go back to.
pub struct DocumentState {
    density: u32,
    history: History,
    replayed: ReplayCache,
    prepared: Option<PreparedEdit>,
    influence: Option<InfluenceWeights>,
    preview: Preview,
}

impl Document {
    /// A copy of what it holds now, with the edit in progress.
    pub fn state(&self) -> DocumentState {
        DocumentState {
            density: self.density,
            history: self.history.clone(),
            replayed: self.replayed.clone(),
            prepared: self.prepared.clone(),
            influence: self.influence.clone(),
            preview: self.preview.clone(),
        }
    }

    /// Goes back to what this document held.
    pub fn restore(&mut self, state: DocumentState) {
        let DocumentState { density, history, replayed, prepared, influence, preview } = state;
        (self.density, self.history, self.replayed) = (density, history, replayed);
        (self.prepared, self.influence, self.preview) = (prepared, influence, preview);
    }

    /// Has the call after the next `calls` fallible ones fail, whatever it is.
    #[cfg(feature = "faults")]
    pub fn fail_after(&mut self, calls: u32) {
        self.fault.calls_until = Some(calls);
    }

    /// Whether that failure is still to come.
    #[cfg(feature = "faults")]
    pub fn is_to_fail(&self) -> bool {
        self.fault.calls_until.is_some()
    }
}
