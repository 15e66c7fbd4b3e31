use std::collections::VecDeque;

use crate::{Command, StudioError};

/// One step of the history: a command, what to call it, and whether it is in force.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// What people see, such as "nose tip".
    pub label: String,
    /// What was done.
    pub command: Command,
    /// Whether it counts.
    pub switch: Switch,
}

rosto_mesh::named! {
    /// Whether an entry of the history counts.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Switch {
        /// It does.
        #[default]
        On = "on",
        /// It is passed over, but kept.
        Off = "off",
    }
}

/// How an entry takes part in the shape that is shown.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum EntryStatus {
    /// It does.
    #[default]
    InForce,
    /// It is switched off.
    Off,
    /// It is meant for a denser mesh than the one that is shown.
    Waits {
        /// How often that mesh is subdivided.
        level: u32,
    },
    /// It has no answer on this mesh, such as one with other triangles, and is passed over.
    Impossible(StudioError),
}

/// What changes that can be taken back may hold together, in entries; the oldest are forgotten first.
const MOST_REMEMBERED: usize = 100_000;

/// The commands of a document in order, and how the list came about: adding an entry, switching some, and taking all away
/// can each be undone and redone.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    entries: Vec<Entry>,
    done: VecDeque<Change>,
    undone: Vec<Change>,
    /// How many entries `done` holds, in all changes together.
    remembered: usize,
}

/// A run of entries that took the place of another: every change of the list is one.
#[derive(Debug, Clone, PartialEq)]
struct Change {
    at: usize,
    before: Vec<Entry>,
    after: Vec<Entry>,
}

impl History {
    /// The entries, oldest first, without what was undone.
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

    /// Adds an entry; what was undone is forgotten.
    pub(crate) fn push(&mut self, entry: Entry) {
        self.push_all(vec![entry]);
    }

    /// Adds entries as one change.
    pub(crate) fn push_all(&mut self, entries: Vec<Entry>) {
        self.change(Change { at: self.entries.len(), before: Vec::new(), after: entries });
    }

    /// Takes all entries away.
    pub(crate) fn clear(&mut self) {
        if !self.entries.is_empty() {
            self.change(Change { at: 0, before: self.entries.clone(), after: Vec::new() });
        }
    }

    /// Switches the entries that `which` accepts by their place; returns the first that changed.
    pub(crate) fn switch(&mut self, which: impl Fn(usize, &Entry) -> bool, switch: Switch) -> Option<usize> {
        let changes = |(place, entry): (usize, &Entry)| which(place, entry) && entry.switch != switch;
        let at = self.entries.iter().enumerate().position(changes)?;
        let last = (0..self.entries.len()).rfind(|&place| changes((place, &self.entries[place])))?;
        let before = self.entries[at..=last].to_vec();
        let switched = |(place, entry): (usize, &Entry)| Entry {
            switch: if which(place, entry) { switch } else { entry.switch },
            ..entry.clone()
        };
        let after = (at..=last).map(|place| switched((place, &self.entries[place]))).collect();
        self.change(Change { at, before, after });
        Some(at)
    }

    /// Takes the last change back; returns the first entry that is no longer what it was.
    pub(crate) fn undo(&mut self) -> Option<usize> {
        let change = self.done.pop_back()?;
        self.remembered -= change.size();
        self.entries.splice(change.at..change.at + change.after.len(), change.before.iter().cloned());
        let at = change.at;
        self.undone.push(change);
        Some(at)
    }

    /// Brings the last undone change back; returns the first entry that is no longer what it was.
    pub(crate) fn redo(&mut self) -> Option<usize> {
        let change = self.undone.pop()?;
        self.entries.splice(change.at..change.at + change.before.len(), change.after.iter().cloned());
        let at = change.at;
        self.remembered += change.size();
        self.done.push_back(change);
        Some(at)
    }

    /// All commands that there are, were or may be again.
    pub(crate) fn commands(&self) -> impl Iterator<Item = &Command> {
        let changes = self.done.iter().chain(&self.undone);
        let changed = changes.flat_map(|change| change.before.iter().chain(&change.after));
        self.entries.iter().chain(changed).map(|entry| &entry.command)
    }

    /// The history in which these entries were added one by one.
    pub(crate) fn of_entries(entries: Vec<Entry>) -> Self {
        let added = |(at, entry): (usize, &Entry)| Change { at, before: Vec::new(), after: vec![entry.clone()] };
        let forgotten = entries.len().saturating_sub(MOST_REMEMBERED);
        let done: VecDeque<Change> = entries.iter().enumerate().skip(forgotten).map(added).collect();
        Self { remembered: done.len(), entries, done, undone: Vec::new() }
    }

    /// The same history of other commands.
    pub(crate) fn with_commands(mut self, mut alter: impl FnMut(&mut Command)) -> Self {
        let changes = self.done.iter_mut().chain(&mut self.undone);
        let changed = changes.flat_map(|change| change.before.iter_mut().chain(&mut change.after));
        self.entries.iter_mut().chain(changed).for_each(|entry| alter(&mut entry.command));
        self
    }

    fn change(&mut self, change: Change) {
        self.undone = vec![change];
        self.redo();
        self.forget_the_oldest();
    }

    fn forget_the_oldest(&mut self) {
        while self.remembered > MOST_REMEMBERED && self.done.len() > 1 {
            self.remembered -= self.done.pop_front().map_or(0, |change| change.size());
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
    fn what_can_be_taken_back_has_a_bound_and_the_oldest_is_forgotten_first() {
        let mut history = History::default();
        let entry = Entry { label: String::new(), command: Command::Symmetrise { share: 0.5 }, switch: Switch::On };
        history.push(entry);
        for _ in 0..MOST_REMEMBERED / 2 {
            history.switch(|_, _| true, Switch::Off);
            history.switch(|_, _| true, Switch::On);
        }
        let latest = history.entries().to_vec();
        let taken_back = std::iter::from_fn(|| history.undo()).count();
        assert_eq!(taken_back, MOST_REMEMBERED / 2);
        assert_eq!(history.entries().len(), 1, "the entry itself was added before all that can be taken back");
        assert_eq!(std::iter::from_fn(|| history.redo()).count(), taken_back);
        assert_eq!(history.entries(), latest);
    }
}
