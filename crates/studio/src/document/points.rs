use glam::DVec3;
use rosto_face::part_id;
use rosto_mesh::Topology;

use super::Document;
use crate::level::Level;
use crate::{Command, EditTarget, Entry};

/// Queries about vertices.
impl Document {
    /// The part of the face around a point of a denser mesh, such as `left-cheek`. `None` if that mesh has not been
    /// built, and for targets that have a name.
    pub fn part_of(&self, target: EditTarget) -> Option<String> {
        match target {
            EditTarget::Point { level, vertex } => self.nearest_landmark(level, vertex).map(part_id),
            _ => None,
        }
    }

    /// The vertex of a coarser mesh nearest to a vertex of the displayed mesh, both at rest. Level 0 gives the nearest
    /// landmark.
    pub fn nearest_on(&self, level: u32, vertex: u32) -> Option<u32> {
        let position = *self.rest().get(vertex as usize)?;
        let coarser = self.levels.get(level as usize)?;
        nearest(&self.rest()[..coarser.rest().len().min(self.rest().len())], position)
    }

    /// Number of vertices at a subdivision level; `None` if it has not been built.
    pub fn vertex_count(&self, level: u32) -> Option<usize> {
        self.levels.get(level as usize).map(|level| level.rest().len())
    }

    /// The coarsest level whose vertices show each edit: the level of the finest edit that does not wait for a denser
    /// mesh. Its vertices are the first of the displayed mesh.
    pub fn edited_level(&self) -> u32 {
        let of_entry = |entry: &Entry| match &entry.command {
            Command::Move { spec, .. } => spec.level,
            Command::Symmetrise { .. } | Command::Express { .. } => 0,
        };
        let of_prepared = self.prepared.as_ref().map(|prepared| prepared.spec().level);
        let levels = self.history().entries().iter().map(of_entry).chain(of_prepared);
        levels.filter(|level| *level <= self.density()).max().unwrap_or(0)
    }

    /// The mesh at a subdivision level; `None` if it has not been built.
    pub fn topology_at(&self, level: u32) -> Option<&Topology> {
        self.levels.get(level as usize).map(Level::topology)
    }

    /// The mirror image of a vertex at a subdivision level; `None` if the triangles are not symmetric.
    pub fn partner(&self, level: u32, vertex: u32) -> Option<u32> {
        let level = self.levels.get(level as usize)?;
        let exists = (vertex as usize) < level.rest().len();
        level.mirror().ok().filter(|_| exists).map(|table| table.partner(vertex))
    }

    /// Whether a vertex at a subdivision level lies on the face's oval or on the longest boundary.
    pub fn is_on_oval(&self, level: u32, vertex: u32) -> bool {
        self.levels.get(level as usize).is_some_and(|level| level.oval().contains(&vertex))
    }

    fn nearest_landmark(&self, level: u32, vertex: u32) -> Option<u32> {
        let level = self.levels.get(level as usize)?;
        nearest(level.landmarks(), *level.rest().get(vertex as usize)?)
    }
}

/// Index of the first of the positions that are nearest to `to`.
pub(super) fn nearest(positions: &[DVec3], to: DVec3) -> Option<u32> {
    let distances = positions.iter().map(|position| position.distance_squared(to)).zip(0..);
    distances.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, vertex)| vertex)
}
