use std::sync::Arc;

use super::Document;
use super::editing::prepare_edit;
use super::solved::Solved;
use crate::level::Level;
use crate::shape::Shape;
use crate::slider_measures::SliderAmounts;
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

    /// Amount of each ready-made slider that comes closest to the shape after an entry, in metres and without
    /// expressions.
    pub fn slider_amounts_m(&self, index: usize) -> SliderAmounts {
        self.replayed.amounts_m(index).copied().unwrap_or_default()
    }

    /// The same for the movement of the edit in progress.
    pub fn preview_amounts_m(&self) -> SliderAmounts {
        let (now, before) = (self.positions(), self.committed());
        let moved_m = |landmark: usize| Some(*now.get(landmark)? - *before.get(landmark)?);
        self.replayed.measures().of(|landmark| moved_m(landmark).unwrap_or_default())
    }

    /// Applies a command as one entry of the history.
    ///
    /// # Errors
    /// [`StudioError`] if it has no solution; the document is unchanged.
    pub fn apply(&mut self, label: &str, command: Command) -> Result<(), StudioError> {
        self.fault.check()?;
        self.check_room(1)?;
        let entry = Entry { label: label.to_owned(), command, switch: Switch::On };
        self.check(&entry)?;
        if let Command::Move { spec, .. } = &entry.command {
            self.check_work_with(spec)?;
        }
        let from = self.replayed.last();
        let (shape, status) = replayed(&mut self.levels, self.density, from, &entry, &mut Solved::default());
        if let EntryStatus::Impossible(reason) = status {
            return Err(reason);
        }
        self.history.push(entry);
        self.replayed.push(shape, status);
        self.settle();
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
        let to = applied(&mut self.levels, self.density, from, command, &mut Solved::default())?;
        let to = to.positions(&self.levels);
        Ok(to.densest().iter().zip(self.committed()).map(|(to, at)| *to - *at).collect())
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
        let mut solved = Solved::default();
        for entry in &self.history.entries()[self.replayed.count()..] {
            let from = self.replayed.last();
            let (shape, status) = replayed(&mut self.levels, self.density, from, entry, &mut solved);
            self.replayed.push(shape, status);
        }
        self.settle();
        self.end_preview();
    }

    /// Displacement of the displayed mesh by each entry. They add up to the difference between [`Self::committed`] and
    /// [`Self::rest`].
    pub fn displacements(&mut self) -> Vec<Vec<glam::DVec3>> {
        let mut shape = Arc::clone(self.replayed.unedited());
        let mut from = shape.positions(&self.levels);
        let mut layers = Vec::with_capacity(self.history.entries().len());
        let mut solved = Solved::default();
        for entry in self.history.entries() {
            (shape, _) = replayed(&mut self.levels, self.density, &shape, entry, &mut solved);
            let to = shape.positions(&self.levels);
            layers.push(to.densest().iter().zip(from.densest()).map(|(to, at)| *to - *at).collect());
            from = to;
        }
        layers
    }
}

/// Applies `entry` to the shape before it. Returns that shape unchanged unless the entry is in force.
fn replayed(
    levels: &mut [Level],
    density: u32,
    from: &Arc<Shape>,
    entry: &Entry,
    solved: &mut Solved,
) -> (Arc<Shape>, EntryStatus) {
    let status = match &entry.command {
        _ if entry.switch == Switch::Off => EntryStatus::Off,
        Command::Move { spec, .. } if spec.level > density => EntryStatus::Waits { level: spec.level },
        command => match applied(levels, density, from, command, solved) {
            Ok(shape) => return (Arc::new(shape), EntryStatus::InForce),
            Err(reason) => EntryStatus::Impossible(reason),
        },
    };
    (Arc::clone(from), status)
}

fn applied(
    levels: &mut [Level],
    density: u32,
    from: &Shape,
    command: &Command,
    solved: &mut Solved,
) -> Result<Shape, StudioError> {
    let mut shape = from.clone();
    match command {
        Command::Move { spec, offsets } => {
            let (edit, scratch) = solved.edit(spec, || prepare_edit(levels, density, from, spec.clone()))?;
            shape.displace(levels, edit, offsets, scratch)?;
        }
        &Command::Symmetrise { share } => shape.symmetrise(levels, share)?,
        &Command::Express { expression, weight } => shape.express(levels, expression, weight)?,
    }
    Ok(shape)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use rosto_face::{Triangulation, canonical_positions_m};

    use super::*;
    use crate::{CoordinateFrame, Rest};

    /// Counts instead of measuring time: the solves of a replay, and the memory of its shapes.
    #[test]
    fn a_replay_solves_once_for_each_spec_and_interpolates_no_entry() {
        let topology = Triangulation::Canonical.topology();
        let rest = Rest::of_landmarks(topology, canonical_positions_m(), CoordinateFrame::Model);
        let mut document = Document::new(rest).unwrap();
        document.set_density(2).unwrap();
        let mut solved = Solved::default();
        let mut shape = Arc::clone(document.replayed.unedited());
        for index in 0..3_000 {
            let command = Command::move_vertex(0, index % 10, DVec3::Z * 1e-6);
            let entry = Entry { label: String::new(), command, switch: Switch::On };
            (shape, _) = replayed(&mut document.levels, 2, &shape, &entry, &mut solved);
        }
        assert_eq!(solved.solves, 10);
        let cage_bytes = size_of_val(document.cage());
        assert!(shape.bytes() < 2 * cage_bytes, "{} bytes; the cage has {cage_bytes}", shape.bytes());
    }
}
