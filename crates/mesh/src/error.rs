use thiserror::Error;

/// Why a list of triangles is not a mesh, or positions do not fit one.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} names vertex {vertex}, but the mesh has {vertex_count} vertices")]
    VertexOutOfRange {
        /// Index of the triangle.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
    /// A triangle names one vertex twice.
    #[error("triangle {triangle} names vertex {vertex} twice")]
    RepeatedCorner {
        /// Index of the triangle.
        triangle: usize,
        /// The vertex it repeats.
        vertex: u32,
    },
    /// A slice with one value for each vertex has another length.
    #[error("{found} values for {expected} vertices")]
    LengthMismatch {
        /// Number of vertices.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
}
