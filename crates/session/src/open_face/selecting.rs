use glam::DVec3;
use rosto_face::{LANDMARK_COUNT, Region};
use rosto_mesh::{Ray, Surface};

use super::OpenFace;
use crate::error::SessionError;
use crate::{Selection, SelectionMode};

/// What is selected where, and what it is called.
impl OpenFace {
    /// How many vertices `mode` can select, from 0.
    pub fn within_reach(&self, mode: SelectionMode) -> usize {
        match mode {
            SelectionMode::Landmark | SelectionMode::Region => LANDMARK_COUNT,
            SelectionMode::Point => self.document().rest().len(),
        }
    }

    /// Refuses a vertex that is not there.
    pub(crate) fn known(&self, vertex: u32, mode: SelectionMode) -> Result<u32, SessionError> {
        let count = self.within_reach(mode);
        if (vertex as usize) < count { Ok(vertex) } else { Err(SessionError::NoSuchVertex { vertex, count }) }
    }

    /// What is selected at a vertex that [`Self::known`] accepts. A region is the smallest around it or, if that is
    /// selected already, the next larger one; where there is none, the landmark alone.
    pub(crate) fn at(&self, vertex: u32, mode: SelectionMode) -> Selection {
        let around = match (mode, self.document().density()) {
            (SelectionMode::Point, level @ 1..) => return Selection::Point { level, vertex },
            (SelectionMode::Landmark | SelectionMode::Point, _) => Vec::new(),
            (SelectionMode::Region, _) => Region::containing(vertex),
        };
        let is_selected = |region: &Region| self.selection() == Some(Selection::Region(*region));
        let next = around.iter().position(is_selected).map_or(0, |place| (place + 1) % around.len());
        around.get(next).map_or(Selection::Landmark(vertex), |&region| Selection::Region(region))
    }

    /// What is selected, if a vertex is part of it, or what is selected there.
    pub(crate) fn at_or_grabbed(&self, vertex: u32, mode: SelectionMode) -> Selection {
        self.selection().filter(|_| self.holds(vertex)).unwrap_or_else(|| self.at(vertex, mode))
    }

    /// What is selected, made what `mode` selects: the region around a landmark, the landmark in the middle of a region or
    /// beside a point, the point that a landmark is on the mesh that is shown.
    pub(crate) fn selected_by(&self, mode: SelectionMode) -> Option<Selection> {
        let landmark = match (self.selection()?, mode) {
            (as_it_is @ Selection::Landmark(_), SelectionMode::Landmark)
            | (as_it_is @ Selection::Region(_), SelectionMode::Region)
            | (as_it_is @ Selection::Point { .. }, SelectionMode::Point) => return Some(as_it_is),
            (Selection::Point { vertex, .. }, _) => self.document().nearest_on(0, vertex)?,
            (other, _) => other.middle(),
        };
        Some(self.at(landmark, mode))
    }

    /// Whether a vertex is selected, alone or with its region.
    pub fn holds(&self, vertex: u32) -> bool {
        self.selection().is_some_and(|selection| selection.handles().contains(&vertex))
    }

    /// Whether the other side can follow what is selected.
    pub fn can_mirror(&self) -> bool {
        let partner = |one: Selection| self.document().partner(one.level(), one.middle());
        self.selection().is_none_or(|selection| partner(selection).is_some())
    }

    /// Whether all that is selected is pinned.
    pub fn is_pinned(&self) -> bool {
        let is_pinned = |vertex: &u32| self.pins().contains(vertex);
        self.selection().is_some_and(|selection| selection.handles().iter().all(is_pinned))
    }

    /// The vertex that a ray meets the mesh nearest to; the landmark nearest to that where landmarks are selected.
    pub(crate) fn pick(&self, ray: &Ray, mode: SelectionMode) -> Option<u32> {
        let positions_m = self.document().positions();
        let surface = Surface::new(self.document().topology(), positions_m).ok()?;
        let vertex = rosto_mesh::pick(surface, ray)?.nearest_corner();
        if !self.selects_landmarks(mode) {
            return Some(vertex);
        }
        nearest(positions_m.iter().take(LANDMARK_COUNT), positions_m[vertex as usize])
    }

    /// Whether it is landmarks that are selected, alone or with their region.
    pub(crate) fn selects_landmarks(&self, mode: SelectionMode) -> bool {
        mode != SelectionMode::Point || self.document().density() == 0
    }

    /// Where on the mesh at rest what is selected is.
    pub(crate) fn selected_m(&self) -> Option<DVec3> {
        self.document().rest().get(self.selected()? as usize).copied()
    }

    /// The vertex shown that is nearest to a place at rest.
    pub(crate) fn nearest(&self, place_m: DVec3) -> u32 {
        nearest(self.document().rest().iter(), place_m).unwrap_or_default()
    }
}

fn nearest<'a>(places_m: impl Iterator<Item = &'a DVec3>, to_m: DVec3) -> Option<u32> {
    let distances = places_m.map(|place_m| place_m.distance_squared(to_m)).zip(0..);
    distances.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, vertex)| vertex)
}
