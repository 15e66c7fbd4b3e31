mod checks;
mod editing;
mod past;
mod points;
mod replay_cache;
mod retriangulate;
mod state;

use glam::DVec3;
use rosto_face::Parted;
use rosto_laplacian::{Geodesics, LaplacianError};
use rosto_mesh::{Topology, Value};

use crate::expressed;
use crate::fault::Fault;
use crate::level::{Level, Rest};
use crate::level_positions::LevelPositions;
use crate::prepared_edit::PreparedEdit;
use crate::{Entry, EntryStatus, Expression, History, InfluenceWeights, StudioError};
pub use checks::SMOOTH_DENSITY;
use editing::Preview;
use replay_cache::ReplayCache;
pub use state::DocumentState;

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
    replayed: ReplayCache,
    prepared: Option<PreparedEdit>,
    /// Of what is held.
    influence: Option<InfluenceWeights>,
    preview: Preview,
    fault: Fault,
}

impl Document {
    /// A document without edits.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] for positions that do not fit the mesh or are not finite.
    pub fn new(rest: Rest) -> Result<Self, StudioError> {
        let mut levels = vec![Level::new(rest)];
        levels[0].system(rosto_laplacian::Operator::default())?;
        let unedited = LevelPositions::at_rest(&levels);
        let preview = Preview::none(&unedited);
        let (history, replayed) = (History::default(), ReplayCache::new(unedited));
        let fault = Fault::default();
        Ok(Self { levels, density: 0, history, replayed, prepared: None, influence: None, preview, fault })
    }

    /// A document with these entries, as a project file holds them; see [`crate::project`]. Each can be taken back.
    ///
    /// # Errors
    /// As for [`Self::open`].
    pub fn replay(rest: Rest, entries: Vec<Entry>) -> Result<Self, StudioError> {
        Self::open(rest, entries, 0)
    }

    /// The same, subdivided so many times.
    ///
    /// # Errors
    /// [`StudioError::Entry`] for the first entry that cannot be carried out on this mesh or, where it is switched off or
    /// waits for a denser one, that names what such a mesh does not have. [`StudioError::TooDense`].
    pub fn open(rest: Rest, entries: Vec<Entry>, density: u32) -> Result<Self, StudioError> {
        let mut document = Self::new(rest)?;
        document.set_density(density)?;
        let refused = |(index, reason)| StudioError::Entry { index, reason: Box::new(reason) };
        for (index, entry) in entries.iter().enumerate() {
            document.check(entry).map_err(|reason| refused((index, reason)))?;
        }
        document.history = History::of_entries(entries);
        document.follow_history(0);
        let impossible = |index| match document.status(index) {
            Some(EntryStatus::Impossible(reason)) => Some((index, reason.clone())),
            _ => None,
        };
        match (0..document.replayed.count()).find_map(impossible) {
            Some(entry) => Err(refused(entry)),
            None => Ok(document),
        }
    }

    /// A document that goes on with the history of another, with all that was undone there. Entries that have no answer on
    /// this mesh are passed over.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] for positions that do not fit the mesh or are not finite.
    pub fn resume(rest: Rest, history: History) -> Result<Self, StudioError> {
        let mut document = Self::new(rest)?;
        document.history = history;
        document.follow_history(0);
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
        self.preview.positions().unwrap_or_else(|| self.committed())
    }

    /// Its positions after the last entry, without the edit in progress.
    pub fn committed(&self) -> &[DVec3] {
        self.replayed.last().densest()
    }

    /// Positions of the landmarks themselves after the last entry, however dense the mesh is that is shown.
    pub fn cage(&self) -> &[DVec3] {
        self.replayed.last().at(0)
    }

    /// From one vertex of the mesh that is shown to another, along its surface and after the last entry, by the heat method;
    /// between landmarks along the cage, which is no different and quicker.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] for vertices that are not there, or in a mesh that has no such distances.
    pub fn along_surface(&self, from: u32, to: u32) -> Result<f64, StudioError> {
        let missing = |vertex| LaplacianError::NoSuchVertex { vertex, vertex_count: self.topology().vertex_count() };
        let are_landmarks = (from.max(to) as usize) < self.cage().len();
        let geodesics = match are_landmarks {
            true => Geodesics::new(self.levels[0].topology(), self.cage()),
            false => Geodesics::new(self.topology(), self.committed()),
        };
        let distances = geodesics?.distances(&[from])?;
        Ok(*distances.get(to as usize).ok_or(missing(to))?)
    }

    /// How often the mesh that is shown was subdivided.
    pub fn density(&self) -> u32 {
        self.density
    }

    /// Shows the cage subdivided so many times (Loop), each time with four times as many triangles. Edits made on a denser
    /// mesh than this one wait until it is shown again. An edit in progress is cancelled, and the spec let go.
    ///
    /// # Errors
    /// [`StudioError::TooDense`] beyond [`MAX_DENSITY`](rosto_face::MAX_DENSITY); the document is as before.
    pub fn set_density(&mut self, density: u32) -> Result<(), StudioError> {
        self.fault.check()?;
        self.vertices_at(density)?;
        self.release();
        self.subdivide_to(density);
        self.density = density;
        let unedited = LevelPositions::at_rest(&self.levels[..=density as usize]);
        self.preview = Preview::none(&unedited);
        self.replayed = ReplayCache::new(unedited);
        self.follow_history(0);
        Ok(())
    }

    /// Values of the cage's vertices (texture coordinates, weights …) carried over to the mesh that is shown, as its positions
    /// are: the cage's vertices keep theirs, and between them they may go a little beyond.
    ///
    /// # Panics
    /// If there is not one value for each vertex of the cage.
    pub fn from_cage<T: Value>(&self, values: &[T]) -> Vec<T> {
        let steps = &self.levels[..self.density as usize];
        steps.iter().fold(values.to_vec(), |values, level| level.finer().interpolate(&values))
    }

    /// The positions that are shown, softer: between landmarks as they are, but rounded off at them as Loop's subdivision does,
    /// where the mesh that is shown passes through them. The cage itself has none softer.
    pub fn rounded(&self) -> Vec<DVec3> {
        let steps = &self.levels[..self.density as usize];
        let rounded_off = steps.iter().fold(self.cage().to_vec(), |cage, level| level.finer().apply(&cage));
        let through = self.from_cage(self.cage());
        let ways = rounded_off.into_iter().zip(through).map(|(rounded, through)| rounded - through);
        self.positions().iter().zip(ways).map(|(position, way)| *position + way).collect()
    }

    /// The mesh that is shown, parted at eyes and mouth as far as it fills them.
    pub fn parted(&self) -> Parted {
        Parted::new(self.levels[0].topology().triangles(), self.topology())
    }

    /// What each expression of weight 1 displaces the mesh that is shown by, in the order of [`Expression::ALL`].
    ///
    /// # Errors
    /// [`StudioError::NoExpressions`], or [`StudioError::Laplacian`] for a face that has no answer.
    pub fn expressions(&mut self) -> Result<Vec<Vec<DVec3>>, StudioError> {
        for expression in Expression::ALL {
            expressed::prepare(&mut self.levels, self.density, expression)?;
        }
        let ways = |expression| self.expressed(expression).to_vec();
        Ok(Expression::ALL.into_iter().map(ways).collect())
    }

    /// What an expression of weight 1 displaces the mesh that is shown by; nothing until one was made ready for it.
    pub(crate) fn expressed(&self, expression: Expression) -> &[DVec3] {
        self.level().expressed().ways(expression).unwrap_or_default()
    }

    fn level(&self) -> &Level {
        &self.levels[self.density as usize]
    }

    fn subdivide_to(&mut self, density: u32) {
        while self.levels.len() <= density as usize {
            let next = self.levels.last_mut().expect("invariant: there is a cage").subdivided();
            self.levels.push(next);
        }
    }
}
