use std::sync::Arc;

use crate::EntryStatus;
use crate::level_positions::LevelPositions;

/// What the kept shapes may take together, in bytes.
const BUDGET_BYTES: usize = 48 << 20;
/// So many shapes from the end backwards stay, so that undo need not solve.
const LATEST: usize = 8;

/// The shape after each entry of the history, and how each entry stands. What history alone would give: shapes are kept as
/// far as memory allows, and the others are carried out again from the nearest one before.
#[derive(Clone)]
pub(super) struct ReplayCache {
    unedited: Arc<LevelPositions>,
    after: Vec<Option<Arc<LevelPositions>>>,
    statuses: Vec<EntryStatus>,
    kept_bytes: usize,
    budget_bytes: usize,
}

impl ReplayCache {
    pub fn new(unedited: LevelPositions) -> Self {
        let (after, statuses) = (Vec::new(), Vec::new());
        Self { unedited: Arc::new(unedited), after, statuses, kept_bytes: 0, budget_bytes: BUDGET_BYTES }
    }

    pub fn count(&self) -> usize {
        self.after.len()
    }

    pub fn unedited(&self) -> &Arc<LevelPositions> {
        &self.unedited
    }

    /// The shape after the last entry: always kept.
    pub fn last(&self) -> &Arc<LevelPositions> {
        self.after.last().and_then(Option::as_ref).unwrap_or(&self.unedited)
    }

    pub fn status(&self, index: usize) -> Option<&EntryStatus> {
        self.statuses.get(index)
    }

    pub fn push(&mut self, shape: Arc<LevelPositions>, status: EntryStatus) {
        // Shapes that entries share count once: one that changes nothing shares that of the one before.
        self.kept_bytes += if Arc::ptr_eq(&shape, self.last()) { 0 } else { shape.bytes() };
        self.after.push(Some(shape));
        self.statuses.push(status);
        self.thin_out();
    }

    /// Forgets the shapes after the first `count` entries, and as many before as are needed for the last one to be a kept
    /// one.
    pub fn truncate(&mut self, count: usize) {
        let known = self.after[..count.min(self.after.len())].iter().rposition(Option::is_some);
        let count = known.map_or(0, |place| place + 1);
        self.after.truncate(count);
        self.statuses.truncate(count);
        self.kept_bytes = self.count_bytes();
    }

    fn count_bytes(&self) -> usize {
        let mut before = &self.unedited;
        let mut bytes = 0;
        for shape in self.after.iter().flatten() {
            bytes += if Arc::ptr_eq(shape, before) { 0 } else { shape.bytes() };
            before = shape;
        }
        bytes
    }

    /// Drops every other shape but the latest, as often as memory asks for it: the older, the wider apart.
    fn thin_out(&mut self) {
        while self.after.len() > LATEST && self.kept_bytes > self.budget_bytes {
            let older = self.after.len() - LATEST;
            let kept: Vec<usize> = (0..older).filter(|place| self.after[*place].is_some()).collect();
            if kept.is_empty() {
                return;
            }
            kept.into_iter().step_by(2).for_each(|place| self.after[place] = None);
            self.kept_bytes = self.count_bytes();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::level::{Level, Rest};
    use crate::{CoordinateFrame, EntryStatus};
    use rosto_face::{Triangulation, canonical_positions_m};

    #[test]
    fn memory_stays_within_its_budget_and_the_latest_shapes_stay() {
        let rest = Rest::new(Triangulation::Canonical.topology(), canonical_positions_m(), CoordinateFrame::Model);
        let shape = LevelPositions::at_rest(&[Level::new(rest)]);
        let mut shapes = ReplayCache::new(shape.clone());
        shapes.budget_bytes = 20 * shape.bytes();
        for _ in 0..1000 {
            shapes.push(Arc::new(shape.clone()), EntryStatus::InForce);
        }
        assert!(shapes.kept_bytes <= 20 * shape.bytes());
        assert!(shapes.after[1000 - LATEST..].iter().all(Option::is_some));
        assert_eq!(shapes.count(), 1000);
        shapes.truncate(900);
        assert!(shapes.count() <= 900 && (shapes.count() == 0 || shapes.after[shapes.count() - 1].is_some()));
    }
}
