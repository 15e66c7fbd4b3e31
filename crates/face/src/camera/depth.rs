use glam::{DMat3, DVec3};
use rosto_laplacian::{Fairing, Operator};

use crate::{FaceError, Triangulation, canonical_positions_m};

/// How much the shape of the canonical face counts beside the depths that were found: in a face that looks at the camera,
/// and in one that is turned away, whose depths are found less well.
const WEIGHTS: [f64; 2] = [30.0, 1e4];
/// Turned by this much and less, and by this much and more, in radians.
const TURNS_RAD: [f64; 2] = [0.175, 0.524];

/// Draws depths to the shape of the canonical face: [`Self::drawn`] is the minimum of `|z − found|² + w |L z − L c|²`, where
/// L is the random-walk graph Laplacian and c the depth of the canonical face, fitted to the one that was found.
pub(crate) struct CanonicalShape(Fairing);

impl CanonicalShape {
    /// For a head that is turned away by so much ([`turn_rad`]).
    pub(crate) fn new(turn_rad: f64) -> Result<Self, FaceError> {
        let operator = Operator::Uniform.matrix(&Triangulation::Canonical.topology(), &canonical_positions_m());
        let fairing = operator.and_then(|operator| Fairing::new(&operator, weight(turn_rad)));
        fairing.map(Self).map_err(|_| FaceError::Degenerate)
    }

    /// # Errors
    /// [`FaceError::Degenerate`] if a depth is not finite.
    pub(crate) fn drawn(&self, found: &[f64], canonical: &[f64]) -> Result<Vec<f64>, FaceError> {
        // In the difference from the canonical depths, whose δ-coordinates then are to vanish.
        let away: Vec<f64> = found.iter().zip(canonical).map(|(found, canonical)| found - canonical).collect();
        let faired = self.0.faired(&away).map_err(|_| FaceError::Degenerate)?;
        Ok(faired.iter().zip(canonical).map(|(away, canonical)| away + canonical).collect())
    }
}

/// By how much a head is turned away from the camera that it is seen by.
pub(crate) fn turn_rad(camera_from_model: DMat3) -> f64 {
    (camera_from_model * DVec3::Z).normalize().z.clamp(-1.0, 1.0).acos()
}

fn weight(turn_rad: f64) -> f64 {
    let share = ((turn_rad - TURNS_RAD[0]) / (TURNS_RAD[1] - TURNS_RAD[0])).clamp(0.0, 1.0);
    WEIGHTS[0] * (WEIGHTS[1] / WEIGHTS[0]).powf(share)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;

    fn depths() -> Vec<f64> {
        canonical_positions_m().iter().map(|position| position.z).collect()
    }

    #[test]
    fn what_has_the_canonical_shape_stays_wherever_it_is() {
        let found: Vec<f64> = depths().iter().map(|z| z + 0.3).collect();
        for turn_rad in [0.0, 0.4, 1.0] {
            let drawn = CanonicalShape::new(turn_rad).unwrap().drawn(&found, &depths()).unwrap();
            assert!(drawn.iter().zip(&found).all(|(a, b)| (a - b).abs() < 1e-9));
        }
    }

    #[test]
    fn one_point_that_sticks_out_is_drawn_in_and_the_more_so_in_a_face_turned_away() {
        let mut found = depths();
        found[50] += 0.01;
        let left = [0.0, 0.35, 0.7].map(|turn_rad| {
            let drawn = CanonicalShape::new(turn_rad).unwrap().drawn(&found, &depths()).unwrap();
            let mean = |z: &[f64]| z.iter().sum::<f64>() / z.len() as f64;
            assert!((mean(&drawn) - mean(&found)).abs() < 1e-4, "the whole stays where it is");
            drawn[50] - depths()[50]
        });
        assert!(left[0] < 0.005 && left[0] > left[1] && left[1] > left[2] && left[2] > 0.0, "{left:?}");
    }
}
