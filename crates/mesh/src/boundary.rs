//! The rims of a surface.

use std::cmp::Reverse;
use std::collections::{BTreeSet, HashMap};

use crate::Topology;

/// See [`Topology::boundary_loops`].
pub(crate) fn loops(surface: &Topology) -> Vec<Vec<u32>> {
    let mut rim = Rim::of(surface);
    let mut loops = Vec::new();
    while let Some(side) = rim.open.pop_first() {
        rim.walk(side, &mut loops);
    }
    loops.sort_by_key(|cycle: &Vec<u32>| (Reverse(cycle.len()), cycle.iter().min().copied()));
    loops
}

/// The sides that bound a surface, and how its triangles lie around a vertex.
struct Rim<'a> {
    surface: &'a Topology,
    /// The corner that the triangle on the left of a directed side has beside it.
    third: HashMap<[u32; 2], u32>,
    /// Directed sides of one triangle only, the surface on their left, that are in no loop yet.
    open: BTreeSet<[u32; 2]>,
}

impl<'a> Rim<'a> {
    fn of(surface: &'a Topology) -> Self {
        let mut uses: HashMap<[u32; 2], usize> = HashMap::new();
        let mut third = HashMap::new();
        for [from, to, beside] in corners(surface.triangles()) {
            *uses.entry([from.min(to), from.max(to)]).or_default() += 1;
            third.insert([from, to], beside);
        }
        let single = |&[from, to, _]: &[u32; 3]| uses[&[from.min(to), from.max(to)]] == 1;
        let open = corners(surface.triangles()).filter(single).map(|[from, to, _]| [from, to]).collect();
        Self { surface, third, open }
    }

    /// Follows the rim from a side as far as it goes. What comes back to a vertex of the way is a loop of its own.
    fn walk(&mut self, side: [u32; 2], loops: &mut Vec<Vec<u32>>) {
        let mut way = vec![side[0]];
        let mut side = Some(side);
        while let Some([from, to]) = side {
            match way.iter().position(|&vertex| vertex == to) {
                Some(start) => {
                    loops.push(way[start..].to_vec());
                    way.truncate(start + 1);
                }
                None => way.push(to),
            }
            side = self.after([from, to]);
            side.iter().for_each(|next| _ = self.open.remove(next));
        }
        // The windings disagree somewhere, so that the rim breaks off.
        if way.len() > 1 {
            loops.push(way);
        }
    }

    /// The side that goes on behind another one: across the triangles that lie around the vertex between them, and
    /// where that way is gone, any that leaves the vertex.
    fn after(&self, [from, at]: [u32; 2]) -> Option<[u32; 2]> {
        let mut beside = self.third.get(&[from, at]).copied();
        for _ in 0..self.surface.degree(at) {
            let Some(to) = beside else { break };
            if self.open.contains(&[at, to]) {
                return Some([at, to]);
            }
            beside = self.third.get(&[to, at]).copied();
        }
        self.open.range([at, 0]..=[at, u32::MAX]).next().copied()
    }
}

/// Every triangle three times: each directed side with the corner that is not on it.
pub(crate) fn corners(triangles: &[[u32; 3]]) -> impl Iterator<Item = [u32; 3]> {
    triangles.iter().flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]])
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
    fn loops_that_touch_in_a_vertex_close_each_by_itself_whatever_the_vertices_are_called() {
        assert_eq!(rims(&[[0, 1, 4], [4, 2, 3]]), [[0, 1, 4], [2, 3, 4]]);
        assert_eq!(rims(&[[0, 1, 2], [0, 3, 4]]).iter().map(Vec::len).collect::<Vec<_>>(), [3, 3]);
        let three_fans = rims(&[[9, 0, 1], [9, 2, 3], [9, 4, 5], [9, 5, 6]]);
        assert_eq!(three_fans.iter().map(Vec::len).collect::<Vec<_>>(), [4, 3, 3]);
    }

    /// No loop passes through a vertex twice, and every single side is in exactly one.
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
        /// Some of the triangles of a grid, which all wind alike: islands, holes, and corners that touch.
        #[test]
        fn every_piece_of_a_surface_has_simple_loops(kept in prop::collection::vec(any::<bool>(), 72), shift in 0..64u32) {
            let name = |column: u32, row: u32| (7 * row + column + shift) * 27 % 64;
            let cut = |(column, row): (u32, u32)| {
                let [a, b] = [name(column, row), name(column + 1, row)];
                let [d, c] = [name(column, row + 1), name(column + 1, row + 1)];
                [[a, b, c], [a, c, d]]
            };
            let grid = (0..6).flat_map(|row| (0..6).map(move |column| (column, row))).flat_map(cut);
            let triangles: Vec<[u32; 3]> = grid.zip(kept).filter(|(_, keep)| *keep).map(|(t, _)| t).collect();
            assert_simple_and_complete(&triangles);
        }

        /// Triangles that agree on nothing.
        #[test]
        fn no_loop_passes_through_a_vertex_twice_even_where_windings_disagree(
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
