use rosto_mesh::MeshError;
use thiserror::Error;

/// Reason why a surface cannot be made into a body.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SolidError {
    /// A position is infinite or NaN.
    #[error("vertex {vertex} has a coordinate that is not a finite number")]
    NotFinite {
        /// Index of the vertex.
        vertex: usize,
    },
    /// The thickness is not a positive finite length.
    #[error("the thickness has to be positive and finite, but it is {thickness_m} m")]
    Thickness {
        /// Requested thickness, in metres.
        thickness_m: f64,
    },
    /// An edge has more than two triangles, or two with opposite winding.
    #[error("more than one triangle has the directed edge from vertex {from} to vertex {to}")]
    NotASurface {
        /// Start of the edge.
        from: u32,
        /// End of the edge.
        to: u32,
    },
    /// Rims touch at a vertex, so that parts of the surface are connected only there.
    #[error("rims touch at vertex {vertex}")]
    Pinched {
        /// Index of the vertex.
        vertex: u32,
    },
    /// The surface is not a disc with holes.
    #[error(
        "the surface is not a disc with holes: it has {pieces} pieces, {rims} rims and Euler characteristic {euler}"
    )]
    NotADisc {
        /// Number of connected components; unused vertices count.
        pieces: usize,
        /// Number of rims.
        rims: usize,
        /// Vertices − edges + triangles.
        euler: i64,
    },
    /// The surface intersects itself, and smoothing does not remove that.
    #[error("{pairs} pairs of triangles intersect, and smoothing does not separate them")]
    CrossesItself {
        /// Number of remaining pairs.
        pairs: usize,
    },
    /// The wall would intersect itself.
    #[error(
        "a wall of {:.1} mm would intersect itself; the maximum is {:.1} mm",
        1e3 * .thickness_m, (1e4 * .most_m).floor() / 10.0
    )]
    TooThick {
        /// Requested thickness, in metres.
        thickness_m: f64,
        /// Largest thickness that works, found by bisection, in metres; 0 if none was found.
        most_m: f64,
    },
    /// The walls along −Z would intersect the surface, or the surface does not face +Z.
    #[error("a flat back does not fit: the walls from the rim to the back would intersect the surface")]
    NoFlatBack,
    /// The triangles are not a valid mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}
