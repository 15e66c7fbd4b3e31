use crate::LaplacianError;

/// How much of an edit each vertex takes: 1 at its heart, fading to 0 at the rim, 0 outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Falloff {
    weights: Vec<f64>,
}

impl Falloff {
    /// A region with the given share for each vertex, clamped to `0..=1`.
    ///
    /// # Errors
    /// [`LaplacianError::NotFinite`] for a share that is not finite.
    pub fn new(weights: Vec<f64>) -> Result<Self, LaplacianError> {
        if let Some(vertex) = weights.iter().position(|share| !share.is_finite()) {
            return Err(LaplacianError::NotFinite { vertex: vertex as u32 });
        }
        Ok(Self { weights: weights.into_iter().map(|share| share.clamp(0.0, 1.0)).collect() })
    }

    /// Everything nearer than `radius`, by distances such as [`Geodesics::distances`](crate::Geodesics::distances) gives,
    /// in the same unit. The share falls as `1 − s³(10 − 15s + 6s²)` for `s = distance/radius`: flat and without a bend
    /// both at its heart and at the rim.
    ///
    /// # Errors
    /// [`LaplacianError::NotFinite`] for a distance that is not a number; an infinite one is outside.
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

    /// The share of each vertex, in `0..=1`.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }
}
