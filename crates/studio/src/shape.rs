use glam::DVec3;

use crate::level::Level;
use crate::level_positions::{LevelPositions, Scratch};
use crate::prepared_edit::PreparedEdit;
use crate::{Expression, StudioError, expression_cache};

/// Largest displacement that stays finite on denser meshes.
const MAX_DISPLACEMENT: f64 = 1e300;

/// The shape after some entries of the history, as the displacements that the entries made. An entry changes one level
/// or one weight, so that a history is replayed without interpolating denser meshes.
#[derive(Debug, Clone)]
pub(crate) struct Shape {
    /// Sum of the displacements made at each level up to the displayed one; empty if no entry changed the level.
    made: Vec<Vec<DVec3>>,
    weights: [f64; Expression::ALL.len()],
}

impl Shape {
    /// The shape before any edit.
    pub(crate) fn at_rest(levels: &[Level]) -> Self {
        Self { made: vec![Vec::new(); levels.len()], weights: [0.0; Expression::ALL.len()] }
    }

    /// Memory size, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self) + self.made.iter().map(|made| size_of_val(made.as_slice())).sum::<usize>()
    }

    /// Displacement of a vertex of the cage, without expressions.
    pub(crate) fn made_m(&self, vertex: usize) -> DVec3 {
        self.made[0].get(vertex).copied().unwrap_or_default()
    }

    /// Replaces this shape by a copy; does not allocate if this one was like it.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.made.clone_from(&other.made);
        self.weights = other.weights;
    }

    /// Positions of the levels. The expressions' displacements must have been computed.
    pub(crate) fn positions(&self, levels: &[Level]) -> LevelPositions {
        let mut positions = LevelPositions::at_rest(&levels[..self.made.len()]);
        self.write_positions(levels, &mut positions, &mut Scratch::default());
        positions
    }

    /// Writes [`Self::positions`], without allocation after the first call.
    pub(crate) fn write_positions(&self, levels: &[Level], positions: &mut LevelPositions, scratch: &mut Scratch) {
        positions.set_displaced(levels, &self.made, scratch);
        for (expression, weight) in self.weights() {
            for (index, level) in levels[..self.made.len()].iter().enumerate() {
                let displacements = level.expression_cache().displacements(expression);
                positions.add(index, displacements.expect("invariant: computed before"), weight);
            }
        }
    }

    /// Positions of the levels up to `level`.
    pub(crate) fn positions_to(&self, levels: &[Level], level: u32) -> LevelPositions {
        Self { made: self.made[..=level as usize].to_vec(), weights: self.weights }.positions(levels)
    }

    /// Moves the edit's handles.
    pub(crate) fn displace(
        &mut self,
        levels: &[Level],
        edit: &mut PreparedEdit,
        offsets: &[DVec3],
        scratch: &mut Vec<DVec3>,
    ) -> Result<(), StudioError> {
        let at = edit.spec().level as usize;
        let from = edit.turns_details().then(|| self.positions_to(levels, edit.spec().level));
        let (level, made) = (&levels[at], &mut self.made[at]);
        made.resize(level.rest().len(), DVec3::ZERO);
        scratch.resize(made.len(), DVec3::ZERO);
        if let Some(from) = &from {
            let from = from.densest();
            edit.displace(level, from, offsets, scratch)?;
            for ((made, to), from) in made.iter_mut().zip(&*scratch).zip(from) {
                *made += *to - *from;
            }
        } else {
            edit.displace(level, made, offsets, scratch)?;
            made.copy_from_slice(scratch);
        }
        self.check(at)
    }

    /// Moves the cage towards symmetry by `share`.
    pub(crate) fn symmetrise(&mut self, levels: &[Level], share: f64) -> Result<(), StudioError> {
        if !(0.0..=1.0).contains(&share) {
            return Err(StudioError::Share { share });
        }
        let mirror = levels[0].mirror()?;
        let cage = self.positions_to(levels, 0);
        let (before, mut after) = (cage.densest(), cage.densest().to_vec());
        mirror.symmetrise_shape(share, &mut after);
        self.made[0].resize(before.len(), DVec3::ZERO);
        for ((made, to), from) in self.made[0].iter_mut().zip(&after).zip(before) {
            *made += *to - *from;
        }
        self.check(0)
    }

    /// Adds `weight` times an expression, and computes its displacements unless they are cached.
    pub(crate) fn express(
        &mut self,
        levels: &mut [Level],
        expression: Expression,
        weight: f64,
    ) -> Result<(), StudioError> {
        expression_cache::prepare(levels, self.made.len() as u32 - 1, expression)?;
        self.weights[expression as usize] += weight;
        Ok(())
    }

    fn weights(&self) -> impl Iterator<Item = (Expression, f64)> {
        Expression::ALL.into_iter().zip(self.weights).filter(|(_, weight)| *weight != 0.0)
    }

    fn check(&self, level: usize) -> Result<(), StudioError> {
        let is_bounded = |made: &DVec3| made.abs().cmple(DVec3::splat(MAX_DISPLACEMENT)).all();
        match self.made[level].iter().position(|made| !is_bounded(made)) {
            Some(vertex) => Err(rosto_laplacian::LaplacianError::NotFinite { vertex: vertex as u32 }.into()),
            None => Ok(()),
        }
    }
}
