use std::iter::Sum;
use std::ops::Mul;

use glam::DVec3;
use rosto_laplacian::Response;
use rosto_mesh::Topology;

use crate::grip::Held;
use crate::level::{Level, Rest};
use crate::shape::{Room, Shape};
use crate::{Command, Details, Entry, Follow, Grip, History, StudioError, Subject, Switch};

/// A mesh at rest, the history of commands over it, and the edit in progress.
///
/// Every command starts from the mesh that the last one left, as in the paper. Operators and distances are taken over the
/// mesh at rest. The same rest and the same commands give the same positions, to the last bit.
///
/// The mesh can be shown more densely than the cage it starts from ([`Document::set_density`]); each command works on one
/// density and is carried over to the denser ones.
pub struct Document {
    /// The cage and its subdivisions as far as they were ever shown.
    levels: Vec<Level>,
    density: u32,
    history: History,
    /// The shape after each entry; what history alone would give, kept so that undo need not solve.
    after: Vec<Shape>,
    unedited: Shape,
    held: Option<Held>,
    /// Of what is held.
    follow: Option<Follow>,
    preview: Preview,
}

/// The grip's offsets and the positions they lead to, while vertices are being moved.
struct Preview {
    offsets: Vec<DVec3>,
    /// Of the mesh that is shown.
    positions: Vec<DVec3>,
    shape: Shape,
    room: Room,
    under_way: bool,
}

impl Preview {
    fn none(unedited: &Shape) -> Self {
        let (shape, positions) = (unedited.clone(), unedited.densest().to_vec());
        Self { offsets: Vec::new(), positions, shape, room: Room::default(), under_way: false }
    }
}

impl Document {
    /// A document without edits.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] for positions that do not fit the mesh or are not finite.
    pub fn new(rest: Rest) -> Result<Self, StudioError> {
        let mut levels = vec![Level::new(rest)];
        levels[0].system(rosto_laplacian::Operator::default())?;
        let unedited = Shape::at_rest(&levels);
        let preview = Preview::none(&unedited);
        let (history, after) = (History::default(), Vec::new());
        Ok(Self { levels, density: 0, history, after, unedited, held: None, follow: None, preview })
    }

    /// A document with these entries, as a project file holds them; see [`crate::project`].
    ///
    /// # Errors
    /// For the first entry that cannot be carried out on this mesh.
    pub fn replay(rest: Rest, entries: Vec<Entry>) -> Result<Self, StudioError> {
        let mut document = Self::new(rest)?;
        for entry in entries {
            document.push(entry)?;
        }
        Ok(document)
    }

    /// A document that goes on with the history of another, with all that was undone there.
    ///
    /// # Errors
    /// For the first entry that cannot be carried out on this mesh.
    pub fn resume(rest: Rest, history: History) -> Result<Self, StudioError> {
        let mut document = Self::new(rest)?;
        document.adopt(history, 0)?;
        Ok(document)
    }

    /// The mesh that is shown.
    pub fn topology(&self) -> &Topology {
        self.level().topology()
    }

    /// Its positions before any edit.
    pub fn rest(&self) -> &[DVec3] {
        self.level().rest()
    }

    /// Its positions now, with the edit in progress.
    pub fn positions(&self) -> &[DVec3] {
        if self.preview.under_way { &self.preview.positions } else { self.committed() }
    }

    /// Its positions after the last entry, without the edit in progress.
    pub fn committed(&self) -> &[DVec3] {
        self.start().densest()
    }

    /// How often the mesh that is shown was subdivided.
    pub fn density(&self) -> u32 {
        self.density
    }

    /// Shows the cage subdivided so many times (Loop), each time with four times as many triangles. Edits made on a denser
    /// mesh than this one wait until it is shown again. An edit in progress is cancelled, and the grip let go.
    ///
    /// # Errors
    /// [`StudioError`] if an entry cannot be carried out at this density; the document is as before.
    pub fn set_density(&mut self, density: u32) -> Result<(), StudioError> {
        self.release();
        while self.levels.len() <= density as usize {
            let next = self.levels.last_mut().expect("invariant: there is a cage").subdivided();
            self.levels.push(next);
        }
        let before = (self.density, std::mem::take(&mut self.after));
        self.show(density);
        let outcome = self.adopt(self.history.clone(), 0);
        if outcome.is_err() {
            self.show(before.0);
            self.after = before.1;
        }
        outcome
    }

    /// Values of the cage's vertices (texture coordinates, weights …) carried over to the mesh that is shown.
    ///
    /// # Panics
    /// If there is not one value for each vertex of the cage.
    pub fn from_cage<T: Copy + Mul<f64, Output = T> + Sum>(&self, values: &[T]) -> Vec<T> {
        let steps = &self.levels[..self.density as usize];
        steps.iter().fold(values.to_vec(), |values, level| level.finer().apply(&values))
    }

    /// What each entry displaced the mesh that is shown by; they add up to the way from [`Self::rest`] to
    /// [`Self::committed`].
    pub fn displacements(&self) -> Vec<Vec<DVec3>> {
        let starts = std::iter::once(&self.unedited).chain(&self.after);
        let way =
            |(from, to): (&Shape, &Shape)| to.densest().iter().zip(from.densest()).map(|(to, at)| *to - *at).collect();
        starts.zip(&self.after).map(way).collect()
    }

    /// The history.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Takes hold of vertices: one solve. An edit in progress is cancelled; the grip stays over commits, so that the
    /// same vertices can be moved again without another solve.
    ///
    /// # Errors
    /// [`StudioError`] if the grip has no answer; what was held stays held.
    pub fn hold(&mut self, grip: Grip) -> Result<(), StudioError> {
        if self.held.as_ref().is_none_or(|held| *held.grip() != grip) {
            self.held = Some(self.made_ready(grip)?);
            self.follow = self.followed()?;
        }
        self.cancel();
        Ok(())
    }

    /// Lets go; an edit in progress is cancelled.
    pub fn release(&mut self) {
        self.cancel();
        self.held = None;
        self.follow = None;
    }

    /// The grip that is held.
    pub fn grip(&self) -> Option<&Grip> {
        self.held.as_ref().map(Held::grip)
    }

    /// All vertices that move by their own offset: the grip's handles, then the partners that the mirror adds.
    pub fn handles(&self) -> &[u32] {
        self.held.as_ref().map_or(&[], Held::handles)
    }

    /// The vertices that the grip keeps in place.
    pub fn anchors(&self) -> &[u32] {
        self.held.as_ref().map_or(&[], Held::anchors)
    }

    /// How every vertex of the grip's level follows each of [`Self::handles`], if details keep their direction.
    pub fn response(&self) -> Option<&Response> {
        self.held.as_ref().map(Held::response)
    }

    /// How every vertex shown follows the grip's handles when they move by one offset and details keep their direction.
    /// Where details turn, the first guess that they start from.
    pub fn follow(&self) -> Option<&Follow> {
        self.follow.as_ref()
    }

    /// Moves what is held by one offset for each of the grip's handles, counted from the last commit, in the document's
    /// unit. Unless details turn: no solve and, after the first call, no allocation.
    ///
    /// # Errors
    /// [`StudioError::NothingHeld`], [`StudioError::WrongOffsetCount`] or [`StudioError::OffsetNotFinite`].
    pub fn preview(&mut self, offsets: &[DVec3]) -> Result<(), StudioError> {
        let held = self.held.as_ref().ok_or(StudioError::NothingHeld)?;
        if held.is_stale() {
            self.held = Some(self.made_ready(held.grip().clone())?);
        }
        let held = self.held.as_mut().ok_or(StudioError::NothingHeld)?;
        let (from, preview) = (self.after.last().unwrap_or(&self.unedited), &mut self.preview);
        held.check(offsets)?;
        if let Some(follow) = carried(&self.follow, held, offsets, self.density) {
            follow.displace(from.densest(), offsets[0], &mut preview.positions);
        } else {
            preview.shape.displace(&self.levels, from, held, offsets, &mut preview.room)?;
            preview.positions.copy_from_slice(preview.shape.densest());
        }
        self.preview.offsets.clear();
        self.preview.offsets.extend_from_slice(offsets);
        self.preview.under_way = true;
        Ok(())
    }

    /// Makes the edit in progress one entry of the history; what was undone is forgotten. Without an edit in progress,
    /// nothing happens.
    pub fn commit(&mut self, label: &str) {
        if let (true, Some(held)) = (self.preview.under_way, &mut self.held) {
            let (from, preview) = (self.after.last().unwrap_or(&self.unedited), &mut self.preview);
            if carried(&self.follow, held, &preview.offsets, self.density).is_some() {
                let moved = preview.shape.displace(&self.levels, from, held, &preview.offsets, &mut preview.room);
                moved.expect("invariant: the preview has checked these offsets");
            }
            let command = held.command(self.preview.offsets.clone());
            self.history.push(Entry { label: label.to_owned(), command, switch: Switch::On });
            self.after.push(self.preview.shape.clone());
        }
        self.settle_down();
    }

    /// Drops the edit in progress; the grip stays.
    pub fn cancel(&mut self) {
        self.preview.under_way = false;
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

    fn level(&self) -> &Level {
        &self.levels[self.density as usize]
    }

    /// The shape that the next edit starts from.
    fn start(&self) -> &Shape {
        self.after.last().unwrap_or(&self.unedited)
    }

    fn show(&mut self, density: u32) {
        self.density = density;
        self.unedited = Shape::at_rest(&self.levels[..=density as usize]);
        self.preview = Preview::none(&self.unedited);
    }

    fn push(&mut self, entry: Entry) -> Result<(), StudioError> {
        let mut history = self.history.clone();
        history.push(entry);
        self.adopt(history, self.after.len())
    }

    /// Takes over a history whose entries before `first` are those there are, and carries the others out.
    fn adopt(&mut self, history: History, first: usize) -> Result<(), StudioError> {
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

    /// Ends the edit in progress after the start of the next one has changed.
    fn settle_down(&mut self) {
        self.cancel();
        if let Some(held) = &mut self.held {
            held.start_changed();
        }
    }

    fn made_ready(&mut self, grip: Grip) -> Result<Held, StudioError> {
        let from = self.after.last().unwrap_or(&self.unedited);
        made_ready(&mut self.levels, self.density, from, grip)
    }

    /// What [`Self::follow`] says of the grip that is held now.
    fn followed(&mut self) -> Result<Option<Follow>, StudioError> {
        let Some(held) = &mut self.held else { return Ok(None) };
        let from = self.after.last().unwrap_or(&self.unedited);
        let mut kept = None;
        if held.grip().settings.details == Details::Turned {
            let mut grip = held.grip().clone();
            grip.settings.details = Details::Kept;
            kept = Some(made_ready(&mut self.levels, self.density, from, grip)?);
        }
        let (held, shape) = (kept.as_mut().unwrap_or(held), &mut self.preview.shape);
        let handles = held.grip().handles.len();
        let mut along = |axis: DVec3| {
            shape.displace(&self.levels, from, held, &vec![axis; handles], &mut self.preview.room)?;
            Ok::<_, StudioError>(shape.densest().iter().zip(from.densest()).map(|(to, at)| *to - *at).collect())
        };
        let (along_x, along_y): (Vec<DVec3>, Vec<DVec3>) = (along(DVec3::X)?, along(DVec3::Y)?);
        Ok(Some(Follow::from_displacements(&along_x, &along_y)))
    }
}

fn made_ready(levels: &mut [Level], density: u32, from: &Shape, grip: Grip) -> Result<Held, StudioError> {
    let level = grip.level;
    if level > density {
        return Err(StudioError::TooCoarse { level, density });
    }
    Held::new(grip, &mut levels[level as usize], from.at(level))
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

/// The short way from a grip to a denser mesh that is shown: what each tick would else carry over, level by level. Equal
/// to it but for rounding, so that a commit takes the long way, as a replay does.
fn carried<'a>(follow: &'a Option<Follow>, held: &Held, offsets: &[DVec3], density: u32) -> Option<&'a Follow> {
    let as_one = offsets.iter().all(|offset| *offset == offsets[0]);
    let Grip { level, settings, .. } = held.grip();
    follow.as_ref().filter(|_| as_one && *level < density && settings.details == Details::Kept)
}
