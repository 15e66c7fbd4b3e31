use thiserror::Error;

/// Why nothing can be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ViewportError {
    /// Neither the browser nor the system offers a GPU.
    #[error("no GPU was found: {0}")]
    NoAdapter(String),
    /// There is a GPU, but it would not give a device.
    #[error("the GPU gave no device: {0}")]
    NoDevice(String),
    /// The canvas cannot be drawn to, perhaps because it has another kind of context.
    #[error("the canvas cannot be drawn to: {0}")]
    CanvasInUse(String),
    /// The device went away: the driver restarted, the machine slept, or the browser took it back.
    #[error("the GPU went away: {0}")]
    DeviceLost(String),
    /// A list with one value for each vertex has another length.
    #[error("{found} {what} for {expected} vertices")]
    LengthMismatch {
        /// What the list holds.
        what: &'static str,
        /// Number of vertices.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
    /// The GPU's largest texture has no room for so many vertices.
    #[error("{0} vertices are more than the GPU holds")]
    TooManyVertices(usize),
    /// The photo's bytes do not fill its size, or it has none.
    #[error("{found} bytes for a picture of {width}×{height} px")]
    BadPicture {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
        /// Number of bytes given.
        found: usize,
    },
    /// The GPU, or the program, has no memory for a picture of that size.
    #[error("there is no memory for a picture of {width}×{height} px")]
    OutOfMemory {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
    },
    /// The GPU refused to draw a picture.
    #[error("the GPU did not draw the picture: {0}")]
    NotDrawn(String),
    /// The picture that was drawn could not be read back.
    #[error("the picture could not be read back from the GPU")]
    NotRead,
}
