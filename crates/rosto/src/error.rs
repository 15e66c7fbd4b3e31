use rosto_export::{ExportError, ExportOption, ReopenError};
use rosto_face::FaceError;
use rosto_studio::StudioError;
use rosto_studio::project::ProjectError;
use thiserror::Error;

/// Why a request cannot be carried out.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// The observations do not give a face.
    #[error(transparent)]
    Face(#[from] FaceError),
    /// A photo shows no face.
    #[error("photo {}: no face found", photo + 1)]
    NoFace {
        /// Index of the photo.
        photo: usize,
    },
    /// The networks cannot be run.
    #[cfg(feature = "find")]
    #[error(transparent)]
    Landmarks(#[from] rosto_landmarks::LandmarksError),
    /// Edits in image coordinates were requested for a face in several photos.
    #[error("image coordinates belong to one photo; use millimetres")]
    SeveralPhotos,
    /// An edit has no solution.
    #[error("edit {number} ({target}): {reason}")]
    Edit {
        /// The edit, counted from 1.
        number: usize,
        /// The object that it edits, such as `vertex 4`, `vertex 7000@2` or `nose-width`.
        target: String,
        /// Why it has none.
        reason: StudioError,
    },
    /// The document cannot be made.
    #[error(transparent)]
    Studio(#[from] StudioError),
    /// The stored edits cannot be read.
    #[error(transparent)]
    Project(#[from] ProjectError),
    /// The stored photo-edit data cannot be read.
    #[error("the photo-edit data has a missing or invalid {field:?}")]
    PhotoEdit {
        /// The missing or invalid field.
        field: &'static str,
    },
    /// The photo edit has too many dabs.
    #[error("{found} dabs protect the photo; the maximum is {max}")]
    TooManyDabs {
        /// Number of dabs, with empty strokes.
        found: usize,
        /// Highest number.
        max: usize,
    },
    /// The photo to be drawn is not the lead photo of the face.
    #[error("the photo is {}×{} px, which is not the shape of the face's photo of {}×{} px", found_px[0], found_px[1], face_px[0], face_px[1])]
    OtherPhoto {
        /// Width and height of the photo.
        found_px: [u32; 2],
        /// Width and height of the photo in which the face was found.
        face_px: [u32; 2],
    },
    /// An option has no choice with this id.
    #[error("unknown {option} {text:?}; use one of {choices}")]
    UnknownChoice {
        /// Name of the option.
        option: &'static str,
        /// The unknown id.
        text: String,
        /// The ids, separated by commas.
        choices: String,
    },
    /// A number of an option is out of range, or not a number.
    #[error("invalid {option} {text:?}; expected {expected}")]
    Invalid {
        /// Name of the option.
        option: &'static str,
        /// The text passed.
        text: String,
        /// Description of valid texts.
        expected: &'static str,
    },
    /// An option has no effect on the file.
    #[error("{} has no effect: {reason}", option.id())]
    NoEffect {
        /// The option.
        option: ExportOption,
        /// Why it has none.
        reason: String,
    },
    /// Image coordinates were requested for another format than JSON.
    #[error("image coordinates can only be written as .json")]
    ImageUnits,
    /// The file is not one that Rosto wrote.
    #[error(transparent)]
    Reopen(#[from] ReopenError),
    /// The file cannot be written.
    #[error(transparent)]
    Export(#[from] ExportError),
}

impl Error {
    /// [`Self::UnknownChoice`] with the ids of the choices.
    pub fn unknown(option: &'static str, text: &str, choices: &[&str]) -> Self {
        Self::UnknownChoice { option, text: text.to_owned(), choices: choices.join(", ") }
    }

    pub(crate) fn invalid(option: &'static str, text: &str, expected: &'static str) -> Self {
        Self::Invalid { option, text: text.to_owned(), expected }
    }

    /// Suggested remedy, if there is one.
    pub fn hint(&self) -> Option<String> {
        let fixed = match self {
            Self::NoFace { .. } => {
                "Use a photo in which the face looks at the camera and fills at least a tenth of the picture."
            }
            Self::Edit { reason, .. } => return reason.hint(),
            Self::ImageUnits | Self::SeveralPhotos => "Use millimetres.",
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}
