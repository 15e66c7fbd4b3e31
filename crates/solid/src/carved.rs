//! Bodies with a carved front.

use glam::DVec3;
use rosto_mesh::Topology;

use crate::Body;
use crate::crossings::crossings_of;

/// Shares of the depth, tried in turn until nothing intersects.
const SHARES: [f64; 3] = [1.0, 0.6, 0.3];

/// Distances from a carved vertex, in wall thicknesses, up to which the back recedes fully, and from which not at all.
const RECEDES: [f64; 2] = [1.0, 3.0];

/// Depths to carve into a finer version of a body's front.
#[derive(Debug, Clone, Copy)]
pub struct Carving<'a> {
    /// Triangles in place of those of the surface, whose vertices keep their indices; added vertices follow.
    pub topology: &'a Topology,
    /// The two earlier vertices halfway between which each added vertex lies.
    pub midpoints: &'a [[u32; 2]],
    /// Depth of each vertex along −Z, in metres; 0 at the rim and at vertices that stay.
    pub depths_m: &'a [f64],
}

impl Body {
    /// Carves the front, less deep where it would intersect itself, and not at all if that is not enough. The back of a
    /// wall recedes behind the carving. `surface` is the topology from which the body was made.
    ///
    /// # Panics
    /// If the carving does not have one depth per vertex.
    pub fn carved(&self, surface: &Topology, carving: &Carving<'_>) -> Self {
        let Carving { topology, midpoints, depths_m } = carving;
        assert_eq!(depths_m.len(), topology.vertex_count(), "one depth per vertex");
        if midpoints.is_empty() && depths_m.iter().all(|depth_m| *depth_m == 0.0) {
            return self.clone();
        }
        let (front, added) = (self.front_vertices(), midpoints.len() as u32);
        let behind = |corner: u32| if (corner as usize) < front { corner } else { corner + added };
        let others = &self.topology().triangles()[surface.triangles().len()..];
        let others = others.iter().map(|corners| corners.map(behind));
        let triangles: Vec<[u32; 3]> = topology.triangles().iter().copied().chain(others).collect();
        let carved = Topology::new(self.positions_m().len() + midpoints.len(), triangles);
        let carved = carved.expect("invariant: a refined body is a mesh");
        let middles = |values: &[DVec3]| refined(values, midpoints, |a, b| a.midpoint(b));
        let uncarved_m = middles(&self.positions_m()[..front]);
        let receding_m = self.receding_m(&uncarved_m, depths_m);
        SHARES
            .into_iter()
            .find_map(|share| self.carved_to(share, &carved, carving, &uncarved_m, &receding_m))
            .unwrap_or_else(|| self.clone())
    }

    fn carved_to(
        &self,
        share: f64,
        topology: &Topology,
        carving: &Carving<'_>,
        uncarved_m: &[DVec3],
        receding_m: &[f64],
    ) -> Option<Self> {
        let front = self.front_vertices();
        let sunk = |(position, depth_m): (&DVec3, &f64)| *position - DVec3::Z * (share * depth_m);
        let back = &self.positions_m()[front..];
        let back = back.iter().enumerate().map(|(at, position)| {
            let by_m = receding_m.get(at).copied().unwrap_or_default();
            *position - DVec3::Z * (share * by_m)
        });
        let positions_m: Vec<DVec3> = uncarved_m.iter().zip(carving.depths_m).map(sunk).chain(back).collect();
        let has_moved = |vertex: u32| match vertex as usize {
            at if at < uncarved_m.len() => at >= front || carving.depths_m[at] > 0.0,
            at => receding_m.get(at - uncarved_m.len()).is_some_and(|by_m| *by_m > 0.0),
        };
        let triangles = topology.triangles();
        let moved = |triangle: u32| triangles[triangle as usize].iter().any(|&corner| has_moved(corner));
        if !crossings_of(triangles, &positions_m, moved).is_empty() {
            return None;
        }
        let average = |a: f64, b: f64| a.midpoint(b);
        let thickness_m = refined(self.thickness_m(), carving.midpoints, average);
        let receded_m = if receding_m.is_empty() { &vec![0.0; front] } else { receding_m };
        let receded_m = refined(receded_m, carving.midpoints, average);
        let thickness_m: Vec<f64> = (0..thickness_m.len())
            .map(|vertex| thickness_m[vertex] + share * (receded_m[vertex] - carving.depths_m[vertex]))
            .collect();
        let is_thick = thickness_m.iter().all(|thickness_m| *thickness_m > 0.0);
        let added = topology.triangles().len() - self.topology().triangles().len();
        is_thick.then(|| self.with_front(topology.clone(), positions_m, thickness_m, added))
    }

    /// Distance by which each vertex of a wall's back recedes; empty for a flat back.
    fn receding_m(&self, uncarved_m: &[DVec3], depths_m: &[f64]) -> Vec<f64> {
        let Some(wall_m) = self.wall_m() else { return Vec::new() };
        let deep: Vec<(DVec3, f64)> =
            uncarved_m.iter().zip(depths_m).filter(|(_, depth_m)| **depth_m > 0.0).map(|(at, by)| (*at, *by)).collect();
        let [full_m, none_m] = RECEDES.map(|times| times * wall_m);
        let receding_m = |at: &DVec3| {
            let by = |(other, depth_m): &(DVec3, f64)| {
                let near = ((none_m - at.distance(*other)) / (none_m - full_m)).clamp(0.0, 1.0);
                depth_m * near * near * (3.0 - 2.0 * near)
            };
            deep.iter().map(by).fold(0.0, f64::max)
        };
        self.positions_m()[..self.front_vertices()].iter().map(receding_m).collect()
    }
}

/// Values at the vertices, followed by those at the midpoints.
fn refined<T: Copy>(values: &[T], midpoints: &[[u32; 2]], middle: impl Fn(T, T) -> T) -> Vec<T> {
    let mut values = values.to_vec();
    midpoints.iter().for_each(|&[a, b]| values.push(middle(values[a as usize], values[b as usize])));
    values
}
