use glam::DVec3;
use nalgebra_sparse::CsrMatrix;
use rosto_mesh::Topology;

use crate::constraints::mask;
use crate::dirichlet::Dirichlet;
use crate::factor::Scratch;
use crate::gauge_fixed::gauge_fixed;
use crate::operator::laplacian_matrix;
use crate::{ConstraintKind, LaplacianError, Operator, weights};

/// Extends values from fixed vertices to all vertices by minimising `‖K x‖²`. Factored once for any values.
///
/// With [`Operator::CotangentMass`] the extension is biharmonic, a thin plate: two layers of fixed vertices prescribe
/// value and slope.
pub struct Continuation {
    form: Dirichlet,
    vertices: usize,
    known: usize,
    scratch: Scratch,
}

/// Maximum number of columns of [`Continuation::continued`].
const MAX_COLUMNS: usize = 3;

impl Continuation {
    /// Factors the system with hard constraints at the vertices `known`. `positions` in any unit.
    ///
    /// # Errors
    /// [`LaplacianError::NoSuchVertex`], [`LaplacianError::Repeated`], [`LaplacianError::Unanchored`] for a component
    /// of the mesh without a known vertex, and the errors of [`Operator::matrix`] for invalid positions.
    pub fn new(
        topology: &Topology,
        positions: &[DVec3],
        operator: Operator,
        known: &[u32],
    ) -> Result<Self, LaplacianError> {
        let operator = operator.matrix(topology, positions)?;
        Self::minimising(&(operator.transpose() * &operator), topology, known)
    }

    /// A thin plate under tension (Schweikert 1966): minimises `∫ (Δx)² + t‖∇x‖²` for a tension `t` per vertex, in the
    /// reciprocal squared unit of `positions`. The plate is hinged at the vertices of `hinged`: it can bend there at no
    /// cost, so that slopes do not continue across known ones.
    ///
    /// Over lengths beyond `1/√t` the extension resists slopes. Under a varying tension it is level at high
    /// tension and changes at low tension. Without tension and hinges it is that of [`Operator::CotangentMass`].
    ///
    /// # Errors
    /// [`LaplacianError::Tension`] for a negative or non-finite tension, [`LaplacianError::BadlyScaled`] if neither
    /// bending nor tension determines a value, and the errors of [`Self::new`].
    pub fn under_tension(
        topology: &Topology,
        positions: &[DVec3],
        tension: &[f64],
        hinged: &[u32],
        known: &[u32],
    ) -> Result<Self, LaplacianError> {
        let mut plate = Operator::CotangentMass.matrix(topology, positions)?;
        check_tension(topology, tension)?;
        mask(hinged, topology.vertex_count())?;
        hinged.iter().for_each(|&vertex| plate.row_mut(vertex as usize).values_mut().fill(0.0));
        // The plate's masses are divided by their mean.
        let mean_mass = weights::mean_mass(topology, positions);
        let membrane = laplacian_matrix(topology, &weights::scaled_cotangent(topology, positions, tension));
        Self::minimising(&(plate.transpose() * &plate + membrane * mean_mass), topology, known)
    }

    fn minimising(form: &CsrMatrix<f64>, topology: &Topology, known: &[u32]) -> Result<Self, LaplacianError> {
        let component = topology.components();
        check(known, &component)?;
        let form = Dirichlet::new(&gauge_fixed(form, &component), &component, known, ConstraintKind::Hard)?;
        let (vertices, scratch) = (component.len(), form.factor.scratch(MAX_COLUMNS));
        Ok(Self { form, vertices, known: known.len(), scratch })
    }

    /// Writes one value per vertex to `out`, from one value per known vertex in the order of [`Self::new`], without an
    /// allocation. One, two or three columns of values, one after the other, are extended at once, which is faster than
    /// one by one.
    ///
    /// # Panics
    /// If the lengths of `known` and `out` are not the numbers of known vertices and of vertices, times the columns.
    pub fn continued(&mut self, known: &[f64], out: &mut [f64]) {
        let columns = known.len() / self.known;
        assert!((1..=MAX_COLUMNS).contains(&columns), "1 to {MAX_COLUMNS} columns, got {columns}");
        let lengths = [columns * self.known, columns * self.vertices];
        assert_eq!([known.len(), out.len()], lengths, "one value for each known vertex and each vertex");
        self.form.minimise(None, known, out, &mut self.scratch);
    }
}

fn check(known: &[u32], component: &[u32]) -> Result<(), LaplacianError> {
    mask(known, component.len())?;
    let mut is_known = vec![false; component.len()];
    known.iter().for_each(|&vertex| is_known[component[vertex as usize] as usize] = true);
    match component.iter().find(|&&piece| !is_known[piece as usize]) {
        Some(&handle) => Err(LaplacianError::Unanchored { handle }),
        None => Ok(()),
    }
}

fn check_tension(topology: &Topology, tension: &[f64]) -> Result<(), LaplacianError> {
    let (expected, found) = (topology.vertex_count(), tension.len());
    if expected != found {
        return Err(LaplacianError::LengthMismatch { expected, found });
    }
    match tension.iter().find(|tension| !(**tension >= 0.0 && tension.is_finite())) {
        Some(&tension) => Err(LaplacianError::Tension { tension }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: u32 = 12;

    /// A square grid of 12 × 12 vertices with spacing 1.
    fn plane() -> (Topology, Vec<DVec3>) {
        let at = |x: u32, y: u32| y * SIDE + x;
        let cells = (0..SIDE - 1).flat_map(|y| (0..SIDE - 1).map(move |x| (x, y)));
        let triangles = cells.flat_map(|(x, y)| {
            [[at(x, y), at(x + 1, y), at(x + 1, y + 1)], [at(x, y), at(x + 1, y + 1), at(x, y + 1)]]
        });
        let positions = (0..SIDE * SIDE).map(|i| DVec3::new(f64::from(i % SIDE), f64::from(i / SIDE), 0.0)).collect();
        (Topology::new((SIDE * SIDE) as usize, triangles.collect()).unwrap(), positions)
    }

    fn rim(layers: u32) -> Vec<u32> {
        let inside = layers..SIDE - layers;
        (0..SIDE * SIDE).filter(|i| !(inside.contains(&(i % SIDE)) && inside.contains(&(i / SIDE)))).collect()
    }

    #[test]
    fn a_linear_function_on_two_boundary_layers_extends_linearly() {
        let (topology, positions) = plane();
        let known = rim(2);
        let mut continuation = Continuation::new(&topology, &positions, Operator::CotangentMass, &known).unwrap();
        let slope = |vertex: u32| {
            let at = positions[vertex as usize];
            3.0 + 0.5 * at.x - 0.25 * at.y
        };
        let values: Vec<f64> = known.iter().map(|&vertex| slope(vertex)).collect();
        let mut out = vec![0.0; positions.len()];
        continuation.continued(&values, &mut out);
        for vertex in 0..SIDE * SIDE {
            assert!((out[vertex as usize] - slope(vertex)).abs() < 1e-9, "{vertex}: {}", out[vertex as usize]);
        }
    }

    #[test]
    fn known_values_are_exact_and_the_extension_is_linear() {
        let (topology, positions) = plane();
        let mut known = rim(2);
        known.push(5 * SIDE + 6);
        let mut continuation = Continuation::new(&topology, &positions, Operator::CotangentMass, &known).unwrap();
        let mut values = vec![0.0; known.len()];
        let (mut once, mut twice) = (vec![0.0; positions.len()], vec![0.0; positions.len()]);
        values[known.len() - 1] = 1.3;
        continuation.continued(&values, &mut once);
        values[known.len() - 1] = 2.6;
        continuation.continued(&values, &mut twice);
        assert_eq!(once[(5 * SIDE + 6) as usize], 1.3);
        assert!(once.iter().zip(&twice).all(|(one, two)| (2.0 * one - two).abs() < 1e-12));
        assert!(once[(5 * SIDE + 5) as usize] > 0.5, "a neighbour follows: {}", once[(5 * SIDE + 5) as usize]);
    }

    #[test]
    fn columns_extend_as_they_do_one_by_one() {
        let (topology, positions) = plane();
        let known = rim(2);
        let mut continuation = Continuation::new(&topology, &positions, Operator::CotangentMass, &known).unwrap();
        let values: Vec<f64> = (0..3 * known.len()).map(|i| (i * 37 % 11) as f64).collect();
        let mut together = vec![0.0; 3 * positions.len()];
        continuation.continued(&values, &mut together);
        for (values, expected) in values.chunks(known.len()).zip(together.chunks(positions.len())) {
            let mut out = vec![0.0; positions.len()];
            continuation.continued(values, &mut out);
            assert!(out.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-12));
        }
    }

    #[test]
    fn without_tension_the_extension_is_biharmonic() {
        let (topology, positions) = plane();
        let known: Vec<u32> = rim(2).into_iter().chain([5 * SIDE + 6]).collect();
        let values: Vec<f64> = known.iter().map(|&vertex| f64::from(vertex * 37 % 11)).collect();
        let of = |mut continuation: Continuation| {
            let mut out = vec![0.0; positions.len()];
            continuation.continued(&values, &mut out);
            out
        };
        let plate = of(Continuation::new(&topology, &positions, Operator::CotangentMass, &known).unwrap());
        let slack = of(Continuation::under_tension(&topology, &positions, &[0.0; 144], &[], &known).unwrap());
        assert!(plate.iter().zip(&slack).all(|(plate, slack)| (plate - slack).abs() < 1e-12));
    }

    /// From 0 on the left to 1 on the right: values and units, and tension on the left half only.
    fn across(tension: f64, unit: f64) -> Vec<f64> {
        let (topology, mut positions) = plane();
        positions.iter_mut().for_each(|position| *position *= unit);
        let column = |vertex: u32| vertex % SIDE;
        let known: Vec<u32> = (0..SIDE * SIDE).filter(|&v| !(2..SIDE - 2).contains(&column(v))).collect();
        let values: Vec<f64> = known.iter().map(|&v| if column(v) < 2 { 0.0 } else { 1.0 }).collect();
        let tension: Vec<f64> =
            (0..SIDE * SIDE).map(|v| if column(v) < SIDE / 2 { tension / (unit * unit) } else { 0.0 }).collect();
        let mut out = vec![0.0; positions.len()];
        let mut continuation = Continuation::under_tension(&topology, &positions, &tension, &[], &known).unwrap();
        continuation.continued(&values, &mut out);
        out
    }

    #[test]
    fn the_change_goes_to_vertices_without_tension() {
        let middle = (SIDE / 2 * SIDE + SIDE / 2) as usize;
        let changes: Vec<f64> = [0.0, 0.3, 3.0, 30.0].map(|tension| across(tension, 1.0)[middle]).to_vec();
        assert!(changes.is_sorted_by(|low, high| low > high), "{changes:?}");
        assert!(changes[0] > 0.4 && changes[3] < 0.1, "{changes:?}");
    }

    #[test]
    fn tension_has_the_reciprocal_squared_unit_of_the_positions() {
        let (metres, millimetres) = (across(3.0, 0.001), across(3.0, 1.0));
        assert!(metres.iter().zip(&millimetres).all(|(one, other)| (one - other).abs() < 1e-9));
    }

    #[test]
    fn a_linear_function_extends_linearly_under_a_uniform_tension() {
        let (topology, positions) = plane();
        let known = rim(2);
        let mut continuation = Continuation::under_tension(&topology, &positions, &[2.5; 144], &[], &known).unwrap();
        let slope = |vertex: u32| positions[vertex as usize].dot(DVec3::new(0.5, -0.25, 0.0));
        let mut out = vec![0.0; positions.len()];
        continuation.continued(&known.iter().map(|&vertex| slope(vertex)).collect::<Vec<_>>(), &mut out);
        assert!((0..SIDE * SIDE).all(|vertex| (out[vertex as usize] - slope(vertex)).abs() < 1e-9));
    }

    /// Four columns on the left are known, with a slope up to the last; two on the right are zero.
    #[test]
    fn a_slope_does_not_continue_across_hinges() {
        let (topology, positions) = plane();
        let column = |vertex: u32| vertex % SIDE;
        let known: Vec<u32> = (0..SIDE * SIDE).filter(|&v| !(4..SIDE - 2).contains(&column(v))).collect();
        let values: Vec<f64> = known.iter().map(|&v| if column(v) < 4 { f64::from(column(v)) } else { 0.0 }).collect();
        let rim: Vec<u32> = known.iter().copied().filter(|&v| column(v) == 3).collect();
        let next = |hinged: &[u32]| {
            let mut out = vec![0.0; positions.len()];
            let tension = [0.0; 144];
            let mut continuation =
                Continuation::under_tension(&topology, &positions, &tension, hinged, &known).unwrap();
            continuation.continued(&values, &mut out);
            out[(SIDE / 2 * SIDE + 4) as usize]
        };
        assert!(next(&[]) > 3.0, "it overshoots: {}", next(&[]));
        assert!(next(&rim) < 3.0, "it falls: {}", next(&rim));
    }

    #[test]
    fn invalid_tensions_are_rejected() {
        let (topology, positions) = plane();
        let of = |tension: &[f64]| Continuation::under_tension(&topology, &positions, tension, &[], &rim(2)).err();
        assert_eq!(of(&[1.0]), Some(LaplacianError::LengthMismatch { expected: 144, found: 1 }));
        assert_eq!(of(&[-1.0; 144]), Some(LaplacianError::Tension { tension: -1.0 }));
        assert!(matches!(of(&[f64::NAN; 144]), Some(LaplacianError::Tension { .. })));
        assert_eq!(of(&[f64::INFINITY; 144]), Some(LaplacianError::Tension { tension: f64::INFINITY }));
    }

    #[test]
    fn invalid_known_vertices_are_rejected() {
        let (topology, positions) = plane();
        let of = |known: &[u32]| Continuation::new(&topology, &positions, Operator::CotangentMass, known).err();
        assert_eq!(of(&[]), Some(LaplacianError::Unanchored { handle: 0 }));
        assert_eq!(of(&[3, 3]), Some(LaplacianError::Repeated { vertex: 3 }));
        assert_eq!(of(&[144]), Some(LaplacianError::NoSuchVertex { vertex: 144, vertex_count: 144 }));
    }
}
