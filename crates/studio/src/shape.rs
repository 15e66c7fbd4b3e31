use glam::DVec3;

use crate::StudioError;
use crate::grip::Held;
use crate::level::Level;

/// The positions of every level of a document up to the one that is shown.
#[derive(Clone)]
pub(crate) struct Shape {
    positions: Vec<Vec<DVec3>>,
    /// Room for the way from one shape to the next; what it holds has no meaning between calls.
    moved: Vec<Vec<DVec3>>,
}

impl Shape {
    pub(crate) fn at_rest(levels: &[Level]) -> Self {
        let positions: Vec<Vec<DVec3>> = levels.iter().map(|level| level.rest().to_vec()).collect();
        Self { moved: positions.clone(), positions }
    }

    pub(crate) fn at(&self, level: u32) -> &[DVec3] {
        &self.positions[level as usize]
    }

    pub(crate) fn densest(&self) -> &[DVec3] {
        self.positions.last().expect("invariant: there is a cage")
    }

    /// Becomes `from` with the grip's handles moved, carried over to the denser levels.
    pub(crate) fn displace(
        &mut self,
        levels: &[Level],
        from: &Self,
        held: &mut Held,
        offsets: &[DVec3],
    ) -> Result<(), StudioError> {
        let at = held.grip().level as usize;
        held.displace(&levels[at], &from.positions[at], offsets, &mut self.positions[at])?;
        for coarser in 0..at {
            self.positions[coarser].copy_from_slice(&from.positions[coarser]);
        }
        self.carry_over(levels, from, at);
        Ok(())
    }

    /// Moves the cage by `share` of the way to where both sides are mirror images, carried over to the denser levels.
    pub(crate) fn symmetrise(&mut self, levels: &[Level], share: f64) -> Result<(), StudioError> {
        if !(0.0..=1.0).contains(&share) {
            return Err(StudioError::Share { share });
        }
        let from = self.clone();
        levels[0].mirror()?.symmetrise_shape(share, &mut self.positions[0]);
        self.carry_over(levels, &from, 0);
        Ok(())
    }

    /// Moves every level above `at` by what `at` was moved by.
    fn carry_over(&mut self, levels: &[Level], from: &Self, at: usize) {
        if at + 1 == self.positions.len() {
            return;
        }
        for ((way, to), from) in self.moved[at].iter_mut().zip(&self.positions[at]).zip(&from.positions[at]) {
            *way = *to - *from;
        }
        for finer in at + 1..self.positions.len() {
            let (coarse, fine) = self.moved.split_at_mut(finer);
            levels[finer - 1].finer().apply_to(&coarse[finer - 1], &mut fine[0]);
            for ((to, from), way) in self.positions[finer].iter_mut().zip(&from.positions[finer]).zip(&fine[0]) {
                *to = *from + *way;
            }
        }
    }
}
