use glam::DVec3;

use crate::level::Level;
use crate::prepared_edit::PreparedEdit;
use crate::{Expression, StudioError};

/// Positions of each level of a document up to the displayed one.
#[derive(Debug, Clone)]
pub(crate) struct LevelPositions {
    positions: Vec<Vec<DVec3>>,
}

/// Scratch buffers for carrying displacements from level to level, so that a tick does not allocate. Contents are
/// unspecified between calls.
#[derive(Clone, Default)]
pub(crate) struct Scratch {
    moved: Vec<Vec<DVec3>>,
    control: Vec<DVec3>,
}

impl LevelPositions {
    pub(crate) fn at_rest(levels: &[Level]) -> Self {
        Self { positions: levels.iter().map(|level| level.rest().to_vec()).collect() }
    }

    pub(crate) fn at(&self, level: u32) -> &[DVec3] {
        &self.positions[level as usize]
    }

    /// Memory size, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        self.positions.iter().map(|level| size_of_val(level.as_slice())).sum()
    }

    /// First vertex of the densest level whose position is not finite.
    pub(crate) fn not_finite(&self) -> Option<u32> {
        self.densest().iter().position(|position| !position.is_finite()).map(|vertex| vertex as u32)
    }

    pub(crate) fn densest(&self) -> &[DVec3] {
        self.positions.last().expect("invariant: there is a cage")
    }

    /// Sets the positions to `from` with the spec's handles moved, interpolated to the denser levels.
    pub(crate) fn displace(
        &mut self,
        levels: &[Level],
        from: &Self,
        edit: &mut PreparedEdit,
        offsets: &[DVec3],
        scratch: &mut Scratch,
    ) -> Result<(), StudioError> {
        let at = edit.spec().level as usize;
        edit.displace(&levels[at], &from.positions[at], offsets, &mut self.positions[at])?;
        for coarser in 0..at {
            self.positions[coarser].copy_from_slice(&from.positions[coarser]);
        }
        self.carry_over(levels, from, at, scratch);
        Ok(())
    }

    /// Moves the cage towards symmetry by `share` and interpolates the displacement to the denser levels.
    pub(crate) fn symmetrise(&mut self, levels: &[Level], share: f64) -> Result<(), StudioError> {
        if !(0.0..=1.0).contains(&share) {
            return Err(StudioError::Share { share });
        }
        let from = self.clone();
        levels[0].mirror()?.symmetrise_shape(share, &mut self.positions[0]);
        self.carry_over(levels, &from, 0, &mut Scratch::default());
        Ok(())
    }

    /// Adds `weight` times an expression to each level; its displacements must have been computed.
    pub(crate) fn express(&mut self, levels: &[Level], expression: Expression, weight: f64) {
        for (positions, level) in self.positions.iter_mut().zip(levels) {
            let displacements = level.expression_cache().displacements(expression).expect("invariant: computed before");
            positions
                .iter_mut()
                .zip(displacements)
                .for_each(|(position, displacement)| *position += weight * *displacement);
        }
    }

    /// Adds the displacement of level `at`, interpolated, to the denser levels.
    fn carry_over(&mut self, levels: &[Level], from: &Self, at: usize, scratch: &mut Scratch) {
        if at + 1 == self.positions.len() {
            return;
        }
        scratch.fit(&self.positions);
        for ((displacement, to), from) in scratch.moved[at].iter_mut().zip(&self.positions[at]).zip(&from.positions[at])
        {
            *displacement = *to - *from;
        }
        for finer in at + 1..self.positions.len() {
            let (coarse, fine) = scratch.moved.split_at_mut(finer);
            let (displacement, control) = (&coarse[finer - 1], &mut scratch.control);
            control.resize(displacement.len(), DVec3::ZERO);
            levels[finer - 1].finer().interpolate_to(displacement, control, &mut fine[0]);
            for ((to, from), displacement) in self.positions[finer].iter_mut().zip(&from.positions[finer]).zip(&fine[0])
            {
                *to = *from + *displacement;
            }
        }
    }
}

impl Scratch {
    /// Resizes the buffers to the levels.
    fn fit(&mut self, positions: &[Vec<DVec3>]) {
        self.moved.resize_with(positions.len(), Vec::new);
        self.moved.iter_mut().zip(positions).for_each(|(moved, level)| moved.resize(level.len(), DVec3::ZERO));
    }
}
