use glam::DVec3;

use crate::Topology;

/// Area-weighted unit normals, one per vertex, on the side where triangles wind counter-clockwise.
///
/// Normalises the sum of the area vectors of the vertex's triangles. If that sum is zero, the normal is `+Z`.
///
/// # Panics
/// If the numbers of positions and vertices differ.
pub fn vertex_normals(topology: &Topology, positions: &[DVec3]) -> Vec<DVec3> {
    assert_eq!(positions.len(), topology.vertex_count(), "one position for each vertex");
    let mut normals = vec![DVec3::ZERO; positions.len()];
    for &[a, b, c] in topology.triangles() {
        let [a, b, c] = [a as usize, b as usize, c as usize];
        let twice_area = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
        for corner in [a, b, c] {
            normals[corner] += twice_area;
        }
    }
    normals.into_iter().map(|sum| sum.normalize_or(DVec3::Z)).collect()
}

#[cfg(test)]
mod tests {
    use glam::DQuat;
    use proptest::prelude::*;

    use super::*;
    use crate::shapes::{icosahedron, tetrahedron};

    #[test]
    fn normals_of_an_icosahedron_point_outwards() {
        let (topology, positions) = icosahedron();
        for (normal, position) in vertex_normals(&topology, &positions).iter().zip(&positions) {
            assert!(normal.dot(position.normalize()) > 1.0 - 1e-12);
        }
    }

    #[test]
    fn a_vertex_without_triangles_has_a_unit_normal() {
        let lonely = Topology::new(4, vec![[0, 1, 2]]).unwrap();
        let normals = vertex_normals(&lonely, &[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE]);
        assert_eq!(normals, [DVec3::Z; 4]);
    }

    proptest! {
        #[test]
        fn normals_rotate_with_the_mesh_and_ignore_translation_and_scale(
            turn in prop::array::uniform4(-1.0..1.0f64), shift in prop::array::uniform3(-9.0..9.0f64),
            scale in 0.1..10.0f64,
        ) {
            prop_assume!(DVec3::new(turn[0], turn[1], turn[2]).length() > 0.1);
            let rotation = DQuat::from_array(turn).normalize();
            let (topology, rest) = tetrahedron();
            let moved: Vec<DVec3> = rest.iter().map(|&p| rotation * (scale * p) + DVec3::from(shift)).collect();
            for (before, after) in vertex_normals(&topology, &rest).into_iter().zip(vertex_normals(&topology, &moved)) {
                prop_assert!((rotation * before - after).length() < 1e-12);
            }
        }
    }
}
