use glam::DVec3;

use crate::level::Level;

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

    pub(crate) fn densest(&self) -> &[DVec3] {
        self.positions.last().expect("invariant: there is a cage")
    }

    /// Sets each level to its positions at rest, displaced by `made` at each level (empty for none) and by what the
    /// coarser levels carry over.
    pub(crate) fn set_displaced(&mut self, levels: &[Level], made: &[Vec<DVec3>], scratch: &mut Scratch) {
        let coarsest = made.iter().position(|made| !made.is_empty()).unwrap_or(self.positions.len());
        scratch.moved.resize_with(self.positions.len(), Vec::new);
        for (index, (positions, level)) in self.positions.iter_mut().zip(levels).enumerate() {
            positions.copy_from_slice(level.rest());
            if index < coarsest {
                continue;
            }
            let (coarser, finer) = scratch.moved.split_at_mut(index);
            let moved = &mut finer[0];
            moved.clear();
            moved.resize(positions.len(), DVec3::ZERO);
            if index > coarsest {
                let (displacements, control) = (&coarser[index - 1], &mut scratch.control);
                control.resize(displacements.len(), DVec3::ZERO);
                levels[index - 1].finer().interpolate_to(displacements, control, moved);
            }
            moved.iter_mut().zip(&made[index]).for_each(|(moved, made)| *moved += *made);
            positions.iter_mut().zip(moved).for_each(|(position, moved)| *position += *moved);
        }
    }

    /// Adds `weight` times displacements to a level.
    pub(crate) fn add(&mut self, level: usize, displacements: &[DVec3], weight: f64) {
        let moved = self.positions[level].iter_mut().zip(displacements);
        moved.for_each(|(position, displacement)| *position += weight * *displacement);
    }
}
