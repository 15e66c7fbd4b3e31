mod checks;
mod editing;
mod limits;
mod past;
mod points;
mod replay_cache;
mod retriangulate;
mod solved;
mod state;

use std::sync::Arc;

use glam::DVec3;
use rosto_face::SplitFace;
use rosto_laplacian::{Geodesics, LaplacianError};
use rosto_mesh::{Topology, Value};

use crate::expression_cache;
use crate::fault::Fault;
use crate::level::{Level, Rest};
use crate::level_positions::LevelPositions;
use crate::prepared_edit::PreparedEdit;
use crate::shape::Shape;
use crate::{Entry, EntryStatus, Expression, History, InfluenceWeights, StudioError};
pub use checks::SMOOTH_DENSITY;
use editing::Preview;
pub use limits::{MAX_ENTRIES, MAX_LABEL_CHARS};
use replay_cache::ReplayCache;
pub use state::DocumentState;

/// A mesh at rest, the history of commands on it, and the edit in progress.
///
/// Each command starts from the result of the previous one, as in the paper. Operators and distances come from the mesh
/// at rest. The same rest and the same commands give bit-identical positions.
///
/// The mesh can be displayed more densely than its cage ([`Document::set_density`]). Each command works at one density
/// and is interpolated to the denser ones.
pub struct Document {
    /// The cage and the subdivisions built so far.
    levels: Vec<Level>,
    density: u32,
    history: History,
    replayed: ReplayCache,
    /// Positions after the last entry.
    committed: Arc<LevelPositions>,
    prepared: Option<PreparedEdit>,
    /// Influence of the prepared edit.
    influence: Option<InfluenceWeights>,
    preview: Preview,
    fault: Fault,
}

impl Document {
    /// Creates a document without edits.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] if the positions do not fit the mesh or are not finite.
    pub fn new(rest: Rest) -> Result<Self, StudioError> {
        let mut levels = vec![Level::new(rest)];
        levels[0].system(rosto_laplacian::Operator::default())?;
        let unedited = Shape::at_rest(&levels);
        let (preview, committed) = (Preview::none(&unedited, &levels), Arc::new(unedited.positions(&levels)));
        let (history, replayed) = (History::default(), ReplayCache::new(unedited));
        let (prepared, influence, fault) = (None, None, Fault::default());
        Ok(Self { levels, density: 0, history, replayed, committed, prepared, influence, preview, fault })
    }

    /// Creates a document from the entries of a project file; see [`crate::project`]. Each entry can be undone.
    ///
    /// # Errors
    /// See [`Self::open`].
    pub fn replay(rest: Rest, entries: Vec<Entry>) -> Result<Self, StudioError> {
        Self::open(rest, entries, 0)
    }

    /// Creates a document from the entries of a project file, subdivided `density` times.
    ///
    /// # Errors
    /// [`StudioError::Entry`] for the first entry that cannot be applied to this mesh. Entries that are off or wait for
    /// a denser mesh are only validated. [`StudioError::TooManyEntries`] or [`StudioError::TooMuchWork`] if the entries
    /// exceed a limit, and [`StudioError::TooDense`] if `density` is too high.
    pub fn open(rest: Rest, entries: Vec<Entry>, density: u32) -> Result<Self, StudioError> {
        let mut document = Self::new(rest)?;
        document.set_density(density)?;
        let refused = |(index, reason)| StudioError::Entry { index, reason: Box::new(reason) };
        for (index, entry) in entries.iter().enumerate() {
            document.check(entry).map_err(|reason| refused((index, reason)))?;
        }
        document.check_all(&entries)?;
        document.history = History::of_entries(entries);
        document.replay_from(0);
        let impossible = |index| match document.status(index) {
            Some(EntryStatus::Impossible(reason)) => Some((index, reason.clone())),
            _ => None,
        };
        match (0..document.replayed.count()).find_map(impossible) {
            Some(entry) => Err(refused(entry)),
            None => Ok(document),
        }
    }

    /// Creates a document that continues another document's history, including its undone changes. Entries that cannot
    /// be applied to this mesh are skipped.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] if the positions do not fit the mesh or are not finite.
    pub fn resume(rest: Rest, history: History) -> Result<Self, StudioError> {
        let mut document = Self::new(rest)?;
        document.history = history;
        document.replay_from(0);
        Ok(document)
    }

    /// The displayed mesh.
    pub fn topology(&self) -> &Topology {
        self.level().topology()
    }

    /// Positions of the displayed mesh before any edit.
    pub fn rest(&self) -> &[DVec3] {
        self.level().rest()
    }

    /// Positions of the displayed mesh, including the edit in progress.
    pub fn positions(&self) -> &[DVec3] {
        self.preview.positions().unwrap_or_else(|| self.committed())
    }

    /// Positions of the displayed mesh after the last entry, without the edit in progress.
    pub fn committed(&self) -> &[DVec3] {
        self.committed.densest()
    }

    /// Positions of the cage's vertices (the landmarks) after the last entry, at any density.
    pub fn cage(&self) -> &[DVec3] {
        self.committed.at(0)
    }

    /// Distance along the surface between two vertices of the displayed mesh, after the last entry, by the heat method.
    /// Between two landmarks it is measured on the cage, which is faster.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] if a vertex does not exist or the mesh has no geodesic distances.
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

    /// Subdivision level of the displayed mesh.
    pub fn density(&self) -> u32 {
        self.density
    }

    /// Displays the cage after `density` Loop subdivisions, each with four times as many triangles. Edits of denser
    /// meshes wait until their density is displayed again. Cancels an edit in progress and releases the prepared edit.
    ///
    /// # Errors
    /// [`StudioError::TooDense`] above [`MAX_DENSITY`](rosto_face::MAX_DENSITY); the document is unchanged.
    pub fn set_density(&mut self, density: u32) -> Result<(), StudioError> {
        self.fault.check()?;
        self.vertices_at(density)?;
        self.release();
        self.subdivide_to(density);
        self.density = density;
        let unedited = Shape::at_rest(&self.levels[..=density as usize]);
        self.preview = Preview::none(&unedited, &self.levels);
        self.replayed = ReplayCache::new(unedited);
        self.replay_from(0);
        Ok(())
    }

    /// Interpolates per-vertex values of the cage (texture coordinates, weights …) to the displayed mesh, as its
    /// positions are. The cage's vertices keep their values; between them the result can slightly overshoot.
    ///
    /// # Panics
    /// If `values` does not have one value for each vertex of the cage.
    pub fn from_cage<T: Value>(&self, values: &[T]) -> Vec<T> {
        let steps = &self.levels[..self.density as usize];
        steps.iter().fold(values.to_vec(), |values, level| level.finer().interpolate(&values))
    }

    /// Smoothed positions of the displayed mesh: rounded at the landmarks as by plain Loop subdivision, instead of
    /// passing through them. At density 0 they equal [`Self::positions`].
    pub fn rounded(&self) -> Vec<DVec3> {
        let steps = &self.levels[..self.density as usize];
        let rounded_off = steps.iter().fold(self.cage().to_vec(), |cage, level| level.finer().apply(&cage));
        let through = self.from_cage(self.cage());
        let displacements = rounded_off.into_iter().zip(through).map(|(rounded, through)| rounded - through);
        self.positions().iter().zip(displacements).map(|(position, displacement)| *position + displacement).collect()
    }

    /// The displayed mesh, split at the eyes and mouth if its triangles fill them.
    pub fn split_face(&self) -> SplitFace {
        SplitFace::new(self.levels[0].topology().triangles(), self.topology())
    }

    /// Displacement of each vertex of the displayed mesh by each expression at weight 1, in the order of
    /// [`Expression::ALL`].
    ///
    /// # Errors
    /// [`StudioError::NoExpressions`], or [`StudioError::Laplacian`] if the face has no solution.
    pub fn expressions(&mut self) -> Result<Vec<Vec<DVec3>>, StudioError> {
        for expression in Expression::ALL {
            expression_cache::prepare(&mut self.levels, self.density, expression)?;
        }
        let displacements = |expression| self.expression_displacements(expression).to_vec();
        Ok(Expression::ALL.into_iter().map(displacements).collect())
    }

    /// Displacement of the displayed mesh by an expression at weight 1; empty until it has been computed.
    pub(crate) fn expression_displacements(&self, expression: Expression) -> &[DVec3] {
        self.level().expression_cache().displacements(expression).unwrap_or_default()
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
