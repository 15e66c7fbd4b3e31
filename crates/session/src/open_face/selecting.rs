use glam::DVec3;
use rosto_face::{LANDMARK_COUNT, Region};
use rosto_mesh::{Ray, Surface};

use super::OpenFace;
use crate::error::SessionError;
use crate::{Selection, SelectionMode};

/// Conversion of vertices to selections.
impl OpenFace {
    /// Number of vertices that `mode` can select, from 0.
    pub fn selectable_count(&self, mode: SelectionMode) -> usize {
        match mode {
            SelectionMode::Landmark | SelectionMode::Region => LANDMARK_COUNT,
            SelectionMode::Point => self.document().rest().len(),
        }
    }

    /// Checks that a vertex exists.
    pub(crate) fn known(&self, vertex: u32, mode: SelectionMode) -> Result<u32, SessionError> {
        let count = self.selectable_count(mode);
        if (vertex as usize) < count { Ok(vertex) } else { Err(SessionError::NoSuchVertex { vertex, count }) }
    }

    /// Selection at a vertex that [`Self::known`] accepts. A region is the smallest around the vertex or, if that is
    /// already selected, the next larger one; without a region it is the landmark.
    pub(crate) fn at(&self, vertex: u32, mode: SelectionMode) -> Selection {
        let around = match (mode, self.document().density()) {
            (SelectionMode::Point, level @ 1..) => return Selection::Point { level, vertex },
            (SelectionMode::Landmark | SelectionMode::Point, _) => Vec::new(),
            (SelectionMode::Region, _) => Region::containing(vertex),
        };
        let is_selected = |region: &Region| self.selection() == Some(Selection::Region(*region));
        let next = around.iter().position(is_selected).map_or(0, |index| (index + 1) % around.len());
        around.get(next).map_or(Selection::Landmark(vertex), |&region| Selection::Region(region))
    }

    /// The current selection if it contains the vertex, else the selection at the vertex.
    pub(crate) fn selection_around(&self, vertex: u32, mode: SelectionMode) -> Selection {
        self.selection().filter(|_| self.holds(vertex)).unwrap_or_else(|| self.at(vertex, mode))
    }

    /// The current selection converted to `mode`: the region around a landmark, the central landmark of a region or the
    /// nearest one to a point, or the displayed point of a landmark.
    pub(crate) fn selection_in(&self, mode: SelectionMode) -> Option<Selection> {
        let landmark = match (self.selection()?, mode) {
            (as_it_is @ Selection::Landmark(_), SelectionMode::Landmark)
            | (as_it_is @ Selection::Region(_), SelectionMode::Region)
            | (as_it_is @ Selection::Point { .. }, SelectionMode::Point) => return Some(as_it_is),
            (Selection::Point { vertex, .. }, _) => self.document().nearest_on(0, vertex)?,
            (other, _) => other.centre(),
        };
        Some(self.at(landmark, mode))
    }

    /// Whether the selection contains a vertex.
    pub fn holds(&self, vertex: u32) -> bool {
        self.selection().is_some_and(|selection| selection.handles().contains(&vertex))
    }

    /// Whether the selection has a mirror image.
    pub fn can_mirror(&self) -> bool {
        let partner = |one: Selection| self.document().partner(one.level(), one.centre());
        self.selection().is_none_or(|selection| partner(selection).is_some())
    }

    /// Whether each vertex of the selection is pinned.
    pub fn is_pinned(&self) -> bool {
        let is_pinned = |vertex: &u32| self.pins().contains(vertex);
        self.selection().is_some_and(|selection| selection.handles().iter().all(is_pinned))
    }

    /// The vertex nearest to the point where a ray hits the mesh; the nearest landmark if landmarks are selected.
    pub(crate) fn pick(&self, ray: &Ray, mode: SelectionMode) -> Option<u32> {
        let positions_m = self.document().positions();
        let surface = Surface::new(self.document().topology(), positions_m).ok()?;
        let vertex = rosto_mesh::pick(surface, ray)?.nearest_corner();
        if !self.selects_landmarks(mode) {
            return Some(vertex);
        }
        nearest(positions_m.iter().take(LANDMARK_COUNT), positions_m[vertex as usize])
    }

    /// Whether a click selects landmarks, alone or with their region.
    pub(crate) fn selects_landmarks(&self, mode: SelectionMode) -> bool {
        mode != SelectionMode::Point || self.document().density() == 0
    }

    /// Position of the selected vertex on the mesh at rest.
    pub(crate) fn selected_m(&self) -> Option<DVec3> {
        self.document().rest().get(self.selected()? as usize).copied()
    }

    /// The displayed vertex nearest to a position at rest.
    pub(crate) fn nearest(&self, position_m: DVec3) -> u32 {
        nearest(self.document().rest().iter(), position_m).unwrap_or_default()
    }
}

fn nearest<'a>(positions_m: impl Iterator<Item = &'a DVec3>, to_m: DVec3) -> Option<u32> {
    let distances = positions_m.map(|position_m| position_m.distance_squared(to_m)).zip(0..);
    distances.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, vertex)| vertex)
}
