use std::sync::Arc;

use crate::EntryStatus;
use crate::shape::Shape;
use crate::slider_measures::{SliderAmounts, SliderMeasures};

/// Memory limit of the cached shapes, in bytes.
const BUDGET_BYTES: usize = 48 << 20;
/// Number of latest shapes that are retained, so that undo needs no solve.
const RETAINED_LATEST: usize = 8;

/// The shape after each entry of the history, and the status of each entry. Shapes are retained as far as memory
/// allows; others are recomputed from the nearest retained shape before them.
#[derive(Clone)]
pub(super) struct ReplayCache {
    unedited: Arc<Shape>,
    after: Vec<Option<Arc<Shape>>>,
    statuses: Vec<EntryStatus>,
    measures: SliderMeasures,
    /// Amount of each ready-made slider in the shape after each entry.
    amounts_m: Vec<SliderAmounts>,
    retained_bytes: usize,
    budget_bytes: usize,
}

impl ReplayCache {
    pub fn new(unedited: Shape) -> Self {
        Self {
            unedited: Arc::new(unedited),
            after: Vec::new(),
            statuses: Vec::new(),
            measures: SliderMeasures::default(),
            amounts_m: Vec::new(),
            retained_bytes: 0,
            budget_bytes: BUDGET_BYTES,
        }
    }

    pub fn count(&self) -> usize {
        self.after.len()
    }

    pub fn unedited(&self) -> &Arc<Shape> {
        &self.unedited
    }

    /// The shape after the last entry; it is always retained.
    pub fn last(&self) -> &Arc<Shape> {
        self.after.last().and_then(Option::as_ref).unwrap_or(&self.unedited)
    }

    pub fn status(&self, index: usize) -> Option<&EntryStatus> {
        self.statuses.get(index)
    }

    /// Amount of each ready-made slider in the shape after an entry.
    pub fn amounts_m(&self, index: usize) -> Option<&SliderAmounts> {
        self.amounts_m.get(index)
    }

    pub fn measures(&self) -> &SliderMeasures {
        &self.measures
    }

    pub fn push(&mut self, shape: Arc<Shape>, status: EntryStatus) {
        self.amounts_m.push(self.measures.of(|landmark| shape.made_m(landmark)));
        // Shared shapes count once: an entry that changes nothing shares the shape before it.
        self.retained_bytes += if Arc::ptr_eq(&shape, self.last()) { 0 } else { shape.bytes() };
        self.after.push(Some(shape));
        self.statuses.push(status);
        self.thin_out();
    }

    /// Discards the shapes after the first `count` entries, and then more until the last shape is a retained one.
    pub fn truncate(&mut self, count: usize) {
        let last_retained = self.after[..count.min(self.after.len())].iter().rposition(Option::is_some);
        let count = last_retained.map_or(0, |index| index + 1);
        self.after.truncate(count);
        self.statuses.truncate(count);
        self.amounts_m.truncate(count);
        self.retained_bytes = self.count_bytes();
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

    /// Drops every second older shape until the rest fits the budget, so that older shapes are farther apart.
    fn thin_out(&mut self) {
        while self.after.len() > RETAINED_LATEST && self.retained_bytes > self.budget_bytes {
            let older = self.after.len() - RETAINED_LATEST;
            let retained: Vec<usize> = (0..older).filter(|index| self.after[*index].is_some()).collect();
            if retained.is_empty() {
                return;
            }
            retained.into_iter().step_by(2).for_each(|index| self.after[index] = None);
            self.retained_bytes = self.count_bytes();
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
    fn memory_stays_within_budget_and_the_latest_shapes_are_retained() {
        let rest =
            Rest::of_landmarks(Triangulation::Canonical.topology(), canonical_positions_m(), CoordinateFrame::Model);
        let shape = Shape::at_rest(&[Level::new(rest)]);
        let mut shapes = ReplayCache::new(shape.clone());
        shapes.budget_bytes = 20 * shape.bytes();
        for _ in 0..1000 {
            shapes.push(Arc::new(shape.clone()), EntryStatus::InForce);
        }
        assert!(shapes.retained_bytes <= 20 * shape.bytes());
        assert!(shapes.after[1000 - RETAINED_LATEST..].iter().all(Option::is_some));
        assert_eq!(shapes.count(), 1000);
        shapes.truncate(900);
        assert!(shapes.count() <= 900 && (shapes.count() == 0 || shapes.after[shapes.count() - 1].is_some()));
    }
}
