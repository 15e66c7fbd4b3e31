use rosto_solid::SolidError;
use thiserror::Error;

/// Reason why a model could not be exported.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ExportError {
    /// A per-vertex slice has the wrong length.
    #[error("{found} {what} for {expected} vertices")]
    LengthMismatch {
        /// Kind of value, such as "colours".
        what: &'static str,
        /// Number of vertices.
        expected: usize,
        /// Number of values passed.
        found: usize,
    },
    /// A position is infinite, NaN, or out of range for `f32`.
    #[error("vertex {vertex} has a coordinate that does not fit in a 32-bit number")]
    NotFinite {
        /// Index of the vertex.
        vertex: usize,
    },
    /// The mesh is empty.
    #[error("the mesh has no triangles")]
    Empty,
    /// The whole-face texture was requested, but the model has none.
    #[error("the model has no whole-face texture")]
    NoWholePicture,
    /// The history is not the text of a JSON object.
    #[error("the history in a glTF file must be a JSON object")]
    HistoryNotAnObject,
    /// The texture could not be encoded.
    #[error("the {width}×{height} px texture could not be encoded")]
    Texture {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
    },
    /// A picture was requested, but the face has only vertex colours, or was built without its picture.
    #[error("there is no picture to write: the face has vertex colours only")]
    NoPicture,
    /// A 3MF file requires a closed body.
    #[error("an open surface cannot be printed; choose a thickness or a flat back")]
    NoBody,
    /// The face could not be turned into a closed body.
    #[error(transparent)]
    Solid(#[from] SolidError),
}
