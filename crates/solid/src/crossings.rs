//! Where a mesh goes through itself.

mod grid;
mod pair;

use glam::DVec3;

use grid::Grid;

/// Every pair of triangles that meet beside the corners and sides that they share, each pair once, `[low, high]`, sorted.
pub(crate) fn crossings(triangles: &[[u32; 3]], positions: &[DVec3]) -> Vec<[u32; 2]> {
    crossings_of(triangles, positions, |_| true)
}

/// Those of the pairs in which at least one of the two is asked for.
pub(crate) fn crossings_of(
    triangles: &[[u32; 3]],
    positions: &[DVec3],
    is_asked_for: impl Fn(u32) -> bool,
) -> Vec<[u32; 2]> {
    let grid = Grid::new(triangles, positions);
    let mut found = Vec::new();
    grid.near_pairs(is_asked_for, |one, other| {
        if pair::meet(positions, triangles[one as usize], triangles[other as usize]) {
            found.push([one.min(other), one.max(other)]);
        }
    });
    found.sort_unstable();
    found
}
