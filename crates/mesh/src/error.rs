use thiserror::Error;

/// Reasons why triangles or positions are invalid.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A triangle uses a vertex outside the mesh.
    #[error("triangle {triangle} uses vertex {vertex}, but the mesh has {vertex_count} vertices")]
    VertexOutOfRange {
        /// Index of the triangle.
        triangle: usize,
        /// The vertex.
        vertex: u32,
        /// Number of vertices.
        vertex_count: usize,
    },
    /// A triangle uses a vertex twice.
    #[error("triangle {triangle} uses vertex {vertex} twice")]
    RepeatedCorner {
        /// Index of the triangle.
        triangle: usize,
        /// The repeated vertex.
        vertex: u32,
    },
    /// The number of values differs from the number of vertices.
    #[error("{found} values for {expected} vertices")]
    LengthMismatch {
        /// Number of vertices.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
}
