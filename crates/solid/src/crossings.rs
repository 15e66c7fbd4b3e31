//! Self-intersections of a mesh.

mod grid;
mod pair;

use glam::DVec3;

use grid::Grid;

/// Pairs of triangles that intersect outside their shared corners and edges: `[low, high]`, unique, sorted.
pub(crate) fn crossings(triangles: &[[u32; 3]], positions: &[DVec3]) -> Vec<[u32; 2]> {
    crossings_of(triangles, positions, |_| true)
}

/// The pairs of which at least one triangle satisfies `is_selected`.
pub(crate) fn crossings_of(
    triangles: &[[u32; 3]],
    positions: &[DVec3],
    is_selected: impl Fn(u32) -> bool,
) -> Vec<[u32; 2]> {
    let grid = Grid::new(triangles, positions);
    let mut found = Vec::new();
    grid.near_pairs(is_selected, |one, other| {
        if pair::intersect(positions, triangles[one as usize], triangles[other as usize]) {
            found.push([one.min(other), one.max(other)]);
        }
    });
    found.sort_unstable();
    found
}
