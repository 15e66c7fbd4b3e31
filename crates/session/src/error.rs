use rosto_face::FaceError;
use rosto_studio::StudioError;
use rosto_studio::project::ProjectError;
use thiserror::Error;

/// Why an intent is refused. The session is unchanged.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SessionError {
    /// The intent needs an open face.
    #[error("no face is open")]
    NoFace,
    /// The intent needs a selection.
    #[error("nothing is selected")]
    NothingSelected,
    /// No such vertex, or no such landmark if landmarks are selected.
    #[error("there is no point {vertex}; this face has {count}, counted from 0")]
    NoSuchVertex {
        /// The requested vertex.
        vertex: u32,
        /// Number of vertices.
        count: usize,
    },
    /// No such widget in the panels, or a value of another type.
    #[error("there is no widget {id:?} for such a value")]
    NoSuchWidget {
        /// Id of the widget.
        id: String,
    },
    /// No such photo of the face.
    #[error("there is no photo {photo}; this face has {count}, counted from 0")]
    NoSuchPhoto {
        /// The requested photo.
        photo: usize,
        /// Number of photos.
        count: usize,
    },
    /// A number is out of range or NaN.
    #[error("{what} must be between {min} and {max}, but it is {value}")]
    OutOfRange {
        /// Meaning of the number, with its unit.
        what: &'static str,
        /// The given number.
        value: f64,
        /// Lower end of the range.
        min: f64,
        /// Upper end of the range.
        max: f64,
    },
    /// An entry of a history exceeds the maximum offset.
    #[error("entry {entry} of the history moves a vertex by {distance_m} m; the maximum is {most_m} m")]
    BadHistory {
        /// The entry, from 0.
        entry: usize,
        /// Length of its offset, in metres.
        distance_m: f64,
        /// Maximum length, in metres.
        most_m: f64,
    },
    /// The text is not valid photo-edit data.
    #[error(transparent)]
    PhotoEdit(rosto::Error),
    /// The text is not a valid set of preferences.
    #[error("the preferences have a missing or invalid {field:?}")]
    Preferences {
        /// The missing or invalid field.
        field: &'static str,
    },
    /// The landmarks do not form a face.
    #[error(transparent)]
    Face(#[from] FaceError),
    /// The edits are not a valid history.
    #[error(transparent)]
    Project(#[from] ProjectError),
    /// The edit has no solution.
    #[error(transparent)]
    Studio(#[from] StudioError),
}

/// Checks that a number is within its range; rejects NaN.
pub(crate) fn within(what: &'static str, value: f64, min: f64, max: f64) -> Result<f64, SessionError> {
    if value >= min && value <= max { Ok(value) } else { Err(SessionError::OutOfRange { what, value, min, max }) }
}

/// Clamps a factor to a usable range; rejects NaN.
pub(crate) fn bounded_factor(factor: f64) -> Result<f64, SessionError> {
    within("the factor", factor, f64::NEG_INFINITY, f64::INFINITY).map(|factor| factor.clamp(1e-3, 1e3))
}
