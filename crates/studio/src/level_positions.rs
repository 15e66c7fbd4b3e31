use glam::DVec3;

use crate::level::Level;
use crate::prepared_edit::PreparedEdit;
use crate::{Expression, StudioError};

/// The positions of every level of a document up to the one that is shown.
#[derive(Debug, Clone)]
pub(crate) struct LevelPositions {
    positions: Vec<Vec<DVec3>>,
}

/// Room for the way from one shape to the next, so that a tick need not allocate; what it holds has no meaning between
/// calls.
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

    /// What it takes in memory.
    pub(crate) fn bytes(&self) -> usize {
        self.positions.iter().map(|level| size_of_val(level.as_slice())).sum()
    }

    /// The first vertex of the densest level that is nowhere.
    pub(crate) fn not_finite(&self) -> Option<u32> {
        self.densest().iter().position(|position| !position.is_finite()).map(|vertex| vertex as u32)
    }

    pub(crate) fn densest(&self) -> &[DVec3] {
        self.positions.last().expect("invariant: there is a cage")
    }

    /// Becomes `from` with the spec's handles moved, carried over to the denser levels.
    pub(crate) fn displace(
        &mut self,
        levels: &[Level],
        from: &Self,
        held: &mut PreparedEdit,
        offsets: &[DVec3],
        room: &mut Scratch,
    ) -> Result<(), StudioError> {
        let at = held.spec().level as usize;
        held.displace(&levels[at], &from.positions[at], offsets, &mut self.positions[at])?;
        for coarser in 0..at {
            self.positions[coarser].copy_from_slice(&from.positions[coarser]);
        }
        self.carry_over(levels, from, at, room);
        Ok(())
    }

    /// Moves the cage by `share` of the way to where both sides are mirror images, carried over to the denser levels.
    pub(crate) fn symmetrise(&mut self, levels: &[Level], share: f64) -> Result<(), StudioError> {
        if !(0.0..=1.0).contains(&share) {
            return Err(StudioError::Share { share });
        }
        let from = self.clone();
        levels[0].mirror()?.symmetrise_shape(share, &mut self.positions[0]);
        self.carry_over(levels, &from, 0, &mut Scratch::default());
        Ok(())
    }

    /// Adds so much of an expression to every level; it must have been made ready for them.
    pub(crate) fn express(&mut self, levels: &[Level], expression: Expression, weight: f64) {
        for (positions, level) in self.positions.iter_mut().zip(levels) {
            let ways = level.expressed().ways(expression).expect("invariant: made ready before");
            positions.iter_mut().zip(ways).for_each(|(position, way)| *position += weight * *way);
        }
    }

    /// Moves every level above `at` by what `at` was moved by.
    fn carry_over(&mut self, levels: &[Level], from: &Self, at: usize, room: &mut Scratch) {
        if at + 1 == self.positions.len() {
            return;
        }
        room.fit(&self.positions);
        for ((way, to), from) in room.moved[at].iter_mut().zip(&self.positions[at]).zip(&from.positions[at]) {
            *way = *to - *from;
        }
        for finer in at + 1..self.positions.len() {
            let (coarse, fine) = room.moved.split_at_mut(finer);
            let (way, control) = (&coarse[finer - 1], &mut room.control);
            control.resize(way.len(), DVec3::ZERO);
            levels[finer - 1].finer().interpolate_to(way, control, &mut fine[0]);
            for ((to, from), way) in self.positions[finer].iter_mut().zip(&from.positions[finer]).zip(&fine[0]) {
                *to = *from + *way;
            }
        }
    }
}

impl Scratch {
    /// Has a place for each position of each level.
    fn fit(&mut self, positions: &[Vec<DVec3>]) {
        self.moved.resize_with(positions.len(), Vec::new);
        self.moved.iter_mut().zip(positions).for_each(|(moved, level)| moved.resize(level.len(), DVec3::ZERO));
    }
}
