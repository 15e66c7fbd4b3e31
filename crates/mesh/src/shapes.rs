//! Small test meshes.

use glam::DVec3;

use crate::Topology;

pub fn tetrahedron() -> (Topology, Vec<DVec3>) {
    let positions = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let triangles = vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    (Topology::new(4, triangles).unwrap(), positions.map(DVec3::from).to_vec())
}

/// Twelve vertices on the unit sphere; twenty triangles, counter-clockwise as seen from outside.
pub fn icosahedron() -> (Topology, Vec<DVec3>) {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let mut positions = Vec::new();
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        positions.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)]);
    }
    let joined = |a: usize, b: usize| (positions[a] - positions[b]).length() < 2.1;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for (b, c) in (a + 1..12).flat_map(|b| (b + 1..12).map(move |c| (b, c))) {
            if joined(a, b) && joined(b, c) && joined(c, a) {
                let outward = (positions[b] - positions[a]).cross(positions[c] - positions[a]).dot(positions[a]) > 0.0;
                let [b, c] = if outward { [b, c] } else { [c, b] };
                triangles.push([a as u32, b as u32, c as u32]);
            }
        }
    }
    (Topology::new(12, triangles).unwrap(), positions.into_iter().map(DVec3::normalize).collect())
}
