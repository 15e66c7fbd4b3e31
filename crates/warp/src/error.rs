use rosto_laplacian::LaplacianError;
use rosto_mesh::MeshError;
use thiserror::Error;

/// Why a picture cannot be warped.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum WarpError {
    /// Fewer than three of the points lie in the picture, or all of them in one place.
    #[error("{inside} of the {points} points lie in the picture; three in different places are needed to lead it")]
    TooFewPoints {
        /// Those inside.
        inside: usize,
        /// All of them.
        points: usize,
    },
    /// The falloff band is too narrow or too wide for the points ([`crate::FALLOFF_BAND_SHARES`]).
    #[error("the falloff band must be {least_px:.1} to {most_px:.1} px wide, not {falloff_band_px}")]
    FalloffBand {
        /// The width asked for.
        falloff_band_px: f64,
        /// The narrowest.
        least_px: f64,
        /// The widest.
        most_px: f64,
    },
    /// The triangulation is none.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// What is around the points cannot be solved for.
    #[error(transparent)]
    Laplacian(#[from] LaplacianError),
}
