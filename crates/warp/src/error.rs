use rosto_laplacian::LaplacianError;
use rosto_mesh::MeshError;
use thiserror::Error;

/// Why a picture cannot be warped.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum WarpError {
    /// Fewer than three of the points lie in the picture.
    #[error("only {inside} of the {points} points lie in the picture: nothing can lead it")]
    TooFewPoints {
        /// Those inside.
        inside: usize,
        /// All of them.
        points: usize,
    },
    /// The ring has no width.
    #[error("the ring must be wider than 0 px, not {ring_px}")]
    Ring {
        /// The width asked for.
        ring_px: f64,
    },
    /// The triangulation is none.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// What is around the points cannot be solved for.
    #[error(transparent)]
    Laplacian(#[from] LaplacianError),
}
