use crate::LaplacianError;

/// Region of influence of an edit: a weight per vertex, from 1 at the centre to 0 at the rim and outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Falloff {
    weights: Vec<f64>,
}

impl Falloff {
    /// Creates a region from one weight per vertex, clamped to `0..=1`.
    ///
    /// # Errors
    /// [`LaplacianError::NotFinite`] for a weight that is not finite.
    pub fn new(weights: Vec<f64>) -> Result<Self, LaplacianError> {
        if let Some(vertex) = weights.iter().position(|share| !share.is_finite()) {
            return Err(LaplacianError::NotFinite { vertex: vertex as u32 });
        }
        Ok(Self { weights: weights.into_iter().map(|share| share.clamp(0.0, 1.0)).collect() })
    }

    /// Creates a region of the vertices nearer than `radius`, from
    /// [`Geodesics::distances`](crate::Geodesics::distances) in the same unit. The weight is `1 − s³(10 − 15s + 6s²)`
    /// with `s = distance/radius`, whose first and second derivatives vanish at the centre and the rim.
    ///
    /// # Errors
    /// [`LaplacianError::NotFinite`] for a NaN distance; an infinite distance is outside.
    /// [`LaplacianError::Radius`] for a radius that is not positive and finite.
    pub fn within(radius: f64, distances: &[f64]) -> Result<Self, LaplacianError> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(LaplacianError::Radius { radius });
        }
        let fade = |distance: f64| {
            let s = (distance / radius).min(1.0);
            1.0 - s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)
        };
        Self::new(distances.iter().map(|&distance| fade(distance)).collect())
    }

    /// The weight of each vertex, in `0..=1`.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }
}
