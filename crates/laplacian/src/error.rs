use thiserror::Error;

/// Why a system cannot be built, or a set of constraints has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LaplacianError {
    /// There is nothing to edit.
    #[error("the mesh has no vertices")]
    Empty,
    /// A slice with one value for each vertex has another length.
    #[error("{found} values for {expected} vertices")]
    LengthMismatch {
        /// Number of vertices.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
    /// A position or weight is infinite or not a number.
    #[error("vertex {vertex} has a value that is not finite")]
    NotFinite {
        /// The vertex.
        vertex: u32,
    },
    /// A handle or anchor is not a vertex of the mesh.
    #[error("there is no vertex {vertex}: the mesh has {vertex_count}")]
    NoSuchVertex {
        /// The vertex asked for.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
    /// Nothing is to be moved.
    #[error("no handle was given")]
    NoHandle,
    /// A vertex is listed twice among the handles or among the anchors.
    #[error("vertex {vertex} is listed twice")]
    Repeated {
        /// The vertex.
        vertex: u32,
    },
    /// A vertex cannot be moved and constrained at once.
    #[error("vertex {vertex} is a handle and an anchor at once")]
    PinnedHandle {
        /// The vertex.
        vertex: u32,
    },
    /// Without an anchor a whole piece of the mesh would follow the handle as it is.
    #[error("no anchor holds the piece of the mesh that handle {handle} belongs to")]
    Unanchored {
        /// The handle.
        handle: u32,
    },
    /// A soft constraint's weight is not a positive number.
    #[error("a constraint's weight must be positive and finite, not {weight}")]
    Weight {
        /// The weight given.
        weight: f64,
    },
    /// A region's radius is not a positive number.
    #[error("a region's radius must be positive and finite, not {radius}")]
    Radius {
        /// The radius given.
        radius: f64,
    },
    /// A handle lies where the region lets nothing move.
    #[error("handle {handle} lies outside the region of influence")]
    OutsideRegion {
        /// The handle.
        handle: u32,
    },
    /// Rounding has eaten the last digits: no trustworthy factor exists.
    #[error("the system is too badly scaled to factor; it breaks down at vertex {vertex}")]
    BadlyScaled {
        /// The vertex whose pivot was not positive.
        vertex: u32,
    },
}
