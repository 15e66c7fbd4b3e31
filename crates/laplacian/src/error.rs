use thiserror::Error;

/// Reasons why a system cannot be built or constraints cannot be applied.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LaplacianError {
    /// The mesh has no vertices.
    #[error("the mesh has no vertices")]
    Empty,
    /// The number of values differs from the number of vertices.
    #[error("{found} values for {expected} vertices")]
    LengthMismatch {
        /// Number of vertices.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
    /// A position or weight is infinite or not a number.
    #[error("vertex {vertex} has a non-finite value")]
    NotFinite {
        /// The vertex.
        vertex: u32,
    },
    /// A handle or anchor is not a vertex of the mesh.
    #[error("vertex {vertex} does not exist: the mesh has {vertex_count} vertices")]
    NoSuchVertex {
        /// The requested vertex.
        vertex: u32,
        /// Number of vertices.
        vertex_count: usize,
    },
    /// The constraints have no handle.
    #[error("no handle given")]
    NoHandle,
    /// A vertex is listed twice among the handles or among the anchors.
    #[error("vertex {vertex} is listed twice")]
    Repeated {
        /// The vertex.
        vertex: u32,
    },
    /// A vertex is a handle and an anchor.
    #[error("vertex {vertex} is both a handle and an anchor")]
    PinnedHandle {
        /// The vertex.
        vertex: u32,
    },
    /// A component with a handle has no anchor, so all of it would move with the handle.
    #[error("the connected part of the mesh with handle {handle} has no anchor")]
    Unanchored {
        /// The handle.
        handle: u32,
    },
    /// A soft constraint's weight is not a positive number.
    #[error("a constraint's weight must be positive and finite; got {weight}")]
    Weight {
        /// The given weight.
        weight: f64,
    },
    /// A tension is negative or not finite.
    #[error("a tension must be at least 0 and finite; got {tension}")]
    Tension {
        /// The given tension.
        tension: f64,
    },
    /// A region's radius is not positive and finite.
    #[error("a region's radius must be positive and finite; got {radius}")]
    Radius {
        /// The given radius.
        radius: f64,
    },
    /// A handle has weight 0 in the region of influence.
    #[error("handle {handle} lies outside the region of influence")]
    OutsideRegion {
        /// The handle.
        handle: u32,
    },
    /// A pivot is not positive because of rounding.
    #[error("the system is too badly scaled to factor; it breaks down at vertex {vertex}")]
    BadlyScaled {
        /// The vertex whose pivot was not positive.
        vertex: u32,
    },
}
