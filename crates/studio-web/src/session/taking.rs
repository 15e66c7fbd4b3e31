use glam::DVec3;
use rosto_face::{LANDMARK_COUNT, Language, Region};
use rosto_studio::Subject;

use super::Session;
use crate::choices::Choices;
use crate::hand::{Hand, Selection};
use crate::names::landmark_label;
use crate::trouble::{Outcome, Trouble};

/// What is taken in hand where, and what it is called.
impl Session {
    /// How many vertices `hand` can take, from 0.
    pub fn within_reach(&self, hand: Hand) -> usize {
        match hand {
            Hand::Landmark | Hand::Region => LANDMARK_COUNT,
            Hand::Point => self.document.rest().len(),
        }
    }

    /// Refuses a vertex that is not there.
    pub fn known(&self, vertex: u32, hand: Hand) -> Outcome<u32> {
        let count = self.within_reach(hand);
        if (vertex as usize) < count { Ok(vertex) } else { Err(Trouble::bad_vertex(vertex, count)) }
    }

    /// What is taken in hand at a vertex that [`Self::known`] accepts. A region is the smallest around it or, if that is
    /// in hand already, the next larger one; where there is none, the landmark alone.
    pub fn at(&self, vertex: u32, hand: Hand) -> Selection {
        let around = match (hand, self.document.density()) {
            (Hand::Point, level @ 1..) => return Selection::Point { level, vertex },
            (Hand::Landmark | Hand::Point, _) => Vec::new(),
            (Hand::Region, _) => Region::containing(vertex),
        };
        let is_in_hand = |region: &Region| self.selection == Some(Selection::Region(*region));
        let next = around.iter().position(is_in_hand).map_or(0, |place| (place + 1) % around.len());
        around.get(next).map_or(Selection::Landmark(vertex), |&region| Selection::Region(region))
    }

    /// What is in hand, if a vertex is part of it, or what is taken there.
    pub fn at_or_held(&self, vertex: u32, hand: Hand) -> Selection {
        self.selection.filter(|_| self.holds(vertex)).unwrap_or_else(|| self.at(vertex, hand))
    }

    /// What is in hand, made what `hand` takes: the region around a landmark, the landmark in the middle of a region or
    /// beside a point, the point that a landmark is on the mesh that is shown.
    pub fn taken_by(&self, hand: Hand) -> Option<Selection> {
        let landmark = match (self.selection?, hand) {
            (as_it_is @ Selection::Landmark(_), Hand::Landmark)
            | (as_it_is @ Selection::Region(_), Hand::Region)
            | (as_it_is @ Selection::Point { .. }, Hand::Point) => return Some(as_it_is),
            (Selection::Point { vertex, .. }, _) => self.document.nearest_on(0, vertex)?,
            (other, _) => other.middle(),
        };
        Some(self.at(landmark, hand))
    }

    /// Whether a vertex is in hand, alone or with its region.
    pub fn holds(&self, vertex: u32) -> bool {
        self.selection.is_some_and(|selection| selection.handles().contains(&vertex))
    }

    /// Whether the other side can follow what is in hand.
    pub fn can_mirror(&self) -> bool {
        self.selection.is_none_or(|selection| self.document.partner(selection.level(), selection.middle()).is_some())
    }

    /// What the page calls a subject: landmarks bring their number along, points the place that they are near.
    pub fn label(&self, subject: Subject, language: Language) -> String {
        match subject {
            Subject::Landmark(landmark) => landmark_label(landmark, language),
            other => self.document.name_of(other, language),
        }
    }

    /// Gets ready what the first point in hand would have to wait for: the factors that all points share.
    pub fn prepare(&mut self, hand: Hand, choices: &Choices) -> Outcome<()> {
        let level = self.document.density();
        if hand != Hand::Point || level == 0 {
            return Ok(());
        }
        let any = Selection::Point { level, vertex: 0 };
        // One that cannot be held says so when it is taken in hand.
        let _ = self.document.hold(choices.grip(any, self.seed, &self.document));
        self.hold(choices)
    }

    /// Where on the mesh at rest what is in hand is.
    pub(super) fn selected_m(&self) -> Option<DVec3> {
        self.document.rest().get(self.selected()? as usize).copied()
    }

    /// The vertex shown that is nearest to a place at rest.
    pub(super) fn nearest(&self, place_m: DVec3) -> u32 {
        let distances = self.document.rest().iter().map(|rest| rest.distance_squared(place_m)).zip(0..);
        distances.min_by(|(one, _), (other, _)| one.total_cmp(other)).map_or(0, |(_, vertex)| vertex)
    }
}
