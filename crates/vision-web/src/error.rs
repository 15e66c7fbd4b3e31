//! Errors for JavaScript: `Error` objects with a stable `code` and a `hint`.

use js_sys::{Error, Reflect};
use rosto_export::{ExportError, ReopenError, SolidError};
use rosto_face::FaceError;
use rosto_landmarks::LandmarksError;
use rosto_photo::PhotoError;
use rosto_studio::StudioError;
use wasm_bindgen::JsValue;

/// Result type of the façade's methods.
pub(crate) type Result<T> = std::result::Result<T, Error>;

const ANOTHER_VERSION: &str = "other-version";
const ANOTHER_VERSION_HINT: &str = "Reload the page to get its newest version, or open the photo instead.";

const NOT_A_FACE: (&str, &str) = ("not-a-face", "The file was damaged or changed. Open the photo instead.");

/// Converts an error of the photo.
pub(crate) fn of_photo(error: PhotoError) -> Error {
    let code = match error {
        PhotoError::NotAPicture => "not-a-picture",
        PhotoError::UnsupportedFormat { .. } | PhotoError::UnsupportedFeature { .. } => "unsupported-format",
        PhotoError::Damaged { .. } | PhotoError::WrongLength { .. } => "damaged-picture",
        PhotoError::TooManyBytes { .. } => "too-many-bytes",
        PhotoError::TooManyPixels { .. } => "too-many-pixels",
        _ => "internal",
    };
    thrown(code, &error.to_string(), error.hint())
}

/// Converts an error of the networks.
pub(crate) fn of_landmarks(error: LandmarksError) -> Error {
    match error {
        LandmarksError::NetworkDamaged { .. } => {
            thrown("networks-damaged", &error.to_string(), "Reload the page; a file was damaged in transfer.")
        }
        _ => thrown("internal", &error.to_string(), "Try another photo, and please report this one."),
    }
}

/// Converts an error of a GLB that cannot be reopened.
pub(crate) fn of_glb(error: ReopenError) -> Error {
    let (code, hint) = match &error {
        ReopenError::Face(error) if is_not_a_face(error) => NOT_A_FACE,
        ReopenError::Foreign => ("foreign-glb", "Open a GLB that Rosto wrote, or a photo."),
        _ if is_another_version(&error) => (ANOTHER_VERSION, ANOTHER_VERSION_HINT),
        _ => ("damaged-glb", "Copy or download the file again, or open the photo."),
    };
    thrown(code, &error.to_string(), hint)
}

/// Converts an error of a project file that cannot be opened.
pub(crate) fn of_project(error: ReopenError) -> Error {
    let (code, hint) = match &error {
        ReopenError::Face(error) if is_not_a_face(error) => NOT_A_FACE,
        _ if is_another_version(&error) => (ANOTHER_VERSION, ANOTHER_VERSION_HINT),
        _ => ("bad-project", "The file may be incomplete. Open the photo instead."),
    };
    thrown(code, &error.to_string(), hint)
}

fn is_not_a_face(error: &FaceError) -> bool {
    use FaceError::{Degenerate, Folded, Implausible, NotAFace, NotFinite};
    matches!(error, Degenerate | Folded { .. } | Implausible | NotAFace { .. } | NotFinite { .. })
}

fn is_another_version(error: &ReopenError) -> bool {
    matches!(error, ReopenError::Version { .. } | ReopenError::Face(FaceError::RecordVersion { .. }))
}

/// Converts an error of a request's face or file.
pub(crate) fn of_request(error: rosto::Error) -> Error {
    let message = error.to_string();
    match error {
        rosto::Error::Export(error) => of_export(&error),
        rosto::Error::UnknownChoice { .. } | rosto::Error::Invalid { .. } => bad_choice(&message),
        rosto::Error::Reopen(error) if is_another_version(&error) => {
            thrown(ANOTHER_VERSION, &message, ANOTHER_VERSION_HINT)
        }
        rosto::Error::Face(_) | rosto::Error::OtherPhoto { .. } => {
            thrown("bad-face", &message, "Open the photo again.")
        }
        _ => thrown("bad-history", &message, "Open an earlier copy of the file, or the photo."),
    }
}

/// Converts an error of an operator or a solve.
pub(crate) fn of_studio(error: &StudioError) -> Error {
    thrown("cannot-solve", &error.to_string(), "Open another photo.")
}

fn of_export(error: &ExportError) -> Error {
    let message = error.to_string();
    match error {
        ExportError::NoBody => thrown("surface-alone", &message, "Choose a thickness or a flat back."),
        ExportError::Solid(SolidError::TooThick { most_m, .. }) => {
            let thrown = thrown("too-thick", &message, "Choose a thinner wall, or a flat back.");
            with(&thrown, "maxMm", &(1000.0 * most_m).into());
            thrown
        }
        ExportError::Solid(_) => thrown("no-body", &message, "Choose another body, or undo the last edit."),
        _ => thrown("cannot-export", &message, "Undo the last edit and try again."),
    }
}

/// Converts `None`, the result of an unknown id, to an error.
pub(crate) fn require<T>(value: Option<T>) -> Result<T> {
    value.ok_or_else(|| bad_choice("unknown choice"))
}

/// An argument of another type, or an unknown id.
pub(crate) fn bad_choice(message: &str) -> Error {
    thrown("bad-choice", message, "Use the names and types in the module's declarations.")
}

/// An internal error.
pub(crate) fn internal(message: &str) -> Error {
    thrown("internal", message, "Reload the page.")
}

fn thrown(code: &str, message: &str, hint: &str) -> Error {
    let error = Error::new(message);
    with(&error, "code", &code.into());
    with(&error, "hint", &hint.into());
    error
}

fn with(error: &Error, name: &str, value: &JsValue) {
    Reflect::set(error, &name.into(), value).expect("invariant: a new Error takes properties");
}
