//! Errors for JavaScript: `Error` objects with a stable `code` and a `hint`.

use js_sys::{Error, Reflect};
use rosto_landmarks::LandmarksError;
use rosto_photo::PhotoError;

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

/// An internal error.
pub(crate) fn internal(message: &str) -> Error {
    thrown("internal", message, "Reload the page.")
}

fn thrown(code: &str, message: &str, hint: &str) -> Error {
    let error = Error::new(message);
    for (name, value) in [("code", code), ("hint", hint)] {
        Reflect::set(&error, &name.into(), &value.into()).expect("invariant: a new Error takes properties");
    }
    error
}
