use glam::DVec3;
use rosto_mesh::Topology;

use crate::constraints::marked;
use crate::dirichlet::Dirichlet;
use crate::factor::Scratch;
use crate::gauge_fixed::gauge_fixed;
use crate::{ConstraintKind, LaplacianError, Operator};

/// Continues values that are known at some vertices to all the others, so that `‖K x‖²` is least: with
/// [`Operator::CotangentMass`] the bi-Laplacian of what is continued is zero, and two layers of known vertices give it value
/// and slope. Factored once, for any values.
pub struct Continuation {
    form: Dirichlet,
    scratch: Scratch,
}

impl Continuation {
    /// Works the vertices `known` into the matrix; `positions` in any unit.
    ///
    /// # Errors
    /// [`LaplacianError::NoSuchVertex`], [`LaplacianError::Repeated`], [`LaplacianError::Unanchored`] for a piece of the mesh
    /// of which nothing is known, or positions that do not fit.
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
        Ok(Self { form, scratch: Scratch::default() })
    }

    /// One value for each vertex, from one for each known one, in the order in which they were named. From the second time on
    /// nothing is allocated.
    ///
    /// # Panics
    /// If `known` has not one value for each known vertex, or `out` not one for each vertex.
    pub fn continued(&mut self, known: &[f64], out: &mut [f64]) {
        self.form.minimise(None, known, out, &mut self.scratch);
    }
}

fn check(known: &[u32], component: &[u32]) -> Result<(), LaplacianError> {
    marked(known, component.len())?;
    let mut is_held = vec![false; component.len()];
    known.iter().for_each(|&vertex| is_held[component[vertex as usize] as usize] = true);
    match component.iter().find(|&&piece| !is_held[piece as usize]) {
        Some(&handle) => Err(LaplacianError::Unanchored { handle }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: u32 = 12;

    /// A square of 12 × 12 vertices, one apart.
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
    fn a_plane_that_is_known_at_two_layers_of_its_rim_goes_on_inside() {
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
    fn what_is_known_stays_to_the_last_bit_and_what_is_continued_is_linear_in_it() {
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
    fn what_has_no_answer_is_refused() {
        let (topology, positions) = plane();
        let of = |known: &[u32]| Continuation::new(&topology, &positions, Operator::CotangentMass, known).err();
        assert_eq!(of(&[]), Some(LaplacianError::Unanchored { handle: 0 }));
        assert_eq!(of(&[3, 3]), Some(LaplacianError::Repeated { vertex: 3 }));
        assert_eq!(of(&[144]), Some(LaplacianError::NoSuchVertex { vertex: 144, vertex_count: 144 }));
    }
}
