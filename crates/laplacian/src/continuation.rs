use glam::DVec3;
use rosto_mesh::Topology;

use crate::constraints::mask;
use crate::dirichlet::Dirichlet;
use crate::factor::Scratch;
use crate::gauge_fixed::gauge_fixed;
use crate::{ConstraintKind, LaplacianError, Operator};

/// Extends values from fixed vertices to all vertices by minimising `‖K x‖²`. Factored once for any values.
///
/// With [`Operator::CotangentMass`] the extension is biharmonic: two layers of fixed vertices prescribe value and
/// slope.
pub struct Continuation {
    form: Dirichlet,
    scratch: Scratch,
}

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
        let component = topology.components();
        check(known, &component)?;
        let operator = operator.matrix(topology, positions)?;
        let squared = gauge_fixed(&(operator.transpose() * &operator), &component);
        let form = Dirichlet::new(&squared, &component, known, ConstraintKind::Hard)?;
        Ok(Self { scratch: form.factor.scratch(), form })
    }

    /// Writes one value per vertex to `out`, from one value per known vertex in the order of [`Self::new`], without an
    /// allocation.
    ///
    /// # Panics
    /// If the lengths of `known` and `out` are not the numbers of known vertices and of vertices.
    pub fn continued(&mut self, known: &[f64], out: &mut [f64]) {
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
    fn invalid_known_vertices_are_rejected() {
        let (topology, positions) = plane();
        let of = |known: &[u32]| Continuation::new(&topology, &positions, Operator::CotangentMass, known).err();
        assert_eq!(of(&[]), Some(LaplacianError::Unanchored { handle: 0 }));
        assert_eq!(of(&[3, 3]), Some(LaplacianError::Repeated { vertex: 3 }));
        assert_eq!(of(&[144]), Some(LaplacianError::NoSuchVertex { vertex: 144, vertex_count: 144 }));
    }
}
