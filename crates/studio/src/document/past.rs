use std::sync::Arc;

use super::Document;
use super::editing::prepare_edit;
use crate::expression_cache;
use crate::level::Level;
use crate::level_positions::{LevelPositions, Scratch};
use crate::prepared_edit::PreparedEdit;
use crate::{Command, EditTarget, Entry, EntryStatus, History, StudioError, Switch};

/// Applying, undoing and switching commands. Entries that cannot be applied to the displayed mesh are skipped, so that
/// none of these operations stops halfway.
impl Document {
    /// The commands applied so far.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Status of an entry on the displayed mesh; `None` if there is no such entry.
    pub fn status(&self, index: usize) -> Option<&EntryStatus> {
        self.replayed.status(index)
    }

    /// Applies a command as one entry of the history.
    ///
    /// # Errors
    /// [`StudioError`] if it has no solution; the document is unchanged.
    pub fn apply(&mut self, label: &str, command: Command) -> Result<(), StudioError> {
        self.fault.check()?;
        let entry = Entry { label: label.to_owned(), command, switch: Switch::On };
        self.check(&entry)?;
        let from = self.replayed.last();
        let (shape, status) = replayed(&mut self.levels, self.density, from, &entry, &mut Latest::default());
        if let EntryStatus::Impossible(reason) = status {
            return Err(reason);
        }
        self.history.push(entry);
        self.replayed.push(shape, status);
        self.end_preview();
        Ok(())
    }

    /// Displacement of the displayed mesh that a command would cause now.
    ///
    /// # Errors
    /// [`StudioError`] if it has no solution.
    pub fn displacement(&mut self, command: &Command) -> Result<Vec<glam::DVec3>, StudioError> {
        self.fault.check()?;
        let from = self.replayed.last();
        let to = applied(&mut self.levels, self.density, from, command, &mut Latest::default())?;
        Ok(to.densest().iter().zip(from.densest()).map(|(to, at)| *to - *at).collect())
    }

    /// Undoes the last change of the history: an added entry, switched entries, or a reset. Returns the index of the
    /// first entry that changed; `None` if there was no change.
    pub fn undo(&mut self) -> Option<usize> {
        let first = self.history.undo()?;
        self.replay_from(first);
        Some(first)
    }

    /// Redoes the last undone change. Returns the index of the first entry that changed.
    pub fn redo(&mut self) -> Option<usize> {
        let first = self.history.redo()?;
        self.replay_from(first);
        Some(first)
    }

    /// Removes all entries.
    pub fn reset(&mut self) {
        self.history.clear();
        self.replay_from(0);
    }

    /// Switches an entry on or off and replays those after it. Returns the entry's index if it changed.
    ///
    /// # Errors
    /// [`StudioError::NoSuchEntry`].
    pub fn switch(&mut self, index: usize, switch: Switch) -> Result<Option<usize>, StudioError> {
        let count = self.history.entries().len();
        if index >= count {
            return Err(StudioError::NoSuchEntry { index, count });
        }
        Ok(self.switch_where(|at, _| at == index, switch))
    }

    /// Switches off each entry that edits `target`, as one change. Returns the index of the first that was on.
    pub fn switch_off(&mut self, target: EditTarget) -> Option<usize> {
        self.switch_where(|_, entry| entry.command.target() == target, Switch::Off)
    }

    /// Switches off each expression, as one change. Returns the index of the first that was on.
    pub fn reset_expressions(&mut self) -> Option<usize> {
        self.switch_where(|_, entry| matches!(entry.command, Command::Express { .. }), Switch::Off)
    }

    fn switch_where(&mut self, which: impl Fn(usize, &Entry) -> bool, switch: Switch) -> Option<usize> {
        let first = self.history.switch(which, switch)?;
        self.replay_from(first);
        Some(first)
    }

    /// Replays the entries from `first` on.
    pub(super) fn replay_from(&mut self, first: usize) {
        self.replayed.truncate(first);
        let mut latest = Latest::default();
        for entry in &self.history.entries()[self.replayed.count()..] {
            let from = self.replayed.last();
            let (shape, status) = replayed(&mut self.levels, self.density, from, entry, &mut latest);
            self.replayed.push(shape, status);
        }
        self.end_preview();
    }

    /// Displacement of the displayed mesh by each entry. They add up to the difference between [`Self::committed`] and
    /// [`Self::rest`].
    pub fn displacements(&mut self) -> Vec<Vec<glam::DVec3>> {
        let mut from = Arc::clone(self.replayed.unedited());
        let mut layers = Vec::with_capacity(self.history.entries().len());
        let mut latest = Latest::default();
        for entry in self.history.entries() {
            let (to, _) = replayed(&mut self.levels, self.density, &from, entry, &mut latest);
            layers.push(to.densest().iter().zip(from.densest()).map(|(to, at)| *to - *at).collect());
            from = to;
        }
        layers
    }
}

/// State that applying one entry leaves for the next: consecutive entries often share a spec.
#[derive(Default)]
struct Latest {
    prepared: Option<PreparedEdit>,
    scratch: Scratch,
}

/// Applies `entry` to the shape before it. Returns that shape unchanged unless the entry is in force.
fn replayed(
    levels: &mut [Level],
    density: u32,
    from: &Arc<LevelPositions>,
    entry: &Entry,
    latest: &mut Latest,
) -> (Arc<LevelPositions>, EntryStatus) {
    let status = match &entry.command {
        _ if entry.switch == Switch::Off => EntryStatus::Off,
        Command::Move { spec, .. } if spec.level > density => EntryStatus::Waits { level: spec.level },
        command => match applied(levels, density, from, command, latest) {
            Ok(shape) => return (Arc::new(shape), EntryStatus::InForce),
            Err(reason) => EntryStatus::Impossible(reason),
        },
    };
    (Arc::clone(from), status)
}

fn applied(
    levels: &mut [Level],
    density: u32,
    from: &LevelPositions,
    command: &Command,
    latest: &mut Latest,
) -> Result<LevelPositions, StudioError> {
    let mut shape = from.clone();
    match command {
        Command::Move { spec, offsets } => {
            let reusable =
                latest.prepared.take().filter(|prepared| prepared.spec() == spec && !prepared.turns_details());
            let mut prepared = reusable.map_or_else(|| prepare_edit(levels, density, from, spec.clone()), Ok)?;
            shape.displace(levels, from, &mut prepared, offsets, &mut latest.scratch)?;
            latest.prepared = Some(prepared);
        }
        &Command::Symmetrise { share } => shape.symmetrise(levels, share)?,
        &Command::Express { expression, weight } => {
            expression_cache::prepare(levels, density, expression)?;
            shape.express(levels, expression, weight);
        }
    }
    match shape.not_finite() {
        Some(vertex) => Err(rosto_laplacian::LaplacianError::NotFinite { vertex }.into()),
        None => Ok(shape),
    }
}
