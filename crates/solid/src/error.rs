use rosto_mesh::MeshError;
use thiserror::Error;

/// Why a surface cannot be made a body.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SolidError {
    /// A position is infinite or not a number.
    #[error("vertex {vertex} has a coordinate that is no number")]
    NotFinite {
        /// The vertex.
        vertex: usize,
    },
    /// The thickness is not a length above zero.
    #[error("a wall cannot be {thickness_m} m thick")]
    Thickness {
        /// What was asked for, in metres.
        thickness_m: f64,
    },
    /// A side has more than two triangles, or two that wind against each other.
    #[error("more than one triangle has the side from vertex {from} to vertex {to} in that direction")]
    NotASurface {
        /// Where the side starts.
        from: u32,
        /// Where it ends.
        to: u32,
    },
    /// Rims touch in a vertex, so that the surface hangs together by a point.
    #[error("rims touch in vertex {vertex}")]
    Pinched {
        /// The vertex.
        vertex: u32,
    },
    /// It is not one piece that could be laid flat, but for holes.
    #[error("the surface is no disc with holes: it has {pieces} pieces, {rims} rims and Euler characteristic {euler}")]
    NotADisc {
        /// How many pieces it has; a vertex that no triangle uses is one, too.
        pieces: usize,
        /// How many rims it has.
        rims: usize,
        /// Vertices − sides + triangles.
        euler: i64,
    },
    /// The surface goes through itself, and smoothing does not part it.
    #[error("{pairs} pairs of triangles go through each other, and cannot be parted")]
    CrossesItself {
        /// How many pairs are left.
        pairs: usize,
    },
    /// The wall would go through itself.
    #[error("a wall {thickness_m} m thick goes through itself; {most_m} m is the most that does not")]
    TooThick {
        /// What was asked for, in metres.
        thickness_m: f64,
        /// The most that works, found by halving, in metres; 0 if none was found.
        most_m: f64,
    },
    /// The sides that lead straight back would go through the surface, or it does not face +Z.
    #[error("no flat back can be put behind the surface: the way back from its rim goes through it")]
    NoFlatBack,
    /// The triangles are no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}
