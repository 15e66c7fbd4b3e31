use std::collections::HashSet;

use super::Document;
use crate::spec_key::SpecKey;
use crate::{Command, Details, EditSpec, Entry, Mirror, StudioError};

/// Maximum number of entries in a history.
pub const MAX_ENTRIES: usize = 25_000;

/// Maximum length of an entry's label, in characters.
pub const MAX_LABEL_CHARS: usize = 200;

/// Maximum work of replaying a history, in displaced vertices: about half a minute on one core.
const MAX_WORK: u64 = 4_000_000_000;
/// Cost of a solve for one handle, in displacements by it.
const SOLVE: u64 = 60;
/// Cost of turning details, which is solved iteratively for each entry.
const TURN: u64 = 2000;

impl Document {
    /// Rejects `added` more entries if the history would become too long to be opened again.
    pub(super) fn check_room(&self, added: usize) -> Result<(), StudioError> {
        check_count(self.history.entries().len() + added)
    }

    /// Rejects an edit if the history would need too many solves with it.
    pub(super) fn check_work_with(&self, spec: &EditSpec) -> Result<(), StudioError> {
        self.check_work(specs(self.history.entries()).chain([spec]))
    }

    /// Rejects entries of a file that are too many or need too many solves.
    pub(super) fn check_all(&self, entries: &[Entry]) -> Result<(), StudioError> {
        check_count(entries.len())?;
        self.check_work(specs(entries))
    }

    fn check_work<'a>(&self, specs: impl Iterator<Item = &'a EditSpec>) -> Result<(), StudioError> {
        let mut solved = HashSet::new();
        let mut work: u64 = 0;
        for spec in specs {
            let handles = spec.handles.len() as u64 * if spec.settings.mirror == Mirror::On { 2 } else { 1 };
            let cost = match spec.settings.details {
                Details::AsRigidAsPossible => SOLVE * handles + TURN,
                Details::Kept if solved.insert(SpecKey::of(spec)) => SOLVE * handles,
                Details::Kept => handles,
            };
            work = work.saturating_add(cost * self.vertices_at(spec.level)? as u64);
        }
        if work > MAX_WORK { Err(StudioError::TooMuchWork { work, max: MAX_WORK }) } else { Ok(()) }
    }
}

fn specs(entries: &[Entry]) -> impl Iterator<Item = &EditSpec> {
    entries.iter().filter_map(|entry| match &entry.command {
        Command::Move { spec, .. } => Some(spec),
        Command::Symmetrise { .. } | Command::Express { .. } => None,
    })
}

fn check_count(found: usize) -> Result<(), StudioError> {
    if found > MAX_ENTRIES { Err(StudioError::TooManyEntries { found, max: MAX_ENTRIES }) } else { Ok(()) }
}
