use crate::Command;

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

/// Whether an entry of the history counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Switch {
    /// It does.
    #[default]
    On,
    /// It is passed over, but kept.
    Off,
}

/// The commands of a document in order, with those that were undone still at hand.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    entries: Vec<Entry>,
    applied: usize,
}

impl History {
    /// All entries, those that were undone last.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The entries that are not undone, switched on or off.
    pub fn applied(&self) -> &[Entry] {
        &self.entries[..self.applied]
    }

    /// Whether there is an entry to undo.
    pub fn can_undo(&self) -> bool {
        self.applied > 0
    }

    /// Whether there is an undone entry to redo.
    pub fn can_redo(&self) -> bool {
        self.applied < self.entries.len()
    }

    /// Adds an entry; what was undone is forgotten.
    pub(crate) fn push(&mut self, entry: Entry) {
        self.entries.truncate(self.applied);
        self.entries.push(entry);
        self.applied += 1;
    }

    pub(crate) fn undo(&mut self) {
        self.applied -= 1;
    }

    pub(crate) fn redo(&mut self) {
        self.applied += 1;
    }

    pub(crate) fn undo_all(&mut self) {
        self.applied = 0;
    }

    pub(crate) fn set_switch(&mut self, index: usize, switch: Switch) {
        self.entries[index].switch = switch;
    }
}
