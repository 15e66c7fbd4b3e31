use std::collections::VecDeque;

use crate::{Command, StudioError};

/// A command in the history, with a label and a switch.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Text shown to the user, such as "nose tip".
    pub label: String,
    /// The change to the mesh.
    pub command: Command,
    /// Whether the entry is applied.
    pub switch: Switch,
}

rosto_mesh::named! {
    /// Whether an entry of the history is applied.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Switch {
        /// The entry is applied.
        #[default]
        On = "on",
        /// The entry is skipped but stays in the history.
        Off = "off",
    }
}

/// How an entry takes part in the displayed shape.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum EntryStatus {
    /// It is applied.
    #[default]
    InForce,
    /// It is switched off.
    Off,
    /// It needs a denser mesh than the displayed one.
    Waits {
        /// Subdivision level of that mesh.
        level: u32,
    },
    /// It has no solution on this mesh, such as after a change of triangulation, and is skipped.
    Impossible(StudioError),
}

/// Limit on the entries retained for undo, over all changes; the oldest changes are discarded first.
const MAX_UNDO_ENTRIES: usize = 100_000;

/// The commands of a document in order, with undo and redo of changes to the list: adding entries, switching entries,
/// and removing all.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    entries: Vec<Entry>,
    done: VecDeque<Change>,
    undone: Vec<Change>,
    /// Number of entries in `done`, over all changes.
    retained: usize,
}

/// Replacement of a run of entries by another; all changes of the list have this form.
#[derive(Debug, Clone, PartialEq)]
struct Change {
    at: usize,
    before: Vec<Entry>,
    after: Vec<Entry>,
}

impl History {
    /// The entries, oldest first, without undone ones.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Whether there is a change to undo.
    pub fn can_undo(&self) -> bool {
        !self.done.is_empty()
    }

    /// Whether there is an undone change to redo.
    pub fn can_redo(&self) -> bool {
        !self.undone.is_empty()
    }

    /// Adds an entry and discards undone changes.
    pub(crate) fn push(&mut self, entry: Entry) {
        self.push_all(vec![entry]);
    }

    /// Adds entries as one change.
    pub(crate) fn push_all(&mut self, entries: Vec<Entry>) {
        self.change(Change { at: self.entries.len(), before: Vec::new(), after: entries });
    }

    /// Removes all entries.
    pub(crate) fn clear(&mut self) {
        if !self.entries.is_empty() {
            self.change(Change { at: 0, before: self.entries.clone(), after: Vec::new() });
        }
    }

    /// Switches the entries that `which` accepts; returns the index of the first that changed.
    pub(crate) fn switch(&mut self, which: impl Fn(usize, &Entry) -> bool, switch: Switch) -> Option<usize> {
        let changes = |(index, entry): (usize, &Entry)| which(index, entry) && entry.switch != switch;
        let at = self.entries.iter().enumerate().position(changes)?;
        let last = (0..self.entries.len()).rfind(|&index| changes((index, &self.entries[index])))?;
        let before = self.entries[at..=last].to_vec();
        let switched = |(index, entry): (usize, &Entry)| Entry {
            switch: if which(index, entry) { switch } else { entry.switch },
            ..entry.clone()
        };
        let after = (at..=last).map(|index| switched((index, &self.entries[index]))).collect();
        self.change(Change { at, before, after });
        Some(at)
    }

    /// Undoes the last change; returns the index of the first entry that changed.
    pub(crate) fn undo(&mut self) -> Option<usize> {
        let change = self.done.pop_back()?;
        self.retained -= change.size();
        self.entries.splice(change.at..change.at + change.after.len(), change.before.iter().cloned());
        let at = change.at;
        self.undone.push(change);
        Some(at)
    }

    /// Redoes the last undone change; returns the index of the first entry that changed.
    pub(crate) fn redo(&mut self) -> Option<usize> {
        let change = self.undone.pop()?;
        self.entries.splice(change.at..change.at + change.before.len(), change.after.iter().cloned());
        let at = change.at;
        self.retained += change.size();
        self.done.push_back(change);
        Some(at)
    }

    /// All commands in the list and in the undo and redo stacks.
    pub(crate) fn commands(&self) -> impl Iterator<Item = &Command> {
        let changes = self.done.iter().chain(&self.undone);
        let changed = changes.flat_map(|change| change.before.iter().chain(&change.after));
        self.entries.iter().chain(changed).map(|entry| &entry.command)
    }

    /// Creates a history in which the entries were added one by one.
    pub(crate) fn of_entries(entries: Vec<Entry>) -> Self {
        let added = |(at, entry): (usize, &Entry)| Change { at, before: Vec::new(), after: vec![entry.clone()] };
        let dropped = entries.len().saturating_sub(MAX_UNDO_ENTRIES);
        let done: VecDeque<Change> = entries.iter().enumerate().skip(dropped).map(added).collect();
        Self { retained: done.len(), entries, done, undone: Vec::new() }
    }

    /// Applies `alter` to all commands, including those for undo and redo.
    pub(crate) fn with_commands(mut self, mut alter: impl FnMut(&mut Command)) -> Self {
        let changes = self.done.iter_mut().chain(&mut self.undone);
        let changed = changes.flat_map(|change| change.before.iter_mut().chain(&mut change.after));
        self.entries.iter_mut().chain(changed).for_each(|entry| alter(&mut entry.command));
        self
    }

    fn change(&mut self, change: Change) {
        self.undone = vec![change];
        self.redo();
        self.drop_oldest();
    }

    fn drop_oldest(&mut self) {
        while self.retained > MAX_UNDO_ENTRIES && self.done.len() > 1 {
            self.retained -= self.done.pop_front().map_or(0, |change| change.size());
        }
    }
}

impl Change {
    fn size(&self) -> usize {
        self.before.len() + self.after.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn undo_is_bounded_and_drops_the_oldest_changes() {
        let mut history = History::default();
        let entry = Entry { label: String::new(), command: Command::Symmetrise { share: 0.5 }, switch: Switch::On };
        history.push(entry);
        for _ in 0..MAX_UNDO_ENTRIES / 2 {
            history.switch(|_, _| true, Switch::Off);
            history.switch(|_, _| true, Switch::On);
        }
        let latest = history.entries().to_vec();
        let undone_changes = std::iter::from_fn(|| history.undo()).count();
        assert_eq!(undone_changes, MAX_UNDO_ENTRIES / 2);
        assert_eq!(history.entries().len(), 1, "the change that added the entry is no longer retained");
        assert_eq!(std::iter::from_fn(|| history.redo()).count(), undone_changes);
        assert_eq!(history.entries(), latest);
    }
}
