use glam::DVec3;

use crate::{MeshError, Topology};

/// A topology with one position per vertex, both borrowed.
#[derive(Debug, Clone, Copy)]
pub struct Surface<'a> {
    topology: &'a Topology,
    positions: &'a [DVec3],
}

impl<'a> Surface<'a> {
    /// Pairs a topology with positions, in any unit.
    ///
    /// # Errors
    /// [`MeshError::LengthMismatch`] if the numbers of positions and vertices differ.
    pub fn new(topology: &'a Topology, positions: &'a [DVec3]) -> Result<Self, MeshError> {
        let (expected, found) = (topology.vertex_count(), positions.len());
        if found == expected {
            Ok(Self { topology, positions })
        } else {
            Err(MeshError::LengthMismatch { expected, found })
        }
    }

    /// The topology.
    pub fn topology(self) -> &'a Topology {
        self.topology
    }

    /// The positions, one per vertex.
    pub fn positions(self) -> &'a [DVec3] {
        self.positions
    }

    /// The corner positions of each triangle, in the topology's order.
    pub fn triangles(self) -> impl Iterator<Item = [DVec3; 3]> + 'a {
        let Self { topology, positions } = self;
        topology.triangles().iter().map(|corners| corners.map(|corner| positions[corner as usize]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{icosahedron, tetrahedron};

    #[test]
    fn a_length_mismatch_reports_both_numbers() {
        let ((four, _), (_, twelve)) = (tetrahedron(), icosahedron());
        let refused = Surface::new(&four, &twelve).unwrap_err();
        assert_eq!(refused, MeshError::LengthMismatch { expected: 4, found: 12 });
        assert_eq!(refused.to_string(), "12 values for 4 vertices");
    }

    #[test]
    fn triangles_yield_the_positions_of_their_corners() {
        let (topology, positions) = tetrahedron();
        let surface = Surface::new(&topology, &positions).unwrap();
        let corners: Vec<_> = surface.triangles().collect();
        assert_eq!(corners.len(), 4);
        assert_eq!(corners[1], [positions[0], positions[3], positions[1]]);
    }
}
