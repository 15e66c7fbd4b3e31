use rosto_face::FaceError;
use serde_json::Value;
use thiserror::Error;

/// Reason why a file cannot be reopened.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ReopenError {
    /// The file does not start as binary glTF 2.0.
    #[error("this is not a binary glTF 2.0 file")]
    NotGlb,
    /// The file is truncated.
    #[error("the file has {found} bytes; its header says {expected}")]
    Truncated {
        /// Length according to the header.
        expected: usize,
        /// Actual length.
        found: usize,
    },
    /// The file's JSON is malformed.
    #[error("the file's JSON header cannot be read")]
    NotJson,
    /// Another program wrote the file, or rewrote it without Rosto's data.
    #[error("the file does not contain a Rosto face")]
    Foreign,
    /// Another version of Rosto wrote the file.
    #[error(
        "the file has version {found}, but this Rosto reads only version {known}; open it with the Rosto that wrote it"
    )]
    Version {
        /// Version of the file.
        found: u64,
        /// Supported version.
        known: u64,
    },
    /// A field is missing or invalid.
    #[error("the field {field:?} is missing or invalid")]
    Field {
        /// Name of the field.
        field: &'static str,
    },
    /// The stored face is damaged or no face.
    #[error(transparent)]
    Face(#[from] FaceError),
}

/// Error for a missing or invalid field.
pub(crate) fn field(field: &'static str) -> impl FnOnce() -> ReopenError {
    move || ReopenError::Field { field }
}

/// Refuses all versions except `known`.
pub(crate) fn check_version(value: &Value, known: u64) -> Result<(), ReopenError> {
    match value.as_u64().ok_or_else(field("version"))? {
        found if found == known => Ok(()),
        found => Err(ReopenError::Version { found, known }),
    }
}
