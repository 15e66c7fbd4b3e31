use super::Document;
use super::editing::made_ready;
use crate::level::Level;
use crate::shape::{Room, Shape};
use crate::{Command, Entry, History, StudioError, Subject, Switch};

/// What was done, undone and switched.
impl Document {
    /// The history.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Carries out a command as one entry of the history.
    ///
    /// # Errors
    /// [`StudioError`] if it has no answer; the document is as before.
    pub fn apply(&mut self, label: &str, command: Command) -> Result<(), StudioError> {
        self.push(Entry { label: label.to_owned(), command, switch: Switch::On })
    }

    /// Takes the last change of the history back: an entry added, entries switched, or all taken away. Without one,
    /// nothing happens.
    ///
    /// # Errors
    /// [`StudioError`] if an entry that comes back cannot be carried out at this density; the document is as before.
    pub fn undo(&mut self) -> Result<(), StudioError> {
        let mut history = self.history.clone();
        history.undo().map_or(Ok(()), |first| self.adopt(history, first))
    }

    /// Brings the last undone change back. Without one, nothing happens.
    ///
    /// # Errors
    /// As for [`Self::undo`].
    pub fn redo(&mut self) -> Result<(), StudioError> {
        let mut history = self.history.clone();
        history.redo().map_or(Ok(()), |first| self.adopt(history, first))
    }

    /// Takes all entries away.
    pub fn reset(&mut self) {
        self.history.clear();
        self.after.clear();
        self.settle_down();
    }

    /// Switches an entry on or off; those after it are carried out again.
    ///
    /// # Errors
    /// [`StudioError::NoSuchEntry`], or that of a later entry that can no longer be carried out; the document is as before.
    pub fn switch(&mut self, index: usize, switch: Switch) -> Result<(), StudioError> {
        let count = self.history.entries().len();
        if index >= count {
            return Err(StudioError::NoSuchEntry { index, count });
        }
        self.switch_where(|place, _| place == index, switch)
    }

    /// Switches every entry that works on `subject` off, as one change.
    ///
    /// # Errors
    /// That of a later entry that can no longer be carried out; the document is as before.
    pub fn switch_off(&mut self, subject: Subject) -> Result<(), StudioError> {
        self.switch_where(|_, entry| entry.command.subject() == subject, Switch::Off)
    }

    fn switch_where(&mut self, which: impl Fn(usize, &Entry) -> bool, switch: Switch) -> Result<(), StudioError> {
        let mut history = self.history.clone();
        history.switch(which, switch).map_or(Ok(()), |first| self.adopt(history, first))
    }

    pub(super) fn push(&mut self, entry: Entry) -> Result<(), StudioError> {
        let mut history = self.history.clone();
        history.push(entry);
        self.adopt(history, self.after.len())
    }

    /// Takes over a history whose entries before `first` are those there are, and carries the others out.
    pub(super) fn adopt(&mut self, history: History, first: usize) -> Result<(), StudioError> {
        let known = self.after.len().min(first);
        let mut shapes: Vec<Shape> = Vec::new();
        for entry in &history.entries()[known..] {
            let before = shapes.last().or(self.after[..known].last()).unwrap_or(&self.unedited);
            let shape = carried_out(&mut self.levels, self.density, before, entry)?;
            shapes.push(shape);
        }
        self.after.truncate(known);
        self.after.extend(shapes);
        self.history = history;
        self.settle_down();
        Ok(())
    }
}

/// The shape that `entry` makes of the one before it.
fn carried_out(levels: &mut [Level], density: u32, from: &Shape, entry: &Entry) -> Result<Shape, StudioError> {
    let mut shape = from.clone();
    match &entry.command {
        _ if entry.switch == Switch::Off => {}
        Command::Move { grip, .. } if grip.level > density => {}
        Command::Move { grip, offsets } => {
            let mut held = made_ready(levels, density, from, grip.clone())?;
            shape.displace(levels, from, &mut held, offsets, &mut Room::default())?;
        }
        &Command::Symmetrise { share } => shape.symmetrise(levels, share)?,
    }
    Ok(shape)
}
