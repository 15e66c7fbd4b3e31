use thiserror::Error;

/// Reasons why nothing can be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ViewportError {
    /// No GPU is available.
    #[error("no GPU found: {0}")]
    NoAdapter(String),
    /// The GPU cannot be used.
    #[error("the GPU device could not be created: {0}")]
    NoDevice(String),
    /// The canvas cannot be used, for example because it has another kind of context.
    #[error("cannot draw on the canvas: {0}")]
    CanvasInUse(String),
    /// The device was lost, for example because the driver restarted or the machine was suspended.
    #[error("the GPU device was lost: {0}")]
    DeviceLost(String),
    /// A list with one value per vertex has the wrong length.
    #[error("{found} {what} for {expected} vertices")]
    LengthMismatch {
        /// Content of the list.
        what: &'static str,
        /// Number of vertices.
        expected: usize,
        /// Number of values.
        found: usize,
    },
    /// The vertex data exceeds the GPU's maximum texture size.
    #[error("{0} vertices exceed the GPU's limit")]
    TooManyVertices(usize),
    /// The number of bytes does not match the picture's size, or the size is invalid.
    #[error("{found} bytes do not match a picture of {width}×{height} px")]
    BadPicture {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
        /// Number of bytes.
        found: usize,
    },
    /// Not enough memory for a picture of this size.
    #[error("not enough memory for a picture of {width}×{height} px")]
    OutOfMemory {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
    },
    /// The GPU reported an error while drawing a picture.
    #[error("the GPU could not draw the picture: {0}")]
    NotDrawn(String),
    /// The picture could not be read back.
    #[error("the picture could not be read back from the GPU")]
    NotRead,
}
