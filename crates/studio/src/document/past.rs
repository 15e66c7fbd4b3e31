use std::sync::Arc;

use super::Document;
use super::editing::made_ready;
use crate::expressed;
use crate::level::Level;
use crate::level_positions::{LevelPositions, Scratch};
use crate::prepared_edit::PreparedEdit;
use crate::{Command, EditTarget, Entry, EntryStatus, History, StudioError, Switch};

/// What was done, undone and switched. An entry that has no answer on the mesh that is shown is passed over, so that none
/// of these can fail half-way.
impl Document {
    /// The history.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// How an entry of the history takes part in the shape that is shown; none where there is no such entry.
    pub fn status(&self, index: usize) -> Option<&EntryStatus> {
        self.replayed.status(index)
    }

    /// Carries out a command as one entry of the history.
    ///
    /// # Errors
    /// [`StudioError`] if it has no answer; the document is as before.
    pub fn apply(&mut self, label: &str, command: Command) -> Result<(), StudioError> {
        self.fault.check()?;
        let entry = Entry { label: label.to_owned(), command, switch: Switch::On };
        self.check(&entry)?;
        let from = self.replayed.last();
        let (shape, status) = carried_out(&mut self.levels, self.density, from, &entry, &mut Latest::default());
        if let EntryStatus::Impossible(reason) = status {
            return Err(reason);
        }
        self.history.push(entry);
        self.replayed.push(shape, status);
        self.settle_down();
        Ok(())
    }

    /// What a command would displace the mesh that is shown by, if it were carried out now.
    ///
    /// # Errors
    /// [`StudioError`] if it has no answer.
    pub fn displacement(&mut self, command: &Command) -> Result<Vec<glam::DVec3>, StudioError> {
        self.fault.check()?;
        let from = self.replayed.last();
        let to = moved(&mut self.levels, self.density, from, command, &mut Latest::default())?;
        Ok(to.densest().iter().zip(from.densest()).map(|(to, at)| *to - *at).collect())
    }

    /// Takes the last change of the history back: an entry added, entries switched, or all taken away. Returns the first
    /// entry that is no longer what it was; nothing where there was no change.
    pub fn undo(&mut self) -> Option<usize> {
        let first = self.history.undo()?;
        self.follow_history(first);
        Some(first)
    }

    /// Brings the last undone change back. Returns the first entry that is no longer what it was.
    pub fn redo(&mut self) -> Option<usize> {
        let first = self.history.redo()?;
        self.follow_history(first);
        Some(first)
    }

    /// Takes all entries away.
    pub fn reset(&mut self) {
        self.history.clear();
        self.follow_history(0);
    }

    /// Switches an entry on or off; those after it are carried out again. Returns the entry if it was not so already.
    ///
    /// # Errors
    /// [`StudioError::NoSuchEntry`].
    pub fn switch(&mut self, index: usize, switch: Switch) -> Result<Option<usize>, StudioError> {
        let count = self.history.entries().len();
        if index >= count {
            return Err(StudioError::NoSuchEntry { index, count });
        }
        Ok(self.switch_where(|place, _| place == index, switch))
    }

    /// Switches every entry that works on `target` off, as one change. Returns the first that was on.
    pub fn switch_off(&mut self, target: EditTarget) -> Option<usize> {
        self.switch_where(|_, entry| entry.command.target() == target, Switch::Off)
    }

    /// Switches every entry of an expression off, as one change. Returns the first that was on.
    pub fn come_to_rest(&mut self) -> Option<usize> {
        self.switch_where(|_, entry| matches!(entry.command, Command::Express { .. }), Switch::Off)
    }

    fn switch_where(&mut self, which: impl Fn(usize, &Entry) -> bool, switch: Switch) -> Option<usize> {
        let first = self.history.switch(which, switch)?;
        self.follow_history(first);
        Some(first)
    }

    /// Carries the entries from `first` on out again.
    pub(super) fn follow_history(&mut self, first: usize) {
        self.replayed.truncate(first);
        let mut latest = Latest::default();
        for entry in &self.history.entries()[self.replayed.count()..] {
            let from = self.replayed.last();
            let (shape, status) = carried_out(&mut self.levels, self.density, from, entry, &mut latest);
            self.replayed.push(shape, status);
        }
        self.settle_down();
    }

    /// What each entry displaced the mesh that is shown by; they add up to the way from [`Self::rest`] to
    /// [`Self::committed`].
    pub fn displacements(&mut self) -> Vec<Vec<glam::DVec3>> {
        let mut from = Arc::clone(self.replayed.unedited());
        let mut layers = Vec::with_capacity(self.history.entries().len());
        let mut latest = Latest::default();
        for entry in self.history.entries() {
            let (to, _) = carried_out(&mut self.levels, self.density, &from, entry, &mut latest);
            layers.push(to.densest().iter().zip(from.densest()).map(|(to, at)| *to - *at).collect());
            from = to;
        }
        layers
    }
}

/// What carrying out one entry leaves for the next: often the same is moved again.
#[derive(Default)]
struct Latest {
    prepared: Option<PreparedEdit>,
    scratch: Scratch,
}

/// The shape that `entry` makes of the one before it: that one itself, unless the entry is in force.
fn carried_out(
    levels: &mut [Level],
    density: u32,
    from: &Arc<LevelPositions>,
    entry: &Entry,
    latest: &mut Latest,
) -> (Arc<LevelPositions>, EntryStatus) {
    let status = match &entry.command {
        _ if entry.switch == Switch::Off => EntryStatus::Off,
        Command::Move { spec, .. } if spec.level > density => EntryStatus::Waits { level: spec.level },
        command => match moved(levels, density, from, command, latest) {
            Ok(shape) => return (Arc::new(shape), EntryStatus::InForce),
            Err(reason) => EntryStatus::Impossible(reason),
        },
    };
    (Arc::clone(from), status)
}

fn moved(
    levels: &mut [Level],
    density: u32,
    from: &LevelPositions,
    command: &Command,
    latest: &mut Latest,
) -> Result<LevelPositions, StudioError> {
    let mut shape = from.clone();
    match command {
        Command::Move { spec, offsets } => {
            let known = latest.prepared.take().filter(|prepared| prepared.spec() == spec && !prepared.turns_details());
            let mut prepared = known.map_or_else(|| made_ready(levels, density, from, spec.clone()), Ok)?;
            shape.displace(levels, from, &mut prepared, offsets, &mut latest.scratch)?;
            latest.prepared = Some(prepared);
        }
        &Command::Symmetrise { share } => shape.symmetrise(levels, share)?,
        &Command::Express { expression, weight } => {
            expressed::prepare(levels, density, expression)?;
            shape.express(levels, expression, weight);
        }
    }
    match shape.not_finite() {
        Some(vertex) => Err(rosto_laplacian::LaplacianError::NotFinite { vertex }.into()),
        None => Ok(shape),
    }
}
