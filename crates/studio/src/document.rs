mod editing;
mod past;
mod points;
mod retriangulate;

use std::iter::Sum;
use std::ops::Mul;

use glam::DVec3;
use rosto_mesh::Topology;

use crate::grip::Held;
use crate::level::{Level, Rest};
use crate::shape::Shape;
use crate::{Entry, Follow, History, StudioError};
use editing::Preview;

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
        self.preview.positions().unwrap_or_else(|| self.committed())
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
        self.subdivide_to(density);
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

    fn level(&self) -> &Level {
        &self.levels[self.density as usize]
    }

    /// The shape that the next edit starts from.
    fn start(&self) -> &Shape {
        self.after.last().unwrap_or(&self.unedited)
    }

    fn subdivide_to(&mut self, density: u32) {
        while self.levels.len() <= density as usize {
            let next = self.levels.last_mut().expect("invariant: there is a cage").subdivided();
            self.levels.push(next);
        }
    }

    fn show(&mut self, density: u32) {
        self.density = density;
        self.unedited = Shape::at_rest(&self.levels[..=density as usize]);
        self.preview = Preview::none(&self.unedited);
    }
}
