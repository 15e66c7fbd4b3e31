use glam::{DMat3, DVec3};
use rosto_mesh::Topology;

/// How much the shape of the canonical face counts beside the depths that were found: in a face that looks at the camera,
/// and in one that is turned away, whose depths are found less well.
const WEIGHTS: [f64; 2] = [30.0, 1e4];
/// Turned by this much and less, and by this much and more, in radians.
const TURNS_RAD: [f64; 2] = [0.175, 0.524];

/// Depths near to those found whose δ-coordinates are near to the canonical face's: the minimum of
/// `|z − found|² + w |L z − L c|²`, where L is the umbrella operator and c the depth of the canonical face, fitted to the one
/// that was found.
pub(crate) fn drawn_to_canonical(topology: &Topology, found: &[f64], canonical: &[f64], turn_rad: f64) -> Vec<f64> {
    let weight = weight(turn_rad);
    let umbrella = Umbrella { topology };
    // In the difference from the canonical depths, whose δ-coordinates then are to vanish.
    let away: Vec<f64> = found.iter().zip(canonical).map(|(found, canonical)| found - canonical).collect();
    let solved = conjugate_gradients(&away, |x| {
        let bent = umbrella.transposed(&umbrella.applied(x));
        x.iter().zip(bent).map(|(x, bent)| x + weight * bent).collect()
    });
    solved.iter().zip(canonical).map(|(away, canonical)| away + canonical).collect()
}

/// By how much a head is turned away from the camera that it is seen by.
pub(crate) fn turn_rad(camera_from_model: DMat3) -> f64 {
    (camera_from_model * DVec3::Z).normalize().z.clamp(-1.0, 1.0).acos()
}

fn weight(turn_rad: f64) -> f64 {
    let share = ((turn_rad - TURNS_RAD[0]) / (TURNS_RAD[1] - TURNS_RAD[0])).clamp(0.0, 1.0);
    WEIGHTS[0] * (WEIGHTS[1] / WEIGHTS[0]).powf(share)
}

/// The umbrella operator: what a vertex has beyond the mean of its neighbours.
struct Umbrella<'a> {
    topology: &'a Topology,
}

impl Umbrella<'_> {
    fn applied(&self, x: &[f64]) -> Vec<f64> {
        let mean = |vertex: usize| {
            let around = self.topology.neighbours(vertex as u32);
            around.iter().map(|&other| x[other as usize]).sum::<f64>() / around.len() as f64
        };
        (0..x.len()).map(|vertex| x[vertex] - mean(vertex)).collect()
    }

    fn transposed(&self, y: &[f64]) -> Vec<f64> {
        let share = |vertex: u32| y[vertex as usize] / self.topology.degree(vertex) as f64;
        let from =
            |vertex: usize| self.topology.neighbours(vertex as u32).iter().map(|&other| share(other)).sum::<f64>();
        (0..y.len()).map(|vertex| y[vertex] - from(vertex)).collect()
    }
}

/// Solves `A x = b` for a symmetric positive definite A (Hestenes and Stiefel 1952), from b on.
fn conjugate_gradients(b: &[f64], a: impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
    const RELATIVE_RESIDUAL: f64 = 1e-12;
    const MOST_STEPS: usize = 2000;
    let dot = |u: &[f64], v: &[f64]| u.iter().zip(v).map(|(u, v)| u * v).sum::<f64>();
    let mut x = b.to_vec();
    let mut residual: Vec<f64> = b.iter().zip(a(&x)).map(|(b, ax)| b - ax).collect();
    let mut way = residual.clone();
    let mut left = dot(&residual, &residual);
    let enough = RELATIVE_RESIDUAL * RELATIVE_RESIDUAL * dot(b, b);
    for _ in 0..MOST_STEPS {
        if left <= enough {
            break;
        }
        let image = a(&way);
        let step = left / dot(&way, &image);
        x.iter_mut().zip(&way).for_each(|(x, way)| *x += step * way);
        residual.iter_mut().zip(&image).for_each(|(residual, image)| *residual -= step * image);
        let next = dot(&residual, &residual);
        way.iter_mut().zip(&residual).for_each(|(way, residual)| *way = residual + next / left * *way);
        left = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Triangulation, canonical_positions_m};

    fn depths() -> Vec<f64> {
        canonical_positions_m().iter().map(|position| position.z).collect()
    }

    #[test]
    fn what_has_the_canonical_shape_stays_wherever_it_is() {
        let topology = Triangulation::Canonical.topology();
        let found: Vec<f64> = depths().iter().map(|z| z + 0.3).collect();
        for turn_rad in [0.0, 0.4, 1.0] {
            let drawn = drawn_to_canonical(&topology, &found, &depths(), turn_rad);
            assert!(drawn.iter().zip(&found).all(|(a, b)| (a - b).abs() < 1e-9));
        }
    }

    #[test]
    fn one_point_that_sticks_out_is_drawn_in_and_the_more_so_in_a_face_turned_away() {
        let topology = Triangulation::Canonical.topology();
        let mut found = depths();
        found[50] += 0.01;
        let left = [0.0, 0.35, 0.7].map(|turn_rad| {
            let drawn = drawn_to_canonical(&topology, &found, &depths(), turn_rad);
            let mean = |z: &[f64]| z.iter().sum::<f64>() / z.len() as f64;
            assert!((mean(&drawn) - mean(&found)).abs() < 1e-4, "the whole stays where it is");
            drawn[50] - depths()[50]
        });
        assert!(left[0] < 0.005 && left[0] > left[1] && left[1] > left[2] && left[2] > 0.0, "{left:?}");
    }
}
