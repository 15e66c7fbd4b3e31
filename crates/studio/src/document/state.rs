use std::sync::Arc;

use super::Document;
use super::editing::Preview;
use super::replay_cache::ReplayCache;
use crate::level_positions::LevelPositions;
use crate::prepared_edit::PreparedEdit;
use crate::{History, InfluenceWeights};

/// Snapshot of a document, without the factorisations of its meshes.
pub struct DocumentState {
    density: u32,
    history: History,
    replayed: ReplayCache,
    committed: Arc<LevelPositions>,
    prepared: Option<PreparedEdit>,
    influence: Option<InfluenceWeights>,
    preview: Preview,
}

impl Document {
    /// Takes a snapshot, including the edit in progress.
    pub fn state(&self) -> DocumentState {
        DocumentState {
            density: self.density,
            history: self.history.clone(),
            replayed: self.replayed.clone(),
            committed: Arc::clone(&self.committed),
            prepared: self.prepared.clone(),
            influence: self.influence.clone(),
            preview: self.preview.clone(),
        }
    }

    /// Restores a snapshot of this document.
    pub fn restore(&mut self, state: DocumentState) {
        let DocumentState { density, history, replayed, committed, prepared, influence, preview } = state;
        (self.density, self.history, self.replayed, self.committed) = (density, history, replayed, committed);
        (self.prepared, self.influence, self.preview) = (prepared, influence, preview);
    }

    /// Makes the fallible call after the next `calls` ones fail.
    #[cfg(feature = "faults")]
    pub fn fail_after(&mut self, calls: u32) {
        self.fault.calls_until = Some(calls);
    }

    /// Whether that failure is still pending.
    #[cfg(feature = "faults")]
    pub fn is_to_fail(&self) -> bool {
        self.fault.calls_until.is_some()
    }
}
