use rosto_laplacian::LaplacianError;
use rosto_texture::TextureError;
use rosto_warp::WarpError;
use thiserror::Error;

/// Why a command cannot be applied. The document is unchanged.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum StudioError {
    /// The edit has no solution.
    #[error(transparent)]
    Laplacian(#[from] LaplacianError),
    /// The photo cannot be warped.
    #[error(transparent)]
    Warp(#[from] WarpError),
    /// The texture cannot be made.
    #[error(transparent)]
    Texture(#[from] TextureError),
    /// A texture was requested of a face that was built without its pictures.
    #[error("the face was built without its pictures")]
    NoPicture,
    /// The number of offsets differs from the number of handles.
    #[error("{found} offsets for {expected} handles")]
    WrongOffsetCount {
        /// Number of handles.
        expected: usize,
        /// Number of offsets given.
        found: usize,
    },
    /// An offset is infinite or NaN.
    #[error("the offset of handle {handle} is not a finite number")]
    OffsetNotFinite {
        /// The handle.
        handle: u32,
    },
    /// The share of a symmetrisation is outside 0..=1.
    #[error("the share must be between 0 and 1, but it is {share}")]
    Share {
        /// The given share.
        share: f64,
    },
    /// The document's coordinates have no mirror plane, or its triangles are not symmetric.
    #[error("only a face in the model's frame with symmetric triangles can be mirrored")]
    NoMirror,
    /// The mesh is not a face in the model's frame and has no expressions.
    #[error("expressions need a face of 468 landmarks in the model's frame; this mesh has {vertex_count} vertices")]
    NoExpressions {
        /// Number of vertices of the mesh.
        vertex_count: usize,
    },
    /// An expression's weight is outside −1..=1 or NaN.
    #[error("an expression's weight must be between -1 and 1, but it is {weight}")]
    Weight {
        /// The given weight.
        weight: f64,
    },
    /// The spec belongs to a denser mesh than the displayed one.
    #[error("the edit needs {level} subdivisions, but the mesh has {density}")]
    TooCoarse {
        /// The spec's level.
        level: u32,
        /// The document's density.
        density: u32,
    },
    /// The requested density exceeds the maximum.
    #[error("{level} subdivisions are too many; the maximum is {max}")]
    TooDense {
        /// The requested subdivision level.
        level: u32,
        /// The highest level.
        max: u32,
    },
    /// The edit has too many handles for the memory limit.
    #[error("{handles} vertices cannot be moved at once; the maximum on this mesh is {max}")]
    TooManyHandles {
        /// Number of handles.
        handles: usize,
        /// The highest number on this mesh.
        max: usize,
    },
    /// The history has too many entries.
    #[error("the history has {found} entries; the maximum is {max}")]
    TooManyEntries {
        /// Number of entries.
        found: usize,
        /// Highest number of entries.
        max: usize,
    },
    /// A label is too long.
    #[error("the label has {found} characters; the maximum is {max}")]
    LabelTooLong {
        /// Number of characters.
        found: usize,
        /// Highest number of characters.
        max: usize,
    },
    /// There are more anchors than vertices.
    #[error("{anchors} anchors on a mesh of {vertex_count} vertices")]
    TooManyAnchors {
        /// Number of anchors given.
        anchors: usize,
        /// Number of vertices of the mesh.
        vertex_count: usize,
    },
    /// Replaying the history would take too long.
    #[error("the history needs {work} displacements of vertices; the maximum is {max}")]
    TooMuchWork {
        /// Displacements of vertices, with solves in the same unit.
        work: u64,
        /// Highest number of displacements.
        max: u64,
    },
    /// An entry of a file has no solution.
    #[error("entry {index} of the history: {reason}")]
    Entry {
        /// The entry, from 0.
        index: usize,
        /// The reason.
        reason: Box<StudioError>,
    },
    /// Too few free vertices for random anchors.
    #[error("random anchors need two vertices that are not handles; this mesh has {free}")]
    NoFreeAnchors {
        /// Number of vertices that are not handles.
        free: usize,
    },
    /// Failure injected by a test.
    #[cfg(feature = "faults")]
    #[error("a test injected this failure")]
    Injected,
    /// There is no prepared edit to move or commit.
    #[error("no edit is prepared: prepare one first")]
    NothingPrepared,
    /// The history does not have this entry.
    #[error("the history has no entry {index}; it has {count}")]
    NoSuchEntry {
        /// The requested entry, from 0.
        index: usize,
        /// Number of entries.
        count: usize,
    },
}

impl StudioError {
    /// Suggested remedy, if there is one.
    pub fn hint(&self) -> Option<String> {
        let fixed = match self {
            Self::TooCoarse { .. } => "Raise the density to that level.",
            Self::Laplacian(LaplacianError::NoSuchVertex { vertex_count, .. }) => {
                return Some(format!("The vertices of this mesh are 0 to {}.", vertex_count.saturating_sub(1)));
            }
            Self::Laplacian(LaplacianError::PinnedHandle { .. }) => "Use anchors other than the moved vertex.",
            Self::Laplacian(LaplacianError::Repeated { .. }) => "Give each anchor once.",
            Self::Laplacian(LaplacianError::NotFinite { .. }) => "Use smaller offsets.",
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}
