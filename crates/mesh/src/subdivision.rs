use std::f64::consts::TAU;
use std::iter::Sum;
use std::ops::{Add, Mul, Sub};

use glam::DVec3;

use crate::Topology;
use crate::stencils::Stencils;
use crate::topology::{corners, edge};

/// Loop subdivision of a cage, as a sparse matrix from values on the cage to values on the dense mesh.
///
/// Each level splits triangles into four, with Loop's weights (1987). A new vertex takes ⅜ of each end of its edge and
/// ⅛ of each opposite corner. An old vertex of degree `d` has weight `1 − dβ`, and each neighbour
/// `β = (⅝ − (⅜ + ¼cos 2π/d)²) / d`. Boundaries, creases, and edges of more than two triangles are subdivided as
/// curves, with weights ½ ½ for new vertices and ⅛ ¾ ⅛ for old ones (Hoppe et al. 1994). Vertices where such curves end
/// or cross, and vertices without triangles, do not move.
///
/// Cage vertices keep their indices. Each level appends its new vertices in the order of [`Topology::edges`].
#[derive(Debug, Clone, PartialEq)]
pub struct LoopSubdivision {
    topology: Topology,
    creases: Vec<[u32; 2]>,
    stencils: Stencils,
    /// Inverse of each cage vertex's own weight in its stencil; 0 for smoothed vertices, see [`Self::rounding`].
    inverse_own: Vec<f64>,
}

/// A value that can be subdivided, such as a number or a vector.
pub trait Value: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> + Sum {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T> + Sum> Value for T {}

impl LoopSubdivision {
    /// Subdivides `levels` times; 0 returns the cage.
    pub fn new(cage: &Topology, levels: u32) -> Self {
        Self::creased(cage, &[], levels)
    }

    /// Subdivides with creases, edges of the cage in any order and direction. A crease separates the surface as a
    /// boundary does: vertices on one side do not affect the other. Pairs that are not edges of the cage are ignored.
    pub fn creased(cage: &Topology, creases: &[[u32; 2]], levels: u32) -> Self {
        let mut creases: Vec<[u32; 2]> = creases.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        creases.retain(|&[a, b]| cage.edge(a, b).is_some());
        creases.sort_unstable();
        let stencils = Stencils::identity(cage.vertex_count());
        let mut dense = Self { topology: cage.clone(), creases, stencils, inverse_own: Vec::new() };
        for _ in 0..levels {
            let step = one_level(&dense.topology, &dense.creases);
            dense.stencils = step.after(&dense.stencils);
            dense.creases = split_edges(&dense.topology, &dense.creases);
            dense.topology = split_triangles(&dense.topology);
        }
        let own = |vertex: u32| dense.stencil(vertex).find(|(parent, _)| *parent == vertex).map_or(1.0, |(_, own)| own);
        dense.inverse_own = (0..cage.vertex_count() as u32).map(|vertex| own(vertex).recip()).collect();
        dense
    }

    /// Makes [`Self::interpolate`] smooth these cage vertices instead of interpolating them. An interpolating surface
    /// would intersect itself where many vertices are close together.
    ///
    /// # Panics
    /// If a vertex is not in the cage.
    #[must_use]
    pub fn rounding(mut self, vertices: &[u32]) -> Self {
        vertices.iter().for_each(|&vertex| self.inverse_own[vertex as usize] = 0.0);
        self
    }

    /// The creases of the dense mesh as sorted edges `[low, high]`.
    pub fn creases(&self) -> &[[u32; 2]] {
        &self.creases
    }

    /// The dense mesh.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// The weights of a dense vertex's cage vertices, in ascending order; they sum to 1.
    ///
    /// # Panics
    /// If `vertex` is not in the dense mesh.
    pub fn stencil(&self, vertex: u32) -> impl Iterator<Item = (u32, f64)> {
        self.stencils.row(vertex as usize)
    }

    /// Returns the dense mesh's values (positions, texture coordinates, displacements) for the cage's values.
    ///
    /// # Panics
    /// If the numbers of values and cage vertices differ.
    pub fn apply<T: Value>(&self, cage: &[T]) -> Vec<T> {
        (0..self.topology.vertex_count()).map(|vertex| self.stencils.combine(vertex, cage)).collect()
    }

    /// Returns dense values that interpolate the cage's values, which [`Self::apply`] smooths. They are the subdivision
    /// of another cage, the control cage.
    ///
    /// Meant for one level at a time, each interpolating the previous one: the residual of the control cage is larger
    /// over several levels.
    ///
    /// # Panics
    /// If the numbers of values and cage vertices differ.
    pub fn interpolate<T: Value>(&self, cage: &[T]) -> Vec<T> {
        let (mut control, mut dense) = (cage.to_vec(), self.apply(cage));
        self.interpolate_into(cage, &mut control, &mut dense);
        dense
    }

    /// [`Self::interpolate`] into the caller's slices, without allocation. Not generic, so that the loop is compiled in
    /// this crate with its optimisation level.
    ///
    /// # Panics
    /// If the lengths of `cage` and `control` are not the number of cage vertices, or that of `dense` the number of
    /// dense vertices.
    pub fn interpolate_to(&self, cage: &[DVec3], control: &mut [DVec3], dense: &mut [DVec3]) {
        self.interpolate_into(cage, control, dense);
    }

    /// Solves for the control cage by Gauss–Seidel iteration on the square block that maps the cage to itself. Each
    /// iteration reduces the residual to about a tenth, and to a third on meshes of low degree.
    fn interpolate_into<T: Value>(&self, cage: &[T], control: &mut [T], dense: &mut [T]) {
        control.copy_from_slice(cage);
        for _ in 0..INTERPOLATION_ITERATIONS {
            for (vertex, target) in cage.iter().enumerate() {
                let residual = *target - self.stencils.combine(vertex, control);
                control[vertex] = match self.inverse_own[vertex] {
                    0.0 => *target - residual * ROUNDING_SHIFT,
                    inverse_own => control[vertex] + residual * inverse_own,
                };
            }
        }
        self.apply_to(control, dense);
        // Remove the remaining residual.
        for ((dense, cage), _) in dense.iter_mut().zip(cage).zip(&self.inverse_own).filter(|(_, own)| **own > 0.0) {
            *dense = *cage;
        }
    }

    /// [`Self::apply`] into the caller's slice, without allocation.
    ///
    /// # Panics
    /// If the length of `cage` is not the number of cage vertices, or that of `dense` the number of dense vertices.
    pub fn apply_to<T: Value>(&self, cage: &[T], dense: &mut [T]) {
        assert_eq!(dense.len(), self.topology.vertex_count(), "one value per dense vertex");
        dense.iter_mut().enumerate().for_each(|(vertex, value)| *value = self.stencils.combine(vertex, cage));
    }
}

/// Number of Gauss–Seidel iterations; reduces the residual on a face by a factor of 10¹⁰.
const INTERPOLATION_ITERATIONS: usize = 12;

/// Shift of a smoothed vertex in the control cage, as a fraction of its displacement by smoothing.
const ROUNDING_SHIFT: f64 = 1.0 / 3.0;

/// The matrix of one level.
fn one_level(mesh: &Topology, creases: &[[u32; 2]]) -> Stencils {
    let mut across = corners_across(mesh);
    creases.iter().filter_map(|&[a, b]| mesh.edge(a, b)).for_each(|edge| across[edge].clear());
    let mut curves = vec![Vec::new(); mesh.vertex_count()];
    for (&[a, b], _) in mesh.edges().iter().zip(&across).filter(|(_, across)| across.len() != 2) {
        curves[a as usize].push(b);
        curves[b as usize].push(a);
    }
    let mut level = Stencils::new(mesh.vertex_count());
    for vertex in 0..mesh.vertex_count() as u32 {
        level.push(old_vertex(vertex, mesh.neighbours(vertex), &curves[vertex as usize]));
    }
    for (edge, across) in mesh.edges().iter().zip(&across) {
        level.push(new_vertex(*edge, across));
    }
    level
}

fn old_vertex(vertex: u32, neighbours: &[u32], curve: &[u32]) -> Vec<(u32, f64)> {
    match (neighbours.len(), curve) {
        (0, _) => vec![(vertex, 1.0)],
        (degree, []) => {
            let share = loop_share(degree);
            let around = neighbours.iter().map(|&neighbour| (neighbour, share));
            around.chain([(vertex, 1.0 - degree as f64 * share)]).collect()
        }
        (_, &[before, after]) => vec![(before, 0.125), (vertex, 0.75), (after, 0.125)],
        _ => vec![(vertex, 1.0)],
    }
}

fn new_vertex([a, b]: [u32; 2], across: &[u32]) -> Vec<(u32, f64)> {
    match *across {
        [left, right] => vec![(a, 0.375), (b, 0.375), (left, 0.125), (right, 0.125)],
        _ => vec![(a, 0.5), (b, 0.5)],
    }
}

/// Loop's `β`: the weight of each neighbour of an inner vertex.
fn loop_share(degree: usize) -> f64 {
    let degree = degree as f64;
    (0.625 - (0.375 + 0.25 * (TAU / degree).cos()).powi(2)) / degree
}

/// For each edge, the opposite corners of its triangles.
fn corners_across(mesh: &Topology) -> Vec<Vec<u32>> {
    let mut across = vec![Vec::new(); mesh.edges().len()];
    for [from, to, third] in corners(mesh.triangles()) {
        across[edge(mesh, from, to)].push(third);
    }
    across
}

/// The new vertex on an edge.
fn middle(mesh: &Topology, a: u32, b: u32) -> u32 {
    (mesh.vertex_count() + edge(mesh, a, b)) as u32
}

fn split_edges(mesh: &Topology, edges: &[[u32; 2]]) -> Vec<[u32; 2]> {
    let halves = |&[a, b]: &[u32; 2]| [a, b].map(|end| [end, middle(mesh, a, b)]);
    let mut split: Vec<[u32; 2]> = edges.iter().flat_map(halves).collect();
    split.sort_unstable();
    split
}

fn split_triangles(mesh: &Topology) -> Topology {
    let four = |&[a, b, c]: &[u32; 3]| {
        let [ab, bc, ca] = [middle(mesh, a, b), middle(mesh, b, c), middle(mesh, c, a)];
        [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
    };
    let triangles = mesh.triangles().iter().flat_map(four).collect();
    Topology::new(mesh.vertex_count() + mesh.edges().len(), triangles)
        .expect("invariant: the quarters of a triangle are triangles")
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};
    use proptest::prelude::*;

    use super::*;
    use crate::shapes::{icosahedron, tetrahedron};

    /// A planar grid of unit squares, each split along a diagonal.
    fn grid(columns: u32, rows: u32) -> (Topology, Vec<DVec3>) {
        let at = |column: u32, row: u32| row * (columns + 1) + column;
        let cut = |(c, r): (u32, u32)| {
            [[at(c, r), at(c + 1, r), at(c + 1, r + 1)], [at(c, r), at(c + 1, r + 1), at(c, r + 1)]]
        };
        let squares = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        let corner = |v: u32| DVec3::new(f64::from(v % (columns + 1)), f64::from(v / (columns + 1)), 0.0);
        let count = (columns + 1) * (rows + 1);
        (Topology::new(count as usize, squares.flat_map(cut).collect()).unwrap(), (0..count).map(corner).collect())
    }

    #[test]
    fn counts_per_level() {
        for cage in [tetrahedron().0, icosahedron().0, grid(4, 3).0] {
            let dense = LoopSubdivision::new(&cage, 1);
            let (v, e, f) = (cage.vertex_count(), cage.edges().len(), cage.triangles().len());
            assert_eq!(dense.topology().vertex_count(), v + e);
            assert_eq!(dense.topology().edges().len(), 2 * e + 3 * f);
            assert_eq!(dense.topology().triangles().len(), 4 * f);
        }
    }

    #[test]
    fn weights_are_non_negative_and_sum_to_one() {
        for cage in [tetrahedron().0, icosahedron().0, grid(4, 3).0, Topology::new(5, vec![[0, 1, 2]]).unwrap()] {
            let dense = LoopSubdivision::new(&cage, 3);
            for vertex in 0..dense.topology().vertex_count() as u32 {
                let sum: f64 = dense.stencil(vertex).map(|(_, weight)| weight).sum();
                assert!((sum - 1.0).abs() < 1e-14);
                assert!(dense.stencil(vertex).all(|(_, weight)| weight >= 0.0));
            }
        }
    }

    #[test]
    fn levels_compose() {
        let (cage, positions) = icosahedron();
        let first = LoopSubdivision::new(&cage, 1);
        let second = LoopSubdivision::new(first.topology(), 1);
        let both = LoopSubdivision::new(&cage, 2);
        assert_eq!(second.topology(), both.topology());
        let step_by_step = second.apply(&first.apply(&positions));
        assert!(both.apply(&positions).iter().zip(step_by_step).all(|(a, b)| a.distance(b) < 1e-14));
    }

    #[test]
    fn boundary_vertices_depend_only_on_the_boundary() {
        let (cage, _) = grid(4, 3);
        let dense = LoopSubdivision::new(&cage, 2);
        let rim = &cage.boundary_loops()[0];
        for vertex in dense.topology().boundary_loops().concat() {
            assert!(dense.stencil(vertex).all(|(parent, _)| rim.contains(&parent)));
        }
    }

    #[test]
    fn interpolation_passes_through_the_cage_and_is_a_loop_surface() {
        for (mut cage, positions) in [icosahedron(), grid(5, 4)] {
            let mut values: Vec<DVec3> = positions.iter().map(|p| p.with_z(p.z + (p.x * 1.3).sin() * p.y)).collect();
            for _ in 0..3 {
                let dense = LoopSubdivision::new(&cage, 1);
                let through = dense.interpolate(&values);
                assert!(through.iter().zip(&values).all(|(a, b)| a == b));
                let mut control = values.clone();
                dense.interpolate_to(&values, &mut control, &mut through.clone());
                let off = dense.apply(&control).iter().zip(&through).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
                assert!(off < 1e-6, "not the subdivision of the control cage: off by {off}");
                (cage, values) = (dense.topology().clone(), through);
            }
        }
    }

    #[test]
    fn rounded_vertices_are_smoothed_and_the_others_interpolated() {
        let (cage, positions) = icosahedron();
        let dense = LoopSubdivision::new(&cage, 1).rounding(&[3, 7]);
        let through = dense.interpolate(&positions);
        for (vertex, position) in positions.iter().enumerate() {
            assert_eq!(through[vertex] == *position, ![3, 7].contains(&vertex), "{vertex}");
        }
        let all = LoopSubdivision::new(&cage, 1).rounding(&(0..12).collect::<Vec<_>>());
        let [rounded, interpolated] = [all.apply(&positions), all.interpolate(&positions)];
        assert!(
            interpolated.iter().zip(&rounded).all(|(interpolated, rounded)| interpolated.length() < rounded.length())
        );
    }

    #[test]
    fn a_crease_is_equivalent_to_a_cut() {
        // A grid with a crease along its middle, and its left half alone.
        let (whole, positions) = grid(6, 3);
        let on_the_left = |corners: &&[u32; 3]| corners.iter().all(|corner| corner % 7 <= 3);
        let left = whole.triangles().iter().filter(on_the_left).copied().collect();
        let left = Topology::new(whole.vertex_count(), left).unwrap();
        let crease: Vec<[u32; 2]> = (0..3).map(|row| [(row + 1) * 7 + 3, row * 7 + 3]).collect();
        let bent: Vec<DVec3> = positions.iter().map(|p| p.with_z((p.x * 1.7).sin() * p.y)).collect();
        let (creased, cut) = (LoopSubdivision::creased(&whole, &crease, 1), LoopSubdivision::new(&left, 1));
        let dense = [&creased, &cut].map(|dense| dense.apply(&bent));
        // At the ends of the crease three curves meet on the whole grid, but two on the half.
        let ends = [3, 24];
        let triangle_positions = |dense: &LoopSubdivision, at: &[DVec3]| -> Vec<[DVec3; 3]> {
            let away = |corners: &&[u32; 3]| !ends.iter().any(|end| corners.contains(end));
            dense.topology().triangles().iter().filter(away).map(|t| t.map(|corner| at[corner as usize])).collect()
        };
        let [separated, alone] = [triangle_positions(&creased, &dense[0]), triangle_positions(&cut, &dense[1])];
        assert!(alone.iter().all(|triangle| separated.contains(triangle)), "the left half differs");
        assert_eq!(creased.creases().len(), 6);
        let twice = LoopSubdivision::creased(creased.topology(), creased.creases(), 1);
        assert_eq!(twice.topology(), LoopSubdivision::creased(&whole, &crease, 2).topology());
        assert_eq!(twice.creases(), LoopSubdivision::creased(&whole, &crease, 2).creases());
    }

    #[test]
    fn inner_vertices_of_a_regular_plane_stay() {
        let (cage, positions) = grid(8, 8);
        let dense = LoopSubdivision::new(&cage, 1);
        let moved = dense.apply(&positions);
        let centre = 4 * 9 + 4;
        assert!(moved[centre].distance(positions[centre]) < 1e-14);
    }

    #[test]
    fn symmetric_cages_give_symmetric_solids() {
        let (cage, positions) = icosahedron();
        let radii: Vec<f64> =
            LoopSubdivision::new(&cage, 2).apply(&positions)[..12].iter().map(|p| p.length()).collect();
        assert!(radii.iter().all(|radius| (radius - radii[0]).abs() < 1e-14 && *radius < 1.0));
    }

    #[test]
    fn non_manifold_edges_and_isolated_vertices_are_supported() {
        let book = Topology::new(6, vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]]).unwrap();
        let dense = LoopSubdivision::new(&book, 2);
        assert_eq!(dense.stencil(5).collect::<Vec<_>>(), [(5, 1.0)]);
        assert_eq!(dense.stencil(0).collect::<Vec<_>>(), [(0, 1.0)]);
    }

    proptest! {
        #[test]
        fn subdivision_commutes_with_affine_maps(
            columns in prop::array::uniform9(-2.0..2.0f64), shift in prop::array::uniform3(-9.0..9.0f64), levels in 0..4u32,
        ) {
            let map = |p: DVec3| DMat3::from_cols_array(&columns) * p + DVec3::from(shift);
            let (cage, positions) = icosahedron();
            let dense = LoopSubdivision::new(&cage, levels);
            let mapped: Vec<DVec3> = positions.iter().copied().map(map).collect();
            for (before, after) in dense.apply(&positions).into_iter().zip(dense.apply(&mapped)) {
                prop_assert!(map(before).distance(after) < 1e-12);
            }
        }
    }
}
