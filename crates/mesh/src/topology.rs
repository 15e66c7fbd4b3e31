use std::collections::HashMap;

use crate::MeshError;

/// Which vertices a mesh has and how triangles join them; no positions.
///
/// Vertices are `0..vertex_count`; a vertex that no triangle uses is allowed and has degree 0. Triangles wind
/// counter-clockwise as seen from outside. Neighbours are kept sorted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topology {
    vertex_count: usize,
    triangles: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
    neighbour_starts: Vec<usize>,
    neighbours: Vec<u32>,
}

impl Topology {
    /// Builds the adjacency of `triangles` over `vertex_count` vertices.
    ///
    /// # Errors
    /// [`MeshError::VertexOutOfRange`] or [`MeshError::RepeatedCorner`] for the first triangle that is none.
    pub fn new(vertex_count: usize, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        for (index, corners) in triangles.iter().enumerate() {
            check_triangle(index, *corners, vertex_count)?;
        }
        let edges = undirected_edges(&triangles);
        let (neighbour_starts, neighbours) = one_rings(vertex_count, &edges);
        Ok(Self { vertex_count, triangles, edges, neighbour_starts, neighbours })
    }

    /// Number of vertices, used by triangles or not.
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The triangles, in the order given.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Every undirected edge once, `[low, high]`, sorted.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The one-ring of `vertex`, sorted.
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

    /// Connected components: for each vertex, the lowest vertex of its component.
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

    /// Boundary loops, each as a cycle of vertices that keeps the surface on its left; longest first, then by lowest
    /// vertex. Where several loops touch in one vertex, each still closes.
    pub fn boundary_loops(&self) -> Vec<Vec<u32>> {
        let mut next = boundary_successors(&self.triangles);
        let mut starts: Vec<u32> = next.keys().copied().collect();
        starts.sort_unstable();
        let mut loops = Vec::new();
        for start in starts {
            while let Some(cycle) = take_cycle(&mut next, start) {
                loops.push(cycle);
            }
        }
        loops.sort_by_key(|cycle: &Vec<u32>| (std::cmp::Reverse(cycle.len()), cycle.iter().min().copied()));
        loops
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

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn undirected_edges(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let mut edges: Vec<[u32; 2]> =
        triangles.iter().flat_map(|&corners| sides(corners)).map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

fn one_rings(vertex_count: usize, edges: &[[u32; 2]]) -> (Vec<usize>, Vec<u32>) {
    let mut directed: Vec<[u32; 2]> = edges.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
    directed.sort_unstable();
    let mut starts = vec![0; vertex_count + 1];
    for [from, _] in &directed {
        starts[*from as usize + 1] += 1;
    }
    for vertex in 0..vertex_count {
        starts[vertex + 1] += starts[vertex];
    }
    (starts, directed.into_iter().map(|[_, to]| to).collect())
}

/// For each boundary vertex, where the boundary goes on from it.
fn boundary_successors(triangles: &[[u32; 3]]) -> HashMap<u32, Vec<u32>> {
    let mut uses: HashMap<[u32; 2], usize> = HashMap::new();
    for [a, b] in triangles.iter().flat_map(|&corners| sides(corners)) {
        *uses.entry([a.min(b), a.max(b)]).or_default() += 1;
    }
    let mut next: HashMap<u32, Vec<u32>> = HashMap::new();
    for [a, b] in triangles.iter().flat_map(|&corners| sides(corners)) {
        if uses[&[a.min(b), a.max(b)]] == 1 {
            next.entry(a).or_default().push(b);
        }
    }
    next
}

fn take_cycle(next: &mut HashMap<u32, Vec<u32>>, start: u32) -> Option<Vec<u32>> {
    let mut cycle = vec![start];
    let mut at = next.get_mut(&start)?.pop()?;
    while at != start {
        cycle.push(at);
        match next.get_mut(&at).and_then(Vec::pop) {
            Some(to) => at = to,
            None => return Some(cycle),
        }
    }
    Some(cycle)
}
