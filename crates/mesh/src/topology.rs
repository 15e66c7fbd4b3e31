use crate::MeshError;

/// The vertices and triangles of a mesh, without positions.
///
/// Vertices are numbered `0..vertex_count`. A vertex without triangles is allowed and has degree 0. Triangles wind
/// counter-clockwise as seen from outside.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topology {
    vertex_count: usize,
    triangles: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
    /// For each vertex, the first edge whose lower vertex it is.
    edge_starts: Vec<usize>,
    neighbour_starts: Vec<usize>,
    neighbours: Vec<u32>,
}

impl Topology {
    /// Builds the adjacency of `triangles` over `vertex_count` vertices.
    ///
    /// # Errors
    /// [`MeshError::VertexOutOfRange`] or [`MeshError::RepeatedCorner`] for the first invalid triangle.
    pub fn new(vertex_count: usize, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        for (index, corners) in triangles.iter().enumerate() {
            check_triangle(index, *corners, vertex_count)?;
        }
        let (edge_starts, edges) = undirected_edges(vertex_count, &triangles);
        let (neighbour_starts, neighbours) = one_rings(vertex_count, &edges);
        Ok(Self { vertex_count, triangles, edges, edge_starts, neighbour_starts, neighbours })
    }

    /// Number of vertices, including those without triangles.
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The triangles, in the order given to [`Self::new`].
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The undirected edges as `[low, high]`, sorted and without duplicates.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// Index of an undirected edge in [`Self::edges`]; `None` if the vertices share no edge.
    pub fn edge(&self, a: u32, b: u32) -> Option<usize> {
        let low = a.min(b) as usize;
        let (from, to) = (*self.edge_starts.get(low)?, *self.edge_starts.get(low + 1)?);
        Some(from + self.edges[from..to].binary_search(&[a.min(b), a.max(b)]).ok()?)
    }

    /// The neighbours of `vertex`, sorted.
    ///
    /// # Panics
    /// If `vertex` is not below [`Self::vertex_count`].
    pub fn neighbours(&self, vertex: u32) -> &[u32] {
        let vertex = vertex as usize;
        &self.neighbours[self.neighbour_starts[vertex]..self.neighbour_starts[vertex + 1]]
    }

    /// Number of neighbours of `vertex`.
    ///
    /// # Panics
    /// If `vertex` is not below [`Self::vertex_count`].
    pub fn degree(&self, vertex: u32) -> usize {
        self.neighbours(vertex).len()
    }

    /// For each vertex, the lowest vertex of its connected component.
    pub fn components(&self) -> Vec<u32> {
        let mut component = vec![u32::MAX; self.vertex_count];
        for seed in 0..self.vertex_count as u32 {
            if component[seed as usize] != u32::MAX {
                continue;
            }
            component[seed as usize] = seed;
            let mut open = vec![seed];
            while let Some(vertex) = open.pop() {
                for &next in self.neighbours(vertex) {
                    if component[next as usize] == u32::MAX {
                        component[next as usize] = seed;
                        open.push(next);
                    }
                }
            }
        }
        component
    }
}

fn check_triangle(triangle: usize, corners: [u32; 3], vertex_count: usize) -> Result<(), MeshError> {
    if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertex_count) {
        return Err(MeshError::VertexOutOfRange { triangle, vertex, vertex_count });
    }
    let [a, b, c] = corners;
    if a == b || a == c {
        return Err(MeshError::RepeatedCorner { triangle, vertex: a });
    }
    if b == c {
        return Err(MeshError::RepeatedCorner { triangle, vertex: b });
    }
    Ok(())
}

/// For each triangle, its three directed sides, each with the opposite corner.
pub(crate) fn corners(triangles: &[[u32; 3]]) -> impl Iterator<Item = [u32; 3]> {
    triangles.iter().flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]])
}

/// Index of the edge between two corners of a triangle.
pub(crate) fn edge(mesh: &Topology, a: u32, b: u32) -> usize {
    mesh.edge(a, b).expect("invariant: a triangle's sides are edges")
}

/// The first edge of each lower vertex, and all edges in order. Sorts the edges of each vertex, which is faster than
/// sorting all at once.
fn undirected_edges(vertex_count: usize, triangles: &[[u32; 3]]) -> (Vec<usize>, Vec<[u32; 2]>) {
    let sides = || corners(triangles).map(|[a, b, _]| [a.min(b), a.max(b)]);
    let (side_starts, mut higher) = grouped(vertex_count, sides);
    let (mut starts, mut edges) = (vec![0], Vec::with_capacity(higher.len() / 2 + 1));
    for (low, bounds) in side_starts.windows(2).enumerate() {
        let group = &mut higher[bounds[0]..bounds[1]];
        group.sort_unstable();
        edges.extend(group.chunk_by(|one, other| one == other).map(|same| [low as u32, same[0]]));
        starts.push(edges.len());
    }
    (starts, edges)
}

/// The neighbours of each vertex: the lower ones, then the higher ones. Both are sorted, as the edges are.
fn one_rings(vertex_count: usize, edges: &[[u32; 2]]) -> (Vec<usize>, Vec<u32>) {
    let lower = || edges.iter().map(|&[a, b]| [b, a]);
    grouped(vertex_count, || lower().chain(edges.iter().copied()))
}

/// The second vertices of pairs, grouped by the first, in their order. The group of vertex `v` starts at `starts[v]` and
/// ends at `starts[v + 1]`.
fn grouped<I: Iterator<Item = [u32; 2]>>(vertex_count: usize, pairs: impl Fn() -> I) -> (Vec<usize>, Vec<u32>) {
    let mut starts = vec![0; vertex_count + 1];
    for [first, _] in pairs() {
        starts[first as usize + 1] += 1;
    }
    for vertex in 0..vertex_count {
        starts[vertex + 1] += starts[vertex];
    }
    let (mut next, mut seconds) = (starts.clone(), vec![0; starts[vertex_count]]);
    for [first, second] in pairs() {
        seconds[next[first as usize]] = second;
        next[first as usize] += 1;
    }
    (starts, seconds)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::shapes::{icosahedron, tetrahedron};

    #[test]
    fn closed_solids_satisfy_eulers_formula_and_have_no_boundary() {
        for (solid, _) in [tetrahedron(), icosahedron()] {
            let (v, e, f) = (solid.vertex_count(), solid.edges().len(), solid.triangles().len());
            assert_eq!(v + f, e + 2);
            assert_eq!(solid.boundary_loops(), Vec::<Vec<u32>>::new());
        }
    }

    #[test]
    fn the_boundary_keeps_the_surface_on_its_left() {
        let square = Topology::new(4, vec![[0, 2, 1], [1, 2, 3]]).unwrap();
        assert_eq!(square.boundary_loops(), [[0, 2, 3, 1]]);
    }

    #[test]
    fn a_hole_is_a_separate_loop_after_the_longer_rim() {
        let (solid, positions) = icosahedron();
        let mut triangles = solid.triangles().to_vec();
        let lid = triangles.remove(0);
        let opposite = -positions[lid[0] as usize];
        let apex = positions.iter().position(|p| p.distance(opposite) < 1e-9).unwrap() as u32;
        triangles.retain(|t| !t.contains(&apex));
        let lengths: Vec<usize> = Topology::new(12, triangles).unwrap().boundary_loops().iter().map(Vec::len).collect();
        assert_eq!(lengths, [5, 3]);
    }

    #[test]
    fn components_are_identified_by_their_lowest_vertex() {
        let apart = Topology::new(7, vec![[5, 6, 1], [0, 2, 4]]).unwrap();
        assert_eq!(apart.components(), [0, 1, 0, 3, 0, 1, 1]);
        assert_eq!(apart.degree(3), 0);
    }

    #[test]
    fn invalid_triangles_are_reported() {
        let outside = MeshError::VertexOutOfRange { triangle: 1, vertex: 3, vertex_count: 3 };
        assert_eq!(Topology::new(3, vec![[0, 1, 2], [0, 1, 3]]), Err(outside));
        for repeated in [[1, 1, 2], [1, 2, 1], [2, 1, 1]] {
            let error = MeshError::RepeatedCorner { triangle: 0, vertex: 1 };
            assert_eq!(Topology::new(3, vec![repeated]), Err(error));
        }
    }

    proptest! {
        #[test]
        fn neighbours_are_symmetric_and_sorted_and_match_the_edges(
            corners in prop::collection::vec((0..20u32, 1..20u32, 1..19u32), 0..60),
        ) {
            let distinct = |(a, ab, extra): (u32, u32, u32)| {
                let skip = if extra >= ab { extra + 1 } else { extra };
                [a, (a + ab) % 20, (a + skip) % 20]
            };
            let mesh = Topology::new(20, corners.into_iter().map(distinct).collect()).unwrap();
            prop_assert_eq!((0..20).map(|v| mesh.degree(v)).sum::<usize>(), 2 * mesh.edges().len());
            for v in 0..20 {
                prop_assert!(mesh.neighbours(v).is_sorted());
                prop_assert!(mesh.neighbours(v).iter().all(|&w| mesh.neighbours(w).contains(&v)));
                prop_assert!(mesh.neighbours(v).iter().all(|&w| mesh.components()[w as usize] == mesh.components()[v as usize]));
            }
        }
    }
}
