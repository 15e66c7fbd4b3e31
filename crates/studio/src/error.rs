use rosto_laplacian::LaplacianError;
use rosto_texture::TextureError;
use rosto_warp::WarpError;
use thiserror::Error;

/// Why a command cannot be carried out. The document is as it was before.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum StudioError {
    /// The edit has no answer.
    #[error(transparent)]
    Laplacian(#[from] LaplacianError),
    /// The photo cannot be warped.
    #[error(transparent)]
    Warp(#[from] WarpError),
    /// There is no such texture.
    #[error(transparent)]
    Texture(#[from] TextureError),
    /// There is not one offset for each handle.
    #[error("{found} offsets for {expected} handles")]
    WrongOffsetCount {
        /// Number of handles.
        expected: usize,
        /// Number of offsets given.
        found: usize,
    },
    /// An offset is infinite or not a number.
    #[error("the offset of handle {handle} is not a finite number")]
    OffsetNotFinite {
        /// The handle.
        handle: u32,
    },
    /// The share of a symmetrisation is outside 0..=1.
    #[error("the share must lie between 0 and 1, not at {share}")]
    Share {
        /// The share given.
        share: f64,
    },
    /// The document's coordinates have no mirror plane, or its triangles no mirror image.
    #[error("only a face in the model's own frame, with triangles that are their own mirror image, can be mirrored")]
    NoMirror,
    /// The mesh is no face in the model's own frame, and so has no expressions.
    #[error("only a face of 468 landmarks in the model's own frame has expressions, not a mesh of {vertex_count}")]
    NoExpressions {
        /// How many vertices it has.
        vertex_count: usize,
    },
    /// An expression's weight is beyond what it may be, or not a number.
    #[error("an expression's weight must lie between -1 and 1, not at {weight}")]
    Weight {
        /// The weight given.
        weight: f64,
    },
    /// A spec is meant for a denser mesh than the one there is.
    #[error("the edit is meant for {level} subdivisions, and the mesh has {density}")]
    TooCoarse {
        /// The spec's level.
        level: u32,
        /// The document's density.
        density: u32,
    },
    /// A mesh is asked for that is denser than any that is shown.
    #[error("{level} subdivisions are more than the {most} there are")]
    TooDense {
        /// How often the mesh was to be subdivided.
        level: u32,
        /// How often it can be.
        most: u32,
    },
    /// More vertices are to be moved at once than there is room for.
    #[error("{handles} vertices cannot be moved at once: on this mesh, {most} can")]
    TooManyHandles {
        /// How many were to be moved.
        handles: usize,
        /// How many can be.
        most: usize,
    },
    /// An entry of a file has no answer.
    #[error("entry {index} of the history: {reason}")]
    Entry {
        /// Which entry, from 0.
        index: usize,
        /// What is wrong with it.
        reason: Box<StudioError>,
    },
    /// The mesh leaves no vertices for random anchors.
    #[error("{free} vertices are free, and two random anchors need two")]
    NoFreeAnchors {
        /// How many vertices are no handles.
        free: usize,
    },
    /// A test has asked for this failure.
    #[cfg(feature = "faults")]
    #[error("a test has asked for this failure")]
    Injected,
    /// Nothing is held that could be moved or committed.
    #[error("no vertex is held")]
    NothingPrepared,
    /// The history has no such entry.
    #[error("there is no entry {index}: the history has {count}")]
    NoSuchEntry {
        /// The entry asked for, from 0.
        index: usize,
        /// How many there are.
        count: usize,
    },
}
