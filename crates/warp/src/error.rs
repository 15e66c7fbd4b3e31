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
    /// The ring is too narrow or too wide for the points ([`crate::RING_SHARES`]).
    #[error("the ring must be {least_px:.1} to {most_px:.1} px wide, not {ring_px}")]
    Ring {
        /// The width asked for.
        ring_px: f64,
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
