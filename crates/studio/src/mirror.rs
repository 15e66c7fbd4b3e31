use std::collections::HashSet;

use glam::DVec3;
use rosto_mesh::Topology;

/// The left-right partner of each vertex of a mesh with the mirror plane x = 0.
#[derive(Debug, Clone)]
pub(crate) struct MirrorTable {
    partners: Vec<u32>,
}

/// Mirror image of a point or offset in the plane x = 0.
pub(crate) fn reflected(vector: DVec3) -> DVec3 {
    DVec3::new(-vector.x, vector.y, vector.z)
}

impl MirrorTable {
    pub(crate) fn of_landmarks() -> Self {
        Self { partners: (0..rosto_face::LANDMARK_COUNT as u32).map(rosto_face::mirror_of).collect() }
    }

    /// The table for one subdivision of `coarse`; `None` if an edge has no mirror image.
    ///
    /// Relies on the order of the new vertices, which is that of the edges they split.
    pub(crate) fn subdivided(&self, coarse: &Topology) -> Option<Self> {
        let added = coarse.edges().iter().map(|&[a, b]| {
            let (a, b) = (self.partner(a), self.partner(b));
            let edge = coarse.edge(a, b)?;
            Some((coarse.vertex_count() + edge) as u32)
        });
        let added: Vec<u32> = added.collect::<Option<_>>()?;
        Some(Self { partners: self.partners.iter().copied().chain(added).collect() })
    }

    pub(crate) fn partner(&self, vertex: u32) -> u32 {
        self.partners[vertex as usize]
    }

    /// `vertices` in order, then the partners that are not among them, without repeats.
    pub(crate) fn closure(&self, vertices: &[u32]) -> Vec<u32> {
        let mut seen = HashSet::with_capacity(vertices.len() * 2);
        let all = vertices.iter().copied().chain(vertices.iter().map(|&vertex| self.partner(vertex)));
        all.filter(|&vertex| seen.insert(vertex)).collect()
    }

    /// Replaces each value with the minimum of it and its partner's.
    pub(crate) fn nearer_of_both(&self, values: &mut [f64]) {
        for (vertex, &partner) in self.partners.iter().enumerate() {
            let nearer = values[vertex].min(values[partner as usize]);
            (values[vertex], values[partner as usize]) = (nearer, nearer);
        }
    }

    /// Makes the displacement from `rest` to `moved` symmetric: each vertex takes the mean of its displacement and its
    /// partner's reflected one. A symmetric displacement changes only by rounding.
    ///
    /// Needed if the triangles or the mesh at rest are not symmetric: the responses of two partners then differ
    /// slightly.
    pub(crate) fn symmetrise_displacement(&self, rest: &[DVec3], moved: &mut [DVec3]) {
        for (vertex, &partner) in self.partners.iter().enumerate() {
            let partner = partner as usize;
            if partner < vertex {
                continue;
            }
            let here = moved[vertex] - rest[vertex];
            let there = moved[partner] - rest[partner];
            let mean = (here + reflected(there)) / 2.0;
            moved[vertex] = rest[vertex] + mean;
            moved[partner] = rest[partner] + reflected(mean);
        }
    }

    /// Moves each vertex by `share` of its distance to the symmetric shape.
    pub(crate) fn symmetrise_shape(&self, share: f64, positions: &mut [DVec3]) {
        for (vertex, &partner) in self.partners.iter().enumerate() {
            let partner = partner as usize;
            if partner < vertex {
                continue;
            }
            let (here, there) = (positions[vertex], reflected(positions[partner]));
            let mean = (here + there) / 2.0;
            positions[vertex] = here + (mean - here) * share;
            positions[partner] = reflected(there + (mean - there) * share);
        }
    }
}
