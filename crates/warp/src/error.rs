use rosto_laplacian::LaplacianError;
use rosto_mesh::MeshError;
use thiserror::Error;

/// Reasons why a picture cannot be warped.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum WarpError {
    /// Fewer than three points, or only coincident points, lie in the picture.
    #[error("{inside} of {points} points lie in the picture; a warp needs at least three, not all at one position")]
    TooFewPoints {
        /// Number of points in the picture.
        inside: usize,
        /// Number of points.
        points: usize,
    },
    /// The falloff band is too narrow or too wide for the points ([`crate::FALLOFF_BAND_SHARES`]).
    #[error("the falloff band must be {least_px:.1} to {most_px:.1} px wide; got {falloff_band_px}")]
    FalloffBand {
        /// Requested width.
        falloff_band_px: f64,
        /// Minimum width.
        least_px: f64,
        /// Maximum width.
        most_px: f64,
    },
    /// The triangulation is invalid.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The falloff band's system cannot be solved.
    #[error(transparent)]
    Laplacian(#[from] LaplacianError),
}
