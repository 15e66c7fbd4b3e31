use crate::LaplacianError;

/// How much of an edit each vertex takes: 1 at its heart, fading to 0 at the rim, 0 outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    falloff: Vec<f64>,
}

impl Region {
    /// A region with the given share for each vertex, clamped to `0..=1`.
    ///
    /// # Errors
    /// [`LaplacianError::NotFinite`] for a share that is not a number.
    pub fn new(falloff: Vec<f64>) -> Result<Self, LaplacianError> {
        if let Some(vertex) = falloff.iter().position(|share| !share.is_finite()) {
            return Err(LaplacianError::NotFinite { vertex: vertex as u32 });
        }
        Ok(Self { falloff: falloff.into_iter().map(|share| share.clamp(0.0, 1.0)).collect() })
    }

    /// The share of each vertex, in `0..=1`.
    pub fn falloff(&self) -> &[f64] {
        &self.falloff
    }
}
