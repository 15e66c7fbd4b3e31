use glam::{DMat3, DVec3};
use rosto_laplacian::{Fairing, Operator};

use crate::{FaceError, Triangulation, canonical_positions_m};

/// Weight of the canonical shape relative to the detected depths, for a frontal and for a turned head. Depths of turned
/// heads are detected less accurately.
const WEIGHTS: [f64; 2] = [30.0, 1e4];
/// Turn angles at and below which the first weight applies, and at and above which the second does, in radians.
const TURNS_RAD: [f64; 2] = [0.175, 0.524];

/// Regularises depths towards the canonical shape.
///
/// [`Self::regularised`] minimises `|z − found|² + w |L z − L c|²`, where L is the random-walk graph Laplacian and c
/// the depths of the canonical face fitted to the landmarks.
pub(crate) struct CanonicalShape(Fairing);

impl CanonicalShape {
    /// Prepares the system for a head turned by `turn_rad` (see [`turn_rad`]).
    pub(crate) fn new(turn_rad: f64) -> Result<Self, FaceError> {
        let operator = Operator::Uniform.matrix(&Triangulation::Canonical.topology(), &canonical_positions_m());
        let fairing = operator.and_then(|operator| Fairing::new(&operator, weight(turn_rad)));
        fairing.map(Self).map_err(|_| FaceError::Degenerate)
    }

    /// # Errors
    /// [`FaceError::Degenerate`] if a depth is not finite.
    pub(crate) fn regularised(&self, found: &[f64], canonical: &[f64]) -> Result<Vec<f64>, FaceError> {
        // Solved for the difference from the canonical depths, whose δ-coordinates should vanish.
        let offsets: Vec<f64> = found.iter().zip(canonical).map(|(found, canonical)| found - canonical).collect();
        let faired = self.0.faired(&offsets).map_err(|_| FaceError::Degenerate)?;
        Ok(faired.iter().zip(canonical).map(|(offset, canonical)| offset + canonical).collect())
    }
}

/// Angle between the face's axis and the direction to the camera, in radians.
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
    fn a_shifted_canonical_shape_is_unchanged() {
        let found: Vec<f64> = depths().iter().map(|z| z + 0.3).collect();
        for turn_rad in [0.0, 0.4, 1.0] {
            let smooth = CanonicalShape::new(turn_rad).unwrap().regularised(&found, &depths()).unwrap();
            assert!(smooth.iter().zip(&found).all(|(a, b)| (a - b).abs() < 1e-9));
        }
    }

    #[test]
    fn an_outlier_is_reduced_more_in_turned_heads() {
        let mut found = depths();
        found[50] += 0.01;
        let left = [0.0, 0.35, 0.7].map(|turn_rad| {
            let smooth = CanonicalShape::new(turn_rad).unwrap().regularised(&found, &depths()).unwrap();
            let mean = |z: &[f64]| z.iter().sum::<f64>() / z.len() as f64;
            assert!((mean(&smooth) - mean(&found)).abs() < 1e-4, "the mean depth is preserved");
            smooth[50] - depths()[50]
        });
        assert!(left[0] < 0.005 && left[0] > left[1] && left[1] > left[2] && left[2] > 0.0, "{left:?}");
    }
}
