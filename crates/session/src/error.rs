use rosto_export::ExportError;
use rosto_face::FaceError;
use rosto_studio::StudioError;
use rosto_studio::project::ProjectError;
use thiserror::Error;

/// Why an intent cannot be carried out. The session is as it was before.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SessionError {
    /// Only an open face has what is asked for.
    #[error("no face is open")]
    NoFace,
    /// Nothing is selected that could be moved, pinned or reset.
    #[error("nothing is selected")]
    NothingSelected,
    /// There is no such vertex, or no such landmark where landmarks are selected.
    #[error("there is no point {vertex}: there are {count}, counted from 0")]
    NoSuchVertex {
        /// The vertex asked for.
        vertex: u32,
        /// How many there are.
        count: usize,
    },
    /// There is no such photo of the face.
    #[error("there is no photo {photo}: there are {count}, counted from 0")]
    NoSuchPhoto {
        /// The photo asked for.
        photo: usize,
        /// How many there are.
        count: usize,
    },
    /// A number is beyond what it may be, or not one.
    #[error("{what} must lie between {least} and {most}, not at {value}")]
    OutOfRange {
        /// What the number is, with its unit.
        what: &'static str,
        /// The number given.
        value: f64,
        /// The least it may be.
        least: f64,
        /// The most it may be.
        most: f64,
    },
    /// A history is longer than any that is opened.
    #[error("the history has {found} entries; up to {most} can be opened")]
    TooManyEntries {
        /// How many it has.
        found: usize,
        /// How many it may have.
        most: usize,
    },
    /// An entry of a history moves something further than anything is moved.
    #[error("entry {entry} of the history moves something by {distance_m} m; the limit is {most_m} m")]
    BadHistory {
        /// Which entry, from 0.
        entry: usize,
        /// How far it moves it, in metres.
        distance_m: f64,
        /// How far it may, in metres.
        most_m: f64,
    },
    /// The text does not hold what was done to a photo alone.
    #[error("what was done to the photo has no usable {field:?}")]
    InPhoto {
        /// What is missing or not understood.
        field: &'static str,
    },
    /// The text does not hold preferences.
    #[error("the preferences have no usable {field:?}")]
    Preferences {
        /// What is missing or not understood.
        field: &'static str,
    },
    /// The landmarks make no face.
    #[error(transparent)]
    Face(#[from] FaceError),
    /// The edits are no history.
    #[error(transparent)]
    Project(#[from] ProjectError),
    /// The edit has no answer.
    #[error(transparent)]
    Studio(#[from] StudioError),
    /// The file cannot be made.
    #[error(transparent)]
    Export(#[from] ExportError),
}

/// Refuses a number that is not within its range, or is none.
pub(crate) fn within(what: &'static str, value: f64, least: f64, most: f64) -> Result<f64, SessionError> {
    if value >= least && value <= most { Ok(value) } else { Err(SessionError::OutOfRange { what, value, least, most }) }
}

/// A factor within reason: however far a wheel is turned, it is turned. Refuses what is no number.
pub(crate) fn bounded_factor(factor: f64) -> Result<f64, SessionError> {
    within("the factor", factor, f64::NEG_INFINITY, f64::INFINITY).map(|factor| factor.clamp(1e-3, 1e3))
}
