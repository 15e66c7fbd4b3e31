//! Boundary loops of a surface.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use crate::Topology;
use crate::topology::{corners, edge};

impl Topology {
    /// The boundary loops, each a cycle of vertices with the surface on its left; longest first, then by lowest vertex.
    ///
    /// A loop does not repeat a vertex; loops that share a vertex are separate. Inconsistent winding can interrupt a
    /// boundary, which is then returned as an open path.
    pub fn boundary_loops(&self) -> Vec<Vec<u32>> {
        let mut rim = Rim::of(self);
        let mut found = Vec::new();
        while let Some(side) = rim.open.pop_first() {
            rim.walk(side, &mut found);
        }
        let rank = |cycle: &Vec<u32>| (Reverse(cycle.len()), cycle.iter().min().copied());
        let mut loops: Vec<Vec<u32>> = Vec::with_capacity(found.len());
        // Inserted in order, as a sort of lists takes 30 kB of code.
        for cycle in found {
            loops.insert(loops.partition_point(|other| rank(other) <= rank(&cycle)), cycle);
        }
        loops
    }
}

/// The boundary sides of a surface, with the adjacency to walk along them.
struct Rim<'a> {
    surface: &'a Topology,
    /// For each edge and each of its directions, the opposite corner of the triangle to the left.
    third: Vec<[Option<u32>; 2]>,
    /// Directed sides that belong to one triangle only and to no loop yet, with the surface on their left.
    open: BTreeSet<[u32; 2]>,
}

impl<'a> Rim<'a> {
    fn of(surface: &'a Topology) -> Self {
        let mut third = vec![[None; 2]; surface.edges().len()];
        let mut uses = vec![0_usize; third.len()];
        for [from, to, opposite] in corners(surface.triangles()) {
            let edge = edge(surface, from, to);
            third[edge][usize::from(from > to)] = Some(opposite);
            uses[edge] += 1;
        }
        let single = |&[from, to, _]: &[u32; 3]| uses[edge(surface, from, to)] == 1;
        let open = corners(surface.triangles()).filter(single).map(|[from, to, _]| [from, to]).collect();
        Self { surface, third, open }
    }

    /// The opposite corner of the triangle to the left of a side.
    fn third(&self, from: u32, to: u32) -> Option<u32> {
        self.third[edge(self.surface, from, to)][usize::from(from > to)]
    }

    /// Follows the boundary from a side to its end. Each return to a visited vertex closes a loop.
    fn walk(&mut self, side: [u32; 2], loops: &mut Vec<Vec<u32>>) {
        let mut path = vec![side[0]];
        let mut side = Some(side);
        while let Some([from, to]) = side {
            match path.iter().position(|&vertex| vertex == to) {
                Some(start) => {
                    loops.push(path[start..].to_vec());
                    path.truncate(start + 1);
                }
                None => path.push(to),
            }
            side = self.after([from, to]);
            side.iter().for_each(|next| _ = self.open.remove(next));
        }
        // Inconsistent windings interrupt the boundary.
        if path.len() > 1 {
            loops.push(path);
        }
    }

    /// The next boundary side. Rotates around the shared vertex through its triangles; if that fails, returns any open
    /// side that leaves the vertex.
    fn after(&self, [from, at]: [u32; 2]) -> Option<[u32; 2]> {
        let mut opposite = self.third(from, at);
        for _ in 0..self.surface.degree(at) {
            let Some(to) = opposite else { break };
            if self.open.contains(&[at, to]) {
                return Some([at, to]);
            }
            opposite = self.third(to, at);
        }
        self.open.range([at, 0]..=[at, u32::MAX]).next().copied()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn rims(triangles: &[[u32; 3]]) -> Vec<Vec<u32>> {
        let count = triangles.iter().flatten().max().map_or(0, |&highest| highest + 1);
        Topology::new(count as usize, triangles.to_vec()).unwrap().boundary_loops()
    }

    #[test]
    fn loops_that_share_a_vertex_close_separately_for_any_numbering() {
        assert_eq!(rims(&[[0, 1, 4], [4, 2, 3]]), [[0, 1, 4], [2, 3, 4]]);
        assert_eq!(rims(&[[0, 1, 2], [0, 3, 4]]).iter().map(Vec::len).collect::<Vec<_>>(), [3, 3]);
        let three_fans = rims(&[[9, 0, 1], [9, 2, 3], [9, 4, 5], [9, 5, 6]]);
        assert_eq!(three_fans.iter().map(Vec::len).collect::<Vec<_>>(), [4, 3, 3]);
    }

    /// Asserts that loops do not repeat a vertex and that each boundary side is in exactly one loop.
    fn assert_simple_and_complete(triangles: &[[u32; 3]]) {
        let loops = rims(triangles);
        let mut sides = Vec::new();
        for cycle in &loops {
            let mut vertices = cycle.clone();
            vertices.sort_unstable();
            vertices.dedup();
            assert_eq!(vertices.len(), cycle.len(), "{cycle:?} of {triangles:?}");
            sides.extend((0..cycle.len()).map(|at| [cycle[at], cycle[(at + 1) % cycle.len()]]));
        }
        sides.sort_unstable();
        let surface = Topology::new(64, triangles.to_vec()).unwrap();
        assert_eq!(sides, Rim::of(&surface).open.into_iter().collect::<Vec<_>>(), "{triangles:?}");
    }

    proptest! {
        /// A subset of a grid's triangles, consistently wound: islands, holes, and corners that touch.
        #[test]
        fn any_consistently_wound_surface_has_simple_loops(
            retained in prop::collection::vec(any::<bool>(), 72), shift in 0..64u32,
        ) {
            let name = |column: u32, row: u32| (7 * row + column + shift) * 27 % 64;
            let cut = |(column, row): (u32, u32)| {
                let [a, b] = [name(column, row), name(column + 1, row)];
                let [d, c] = [name(column, row + 1), name(column + 1, row + 1)];
                [[a, b, c], [a, c, d]]
            };
            let grid = (0..6).flat_map(|row| (0..6).map(move |column| (column, row))).flat_map(cut);
            let triangles: Vec<[u32; 3]> = grid.zip(retained).filter(|(_, keep)| *keep).map(|(t, _)| t).collect();
            assert_simple_and_complete(&triangles);
        }

        /// Random triangles with inconsistent winding.
        #[test]
        fn loops_are_simple_even_with_inconsistent_winding(
            corners in prop::collection::vec((0..9u32, 1..5u32, 5..9u32), 0..30),
        ) {
            let triangles: Vec<[u32; 3]> = corners.iter().map(|&(a, b, c)| [a, (a + b) % 9, (a + c) % 9]).collect();
            for cycle in rims(&triangles) {
                let distinct: BTreeSet<u32> = cycle.iter().copied().collect();
                prop_assert_eq!(distinct.len(), cycle.len());
            }
        }
    }
}
