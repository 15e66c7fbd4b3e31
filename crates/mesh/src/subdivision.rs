use std::collections::HashMap;
use std::f64::consts::TAU;
use std::iter::Sum;
use std::ops::{Add, Mul, Sub};

use glam::DVec3;

use crate::Topology;
use crate::boundary::corners;
use crate::stencils::Stencils;

/// Loop's subdivision of a cage, as one sparse matrix that takes values on the cage to values on the dense mesh.
///
/// Each level cuts every triangle into four. Weights are Loop's own (1987): a new vertex takes ⅜ of its edge's ends and ⅛
/// of the two corners across; an old vertex of degree `d` keeps `1 − dβ` and takes `β = (⅝ − (⅜ + ¼cos 2π/d)²) / d` of
/// each neighbour. Along a boundary, along creases, and along edges where more than two triangles meet, only the curve
/// counts: ½ ½ for new vertices, ⅛ ¾ ⅛ for old ones (Hoppe et al. 1994). Where such curves end or cross, and at vertices
/// without triangles, vertices stay.
///
/// The cage's vertices keep their numbers; those that a level adds follow, in the order of [`Topology::edges`].
#[derive(Debug, Clone, PartialEq)]
pub struct LoopSubdivision {
    topology: Topology,
    creases: Vec<[u32; 2]>,
    stencils: Stencils,
    /// One over what each of the cage's vertices keeps of itself; 0 for those that are rounded off.
    inverse_own: Vec<f64>,
}

/// What can be subdivided: a number, a vector.
pub trait Value: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> + Sum {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T> + Sum> Value for T {}

impl LoopSubdivision {
    /// Subdivides `levels` times; 0 leaves the cage as it is.
    pub fn new(cage: &Topology, levels: u32) -> Self {
        Self::creased(cage, &[], levels)
    }

    /// The same with edges of the cage, in whatever order and direction, that part the surface as its boundary does: what is
    /// on one side of such a curve knows nothing of the other. What is no edge of the cage is passed over.
    pub fn creased(cage: &Topology, creases: &[[u32; 2]], levels: u32) -> Self {
        let mut creases: Vec<[u32; 2]> = creases.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        creases.retain(|crease| cage.edges().binary_search(crease).is_ok());
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

    /// The same with vertices of the cage that [`Self::interpolate`] rounds off, too: where many are near each other, a surface
    /// through them all would go through itself.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[must_use]
    pub fn rounding(mut self, vertices: &[u32]) -> Self {
        vertices.iter().for_each(|&vertex| self.inverse_own[vertex as usize] = 0.0);
        self
    }

    /// The edges of the dense mesh that its creases have become, each from its lower to its higher vertex, ascending.
    pub fn creases(&self) -> &[[u32; 2]] {
        &self.creases
    }

    /// The dense mesh.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// What a dense vertex is made of: vertices of the cage, ascending, and their weights, which sum to 1.
    ///
    /// # Panics
    /// If there is no such dense vertex.
    pub fn stencil(&self, vertex: u32) -> impl Iterator<Item = (u32, f64)> {
        self.stencils.row(vertex as usize)
    }

    /// The dense mesh's values (positions, texture coordinates, displacements …) from the cage's.
    ///
    /// # Panics
    /// If there is not one value for each vertex of the cage.
    pub fn apply<T: Value>(&self, cage: &[T]) -> Vec<T> {
        (0..self.topology.vertex_count()).map(|vertex| self.stencils.combine(vertex, cage)).collect()
    }

    /// The dense mesh's values that pass through the cage's: each of the cage's vertices has its own value there, too, where
    /// [`Self::apply`] rounds it off. They are those of another cage, the control cage. Meant for one level at a time, of which
    /// each passes through the one before; over several at once more of what is lacking stays.
    ///
    /// # Panics
    /// If there is not one value for each vertex of the cage.
    pub fn interpolate<T: Value>(&self, cage: &[T]) -> Vec<T> {
        let (mut control, mut dense) = (cage.to_vec(), self.apply(cage));
        self.interpolate_into(cage, &mut control, &mut dense);
        dense
    }

    /// As [`Self::interpolate`], into slices of the caller's; nothing is allocated. Of positions and displacements alone, so that
    /// the loop is compiled here and as quick as this crate is, whoever calls it.
    ///
    /// # Panics
    /// If there is not one value, and one place in the control cage, for each vertex of the cage, and one place for each dense
    /// vertex.
    pub fn interpolate_to(&self, cage: &[DVec3], control: &mut [DVec3], dense: &mut [DVec3]) {
        self.interpolate_into(cage, control, dense);
    }

    /// The control cage solves the square part of the matrix that takes the cage to itself. It is found by Gauss and Seidel's
    /// steps, each of which leaves some tenth of what is lacking, on meshes of low degrees a third.
    fn interpolate_into<T: Value>(&self, cage: &[T], control: &mut [T], dense: &mut [T]) {
        control.copy_from_slice(cage);
        for _ in 0..INTERPOLATING_STEPS {
            for (vertex, wanted) in cage.iter().enumerate() {
                let lacking = *wanted - self.stencils.combine(vertex, control);
                control[vertex] = match self.inverse_own[vertex] {
                    0.0 => *wanted - lacking * ROUNDED_FURTHER,
                    inverse_own => control[vertex] + lacking * inverse_own,
                };
            }
        }
        self.apply_to(control, dense);
        // What the steps have left.
        for ((dense, cage), _) in dense.iter_mut().zip(cage).zip(&self.inverse_own).filter(|(_, own)| **own > 0.0) {
            *dense = *cage;
        }
    }

    /// As [`Self::apply`], into a slice of the caller's; nothing is allocated.
    ///
    /// # Panics
    /// If there is not one value for each vertex of the cage, and one place for each dense vertex.
    pub fn apply_to<T: Value>(&self, cage: &[T], dense: &mut [T]) {
        assert_eq!(dense.len(), self.topology.vertex_count(), "one place for each dense vertex");
        dense.iter_mut().enumerate().for_each(|(vertex, value)| *value = self.stencils.combine(vertex, cage));
    }
}

/// Of what [`LoopSubdivision::apply`] rounds off a face, 10⁻¹⁰ is left.
const INTERPOLATING_STEPS: usize = 12;

/// So far a vertex that is rounded off gives way in the control cage, too, as a share of the way to where it is rounded off to.
const ROUNDED_FURTHER: f64 = 1.0 / 3.0;

/// The matrix of a single level.
fn one_level(mesh: &Topology, creases: &[[u32; 2]]) -> Stencils {
    let mut across = corners_across(mesh);
    creases.iter().for_each(|crease| _ = across.insert(*crease, Vec::new()));
    let is_crease = |edge: &[u32; 2]| across[edge].len() != 2;
    let mut curves = vec![Vec::new(); mesh.vertex_count()];
    for &[a, b] in mesh.edges().iter().filter(|edge| is_crease(edge)) {
        curves[a as usize].push(b);
        curves[b as usize].push(a);
    }
    let mut level = Stencils::new(mesh.vertex_count());
    for vertex in 0..mesh.vertex_count() as u32 {
        level.push(old_vertex(vertex, mesh.neighbours(vertex), &curves[vertex as usize]));
    }
    for edge in mesh.edges() {
        level.push(new_vertex(*edge, &across[edge]));
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

/// Loop's `β`: what an inner vertex of this degree takes of each neighbour.
fn loop_share(degree: usize) -> f64 {
    let degree = degree as f64;
    (0.625 - (0.375 + 0.25 * (TAU / degree).cos()).powi(2)) / degree
}

/// For each edge, the third corners of its triangles.
fn corners_across(mesh: &Topology) -> HashMap<[u32; 2], Vec<u32>> {
    let mut across: HashMap<[u32; 2], Vec<u32>> = HashMap::with_capacity(mesh.edges().len());
    for [from, to, third] in corners(mesh.triangles()) {
        across.entry([from.min(to), from.max(to)]).or_default().push(third);
    }
    across
}

/// The vertex that a level adds on an edge.
fn middle(mesh: &Topology, a: u32, b: u32) -> u32 {
    let edge = mesh.edges().binary_search(&[a.min(b), a.max(b)]);
    (mesh.vertex_count() + edge.expect("invariant: only edges are halved")) as u32
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

    /// A grid of unit squares on the plane, each cut along a diagonal.
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
    fn counts_grow_as_euler_says() {
        for cage in [tetrahedron().0, icosahedron().0, grid(4, 3).0] {
            let dense = LoopSubdivision::new(&cage, 1);
            let (v, e, f) = (cage.vertex_count(), cage.edges().len(), cage.triangles().len());
            assert_eq!(dense.topology().vertex_count(), v + e);
            assert_eq!(dense.topology().edges().len(), 2 * e + 3 * f);
            assert_eq!(dense.topology().triangles().len(), 4 * f);
        }
    }

    #[test]
    fn weights_sum_to_one_and_none_is_negative() {
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
    fn a_boundary_depends_on_the_boundary_alone() {
        let (cage, _) = grid(4, 3);
        let dense = LoopSubdivision::new(&cage, 2);
        let rim = &cage.boundary_loops()[0];
        for vertex in dense.topology().boundary_loops().concat() {
            assert!(dense.stencil(vertex).all(|(parent, _)| rim.contains(&parent)));
        }
    }

    #[test]
    fn what_interpolates_passes_through_the_cage_and_is_smooth_between() {
        for (mut cage, positions) in [icosahedron(), grid(5, 4)] {
            let mut places: Vec<DVec3> = positions.iter().map(|p| p.with_z(p.z + (p.x * 1.3).sin() * p.y)).collect();
            for _ in 0..3 {
                let dense = LoopSubdivision::new(&cage, 1);
                let through = dense.interpolate(&places);
                assert!(through.iter().zip(&places).all(|(a, b)| a == b));
                let mut control = places.clone();
                dense.interpolate_to(&places, &mut control, &mut through.clone());
                let off = dense.apply(&control).iter().zip(&through).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
                assert!(off < 1e-6, "{off}: it is no surface of Loop's");
                (cage, places) = (dense.topology().clone(), through);
            }
        }
    }

    #[test]
    fn what_is_rounded_off_is_where_loop_has_it_and_all_others_are_met() {
        let (cage, positions) = icosahedron();
        let dense = LoopSubdivision::new(&cage, 1).rounding(&[3, 7]);
        let through = dense.interpolate(&positions);
        for (vertex, place) in positions.iter().enumerate() {
            assert_eq!(through[vertex] == *place, ![3, 7].contains(&vertex), "{vertex}");
        }
        let all = LoopSubdivision::new(&cage, 1).rounding(&(0..12).collect::<Vec<_>>());
        let [rounded, rounded_further] = [all.apply(&positions), all.interpolate(&positions)];
        assert!(rounded_further.iter().zip(&rounded).all(|(further, rounded)| further.length() < rounded.length()));
    }

    #[test]
    fn a_crease_parts_the_surface_as_cutting_it_would() {
        // A grid, whole with a crease along its middle, and the half on the left of it alone.
        let (whole, positions) = grid(6, 3);
        let on_the_left = |corners: &&[u32; 3]| corners.iter().all(|corner| corner % 7 <= 3);
        let left = whole.triangles().iter().filter(on_the_left).copied().collect();
        let left = Topology::new(whole.vertex_count(), left).unwrap();
        let crease: Vec<[u32; 2]> = (0..3).map(|row| [(row + 1) * 7 + 3, row * 7 + 3]).collect();
        let bent: Vec<DVec3> = positions.iter().map(|p| p.with_z((p.x * 1.7).sin() * p.y)).collect();
        let (creased, cut) = (LoopSubdivision::creased(&whole, &crease, 1), LoopSubdivision::new(&left, 1));
        let dense = [&creased, &cut].map(|dense| dense.apply(&bent));
        // Where the crease meets the rim, three curves do in one surface and two in the other.
        let ends = [3, 24];
        let places = |dense: &LoopSubdivision, at: &[DVec3]| -> Vec<[DVec3; 3]> {
            let away = |corners: &&[u32; 3]| !ends.iter().any(|end| corners.contains(end));
            dense.topology().triangles().iter().filter(away).map(|t| t.map(|corner| at[corner as usize])).collect()
        };
        let [parted, alone] = [places(&creased, &dense[0]), places(&cut, &dense[1])];
        assert!(alone.iter().all(|triangle| parted.contains(triangle)), "the left half is another surface");
        assert_eq!(creased.creases().len(), 6);
        let twice = LoopSubdivision::creased(creased.topology(), creased.creases(), 1);
        assert_eq!(twice.topology(), LoopSubdivision::creased(&whole, &crease, 2).topology());
        assert_eq!(twice.creases(), LoopSubdivision::creased(&whole, &crease, 2).creases());
    }

    #[test]
    fn a_regular_plane_stays_where_it_is_inside() {
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
    fn edges_of_three_triangles_and_lone_vertices_are_taken_in_stride() {
        let book = Topology::new(6, vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]]).unwrap();
        let dense = LoopSubdivision::new(&book, 2);
        assert_eq!(dense.stencil(5).collect::<Vec<_>>(), [(5, 1.0)]);
        assert_eq!(dense.stencil(0).collect::<Vec<_>>(), [(0, 1.0)]);
    }

    proptest! {
        #[test]
        fn subdividing_commutes_with_affine_maps(
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
