use rosto_solid::SolidError;
use thiserror::Error;

/// Why a model cannot be written.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ExportError {
    /// A slice with one value for each vertex has another length.
    #[error("{found} {what} for {expected} vertices")]
    LengthMismatch {
        /// What the values are, such as "colours".
        what: &'static str,
        /// Number of vertices.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
    /// A position is infinite, not a number, or beyond what the file's 32-bit numbers reach.
    #[error("vertex {vertex} has a coordinate that no 32-bit number can hold")]
    NotFinite {
        /// The vertex.
        vertex: usize,
    },
    /// There is nothing to write.
    #[error("the mesh has no triangles")]
    Empty,
    /// The face is to be painted with a picture of the whole face, and the model has none.
    #[error("there is no picture of the whole face to paint it with")]
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
    /// A picture is to be written, and colours alone paint the face.
    #[error("there is no picture where colours alone paint the face")]
    NoPicture,
    /// What is written in a format for printing must be a body.
    #[error("an open surface cannot be printed: a thickness or a flat back makes it a body")]
    NoBody,
    /// The face cannot be made a body.
    #[error(transparent)]
    Solid(#[from] SolidError),
    /// The picture of a project is no PNG file.
    #[error("the picture in a project must be a PNG file")]
    NotPng,
}
