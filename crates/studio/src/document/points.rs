use glam::DVec3;
use rosto_face::{LANDMARK_COUNT, part_id};
use rosto_mesh::Topology;

use super::Document;
use crate::level::Level;
use crate::{Command, EditTarget, Entry};

/// Vertices of the mesh that is shown, beside the landmarks.
impl Document {
    /// The part of the face that a point of a denser mesh lies in, such as `left-cheek`, once that mesh was shown; none for
    /// targets whose own name tells where they are.
    pub fn part_of(&self, target: EditTarget) -> Option<String> {
        match target {
            EditTarget::Point { level, vertex } => self.landmark_beside(level, vertex).map(part_id),
            _ => None,
        }
    }

    /// The vertex of a coarser mesh that is nearest to one of the mesh that is shown, both at rest: 0 subdivisions give the
    /// nearest landmark.
    pub fn nearest_on(&self, level: u32, vertex: u32) -> Option<u32> {
        let place = *self.rest().get(vertex as usize)?;
        let coarser = self.levels.get(level as usize)?;
        nearest(&self.rest()[..coarser.rest().len().min(self.rest().len())], place)
    }

    /// How many vertices the mesh subdivided so many times has; none if it was never shown.
    pub fn vertex_count(&self, level: u32) -> Option<usize> {
        self.levels.get(level as usize).map(|level| level.rest().len())
    }

    /// The coarsest mesh, by how often it was subdivided, whose vertices show every edit: that of the finest edit which does not
    /// wait for a denser mesh. Its vertices are the first of the mesh that is shown.
    pub fn edited_level(&self) -> u32 {
        let of_entry = |entry: &Entry| match &entry.command {
            Command::Move { spec, .. } => spec.level,
            Command::Symmetrise { .. } | Command::Express { .. } => 0,
        };
        let of_held = self.prepared.as_ref().map(|prepared| prepared.spec().level);
        let levels = self.history().entries().iter().map(of_entry).chain(of_held);
        levels.filter(|level| *level <= self.density()).max().unwrap_or(0)
    }

    /// The mesh subdivided so many times; none if it was never shown.
    pub fn topology_at(&self, level: u32) -> Option<&Topology> {
        self.levels.get(level as usize).map(Level::topology)
    }

    /// The mirror image of a vertex of the mesh subdivided so many times; none where the triangles have none.
    pub fn partner(&self, level: u32, vertex: u32) -> Option<u32> {
        let level = self.levels.get(level as usize)?;
        let known = (vertex as usize) < level.rest().len();
        level.mirror().ok().filter(|_| known).map(|table| table.partner(vertex))
    }

    /// Whether a vertex of the mesh subdivided so many times lies on the face's oval, or on the mesh's longest boundary.
    pub fn is_on_oval(&self, level: u32, vertex: u32) -> bool {
        self.levels.get(level as usize).is_some_and(|level| level.oval().contains(&vertex))
    }

    fn landmark_beside(&self, level: u32, vertex: u32) -> Option<u32> {
        let rest = self.levels.get(level as usize)?.rest();
        let is_face = self.levels[0].rest().len() == LANDMARK_COUNT;
        rest.get(vertex as usize).filter(|_| is_face).and_then(|place| nearest(&rest[..LANDMARK_COUNT], *place))
    }
}

/// The first of the places that are nearest to one.
pub(super) fn nearest(places: &[DVec3], to: DVec3) -> Option<u32> {
    let distances = places.iter().map(|place| place.distance_squared(to)).zip(0..);
    distances.min_by(|(one, _), (other, _)| one.total_cmp(other)).map(|(_, vertex)| vertex)
}
