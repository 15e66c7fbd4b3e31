use glam::DVec3;
use rosto_face::{FaceModel, LANDMARK_COUNT, oval};
use rosto_laplacian::Response;
use rosto_mesh::Topology;

use crate::grip::Held;
use crate::mirror::MirrorTable;
use crate::systems::Systems;
use crate::{Command, Entry, Grip, History, StudioError, Switch};

/// Which coordinates a document's positions are in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frame {
    /// The face model's: its mirror plane is x = 0.
    Model,
    /// Any other, such as a picture's: there is no mirror plane.
    Other,
}

/// The mesh that a document starts from.
#[derive(Debug, Clone)]
pub struct Rest {
    pub(crate) topology: Topology,
    pub(crate) positions: Vec<DVec3>,
    pub(crate) oval: Vec<u32>,
    pub(crate) mirror: Option<MirrorTable>,
}

impl Rest {
    /// A mesh at rest, in any unit. In the model's frame, a mesh of landmarks has their mirror pairs.
    pub fn new(topology: Topology, positions: Vec<DVec3>, frame: Frame) -> Self {
        let is_face = topology.vertex_count() == LANDMARK_COUNT;
        let oval = match is_face {
            true => oval().to_vec(),
            false => topology.boundary_loops().into_iter().next().unwrap_or_default(),
        };
        let mirror = (is_face && frame == Frame::Model).then(MirrorTable::of_landmarks);
        Self { topology, positions, oval, mirror }
    }

    /// A face in its own frame, in metres.
    pub fn of_face(face: &FaceModel) -> Self {
        Self::new(face.topology().clone(), face.positions_m().to_vec(), Frame::Model)
    }
}

/// A mesh at rest, the history of commands over it, and the edit in progress.
///
/// Every command starts from the mesh that the last one left, as in the paper. Operators are taken over the mesh at
/// rest. The same rest and the same commands give the same positions, to the last bit.
pub struct Document {
    rest: Rest,
    systems: Systems,
    history: History,
    /// The positions after each applied entry; what history alone would give, kept so that undo need not solve.
    after: Vec<Vec<DVec3>>,
    held: Option<Held>,
    /// The grip's offsets and the positions they lead to, while vertices are being moved.
    preview: Preview,
}

#[derive(Default)]
struct Preview {
    offsets: Vec<DVec3>,
    positions: Vec<DVec3>,
    under_way: bool,
}

impl Document {
    /// A document without edits.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] for positions that do not fit the mesh or are not finite.
    pub fn new(rest: Rest) -> Result<Self, StudioError> {
        let mut systems = Systems::default();
        systems.get(rosto_laplacian::Operator::default(), &rest.topology, &rest.positions)?;
        let preview = Preview { positions: rest.positions.clone(), ..Preview::default() };
        Ok(Self { rest, systems, history: History::default(), after: Vec::new(), held: None, preview })
    }

    /// A document with a history, as a project file holds it; see [`crate::project`].
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

    /// The mesh.
    pub fn topology(&self) -> &Topology {
        &self.rest.topology
    }

    /// The positions before any edit.
    pub fn rest(&self) -> &[DVec3] {
        &self.rest.positions
    }

    /// The positions now, with the edit in progress.
    pub fn positions(&self) -> &[DVec3] {
        if self.preview.under_way { &self.preview.positions } else { self.committed() }
    }

    /// The positions after the last entry, without the edit in progress.
    pub fn committed(&self) -> &[DVec3] {
        self.after.last().unwrap_or(&self.rest.positions)
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
            self.held = Some(Held::new(grip, &self.rest, &mut self.systems)?);
        }
        self.cancel();
        Ok(())
    }

    /// Lets go; an edit in progress is cancelled.
    pub fn release(&mut self) {
        self.cancel();
        self.held = None;
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

    /// How every vertex follows each of [`Self::handles`].
    pub fn response(&self) -> Option<&Response> {
        self.held.as_ref().map(Held::response)
    }

    /// Moves what is held by one offset for each of the grip's handles, counted from the last commit, in the document's
    /// unit. No solve and, after the first call, no allocation.
    ///
    /// # Errors
    /// [`StudioError::NothingHeld`], [`StudioError::WrongOffsetCount`] or [`StudioError::OffsetNotFinite`].
    pub fn preview(&mut self, offsets: &[DVec3]) -> Result<(), StudioError> {
        let held = self.held.as_mut().ok_or(StudioError::NothingHeld)?;
        let from = self.after.last().unwrap_or(&self.rest.positions);
        held.displace(&self.rest, from, offsets, &mut self.preview.positions)?;
        self.preview.offsets.clear();
        self.preview.offsets.extend_from_slice(offsets);
        self.preview.under_way = true;
        Ok(())
    }

    /// Makes the edit in progress one entry of the history; what was undone is forgotten. Without an edit in progress,
    /// nothing happens.
    pub fn commit(&mut self, label: &str) {
        if let (true, Some(held)) = (self.preview.under_way, &self.held) {
            let command = held.command(self.preview.offsets.clone());
            self.record(Entry { label: label.to_owned(), command, switch: Switch::On }, self.preview.positions.clone());
        }
        self.cancel();
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

    /// Takes the last entry back. Without one, nothing happens.
    pub fn undo(&mut self) {
        self.cancel();
        if self.history.can_undo() {
            self.history.undo();
            self.after.pop();
        }
    }

    /// Brings the last undone entry back. Without one, nothing happens.
    ///
    /// # Errors
    /// None for entries that this document has carried out before.
    pub fn redo(&mut self) -> Result<(), StudioError> {
        self.cancel();
        if let Some(entry) = self.history.entries().get(self.after.len()).cloned() {
            let positions = self.carried_out(&entry)?;
            self.after.push(positions);
            self.history.redo();
        }
        Ok(())
    }

    /// Takes all entries back; [`Self::redo`] brings them again, one by one.
    pub fn reset(&mut self) {
        self.cancel();
        self.after.clear();
        self.history.undo_all();
    }

    /// Switches an applied entry on or off; those after it are carried out again.
    ///
    /// # Errors
    /// [`StudioError::NoSuchEntry`] if fewer entries are applied.
    pub fn switch(&mut self, index: usize, switch: Switch) -> Result<(), StudioError> {
        self.cancel();
        let count = self.after.len();
        if index >= count {
            return Err(StudioError::NoSuchEntry { index, count });
        }
        self.history.set_switch(index, switch);
        self.after.truncate(index);
        for later in index..count {
            let entry = self.history.entries()[later].clone();
            let positions = self.carried_out(&entry)?;
            self.after.push(positions);
        }
        Ok(())
    }

    fn push(&mut self, entry: Entry) -> Result<(), StudioError> {
        let positions = self.carried_out(&entry)?;
        self.record(entry, positions);
        self.cancel();
        Ok(())
    }

    fn record(&mut self, entry: Entry, positions: Vec<DVec3>) {
        self.history.push(entry);
        self.after.push(positions);
    }

    /// The positions after `entry`, from those after the entry before it.
    fn carried_out(&mut self, entry: &Entry) -> Result<Vec<DVec3>, StudioError> {
        let mut positions = self.committed().to_vec();
        if entry.switch == Switch::Off {
            return Ok(positions);
        }
        match &entry.command {
            Command::Move { grip, offsets } => {
                let mut held = Held::new(grip.clone(), &self.rest, &mut self.systems)?;
                held.displace(&self.rest, self.committed(), offsets, &mut positions)?;
            }
            &Command::Symmetrise { share } => {
                if !(0.0..=1.0).contains(&share) {
                    return Err(StudioError::Share { share });
                }
                self.rest.mirror.as_ref().ok_or(StudioError::NoMirror)?.symmetrise_shape(share, &mut positions);
            }
        }
        Ok(positions)
    }
}
