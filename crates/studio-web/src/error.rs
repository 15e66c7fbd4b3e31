use js_sys::{Error, Reflect};
use rosto_export::ReopenError;
use rosto_face::FaceError;
use rosto_session::SessionError;
use rosto_studio::StudioError;
use rosto_studio::project::ProjectError;
use rosto_viewport::{Backend, ViewportError};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Codes of the errors that this module throws; they are stable. */
export type StudioErrorCode =
    | "no-webgpu" | "no-webgl" | "no-adapter" | "no-device" | "canvas-in-use" | "device-lost"
    | "no-face" | "no-selection" | "bad-vertex" | "bad-face" | "bad-number" | "bad-choice"
    | "not-a-face" | "not-a-card" | "another-face" | "too-many-photos"
    | "cannot-solve" | "bad-history" | "too-many-edits" | "other-version"
    | "not-drawn" | "no-memory" | "internal";
/** A thrown error: `message` says what failed and `hint` what to do. */
export interface StudioError extends Error { code: StudioErrorCode; hint: string }
"#;

/// Code and hint of a file or history of another version.
const OTHER_VERSION: (&str, &str) =
    ("other-version", "Reload the page to get its newest version, or open the photo instead.");

/// Code and hint of a history that is too long or takes too long.
const TOO_MANY_EDITS: (&str, &str) = ("too-many-edits", "Undo some of the edits, or open an earlier copy of the file.");

/// The types of numbers in messages; serde's error about one ends with its type.
const NUMBERS: &str = "f64, u32, usize, u8";

/// An error of the façade; JavaScript receives it as an `Error` with `code` and `hint`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FacadeError {
    pub code: &'static str,
    pub message: String,
    pub hint: &'static str,
}

/// Result type of façade methods.
pub(crate) type Result<T, E = FacadeError> = std::result::Result<T, E>;

impl FacadeError {
    pub fn new(code: &'static str, message: impl Into<String>, hint: &'static str) -> Self {
        Self { code, message: message.into(), hint }
    }

    pub fn no_face() -> Self {
        Self::new("no-face", "no face is open", "Open a photo first.")
    }

    pub fn no_picture() -> Self {
        Self::new("bad-face", "no picture is open for this face", "Open the photo again.")
    }

    /// The error of a face's texts that cannot be read.
    pub fn of_saved(error: ReopenError) -> Self {
        match error {
            ReopenError::Face(FaceError::RecordVersion { .. }) | ReopenError::Version { .. } => {
                Self::new(OTHER_VERSION.0, error.to_string(), OTHER_VERSION.1)
            }
            ReopenError::Face(error) if !matches!(error, FaceError::PhotoCount { .. }) => error.into(),
            _ => Self::new("bad-history", error.to_string(), "Open an earlier copy of the file, or the photo."),
        }
    }

    /// The error of a message that is not an intent.
    pub fn of_message(error: &impl std::fmt::Display) -> Self {
        let message = error.to_string();
        let is_number = NUMBERS.split(", ").any(|number| message.ends_with(&format!("expected {number}")));
        match is_number {
            true => Self::new("bad-number", message, "Enter a number of this kind."),
            false => Self { message, ..Self::bad_choice() },
        }
    }

    pub fn bad_choice() -> Self {
        Self::new("bad-choice", "unknown choice", "Use one of the names in the module's types.")
    }
}

impl From<FacadeError> for JsValue {
    fn from(error: FacadeError) -> Self {
        let thrown = Error::new(&error.message);
        // Setting a property of a new error object does not fail.
        let _ = Reflect::set(&thrown, &"code".into(), &error.code.into());
        let _ = Reflect::set(&thrown, &"hint".into(), &error.hint.into());
        thrown.into()
    }
}

impl From<ViewportError> for FacadeError {
    fn from(error: ViewportError) -> Self {
        let (code, hint) = match error {
            ViewportError::NoAdapter(_) => ("no-adapter", "Update the browser or the graphics driver."),
            ViewportError::NoDevice(_) => ("no-device", "Close other pages that draw in 3D, then reload."),
            // The canvas has no other context, so the browser cannot provide one of this kind.
            ViewportError::CanvasInUse(_) if Backend::OF_THIS_BUILD == Backend::WebGl2 => {
                ("no-webgl", "Enable hardware acceleration in the browser.")
            }
            ViewportError::CanvasInUse(_) => ("canvas-in-use", "Reload the page."),
            ViewportError::DeviceLost(_) => ("device-lost", "Bind a new renderer to the canvas."),
            ViewportError::BadPicture { .. } => ("bad-face", "Open the photo again."),
            ViewportError::OutOfMemory { .. } => {
                ("no-memory", "Choose a smaller size, or close other pages that draw in 3D.")
            }
            ViewportError::NotRead | ViewportError::NotDrawn(_) => ("not-drawn", "Try again."),
            _ => ("internal", "Reload the page; saved work is offered again."),
        };
        Self::new(code, error.to_string(), hint)
    }
}

impl From<SessionError> for FacadeError {
    fn from(error: SessionError) -> Self {
        let message = error.to_string();
        let (code, hint) = match error {
            SessionError::NoFace => return Self::no_face(),
            SessionError::NothingSelected => ("no-selection", "Select a point first."),
            SessionError::NoSuchVertex { .. } => ("bad-vertex", "Choose an existing point."),
            SessionError::NoSuchWidget { .. } => ("bad-choice", "Use the id of a widget, and a value of its type."),
            SessionError::NoSuchPhoto { .. } => ("bad-number", "Choose an existing photo."),
            SessionError::OutOfRange { .. } => ("bad-number", "Enter a number in this range."),
            SessionError::BadHistory { .. } | SessionError::PhotoEdit(_) => {
                ("bad-history", "Open an earlier copy of the file, or the photo.")
            }
            SessionError::Preferences { .. } => ("bad-choice", "Choose the settings again."),
            SessionError::Face(error) => return error.into(),
            SessionError::Project(error) => return error.into(),
            SessionError::Studio(error) => return error.into(),
            _ => ("internal", "Reload the page; saved work is offered again."),
        };
        Self::new(code, message, hint)
    }
}

impl From<FaceError> for FacadeError {
    fn from(error: FaceError) -> Self {
        let (code, hint) = match error {
            FaceError::AnotherFace { .. } => ("another-face", "Choose another photo of the same face."),
            FaceError::Implausible | FaceError::NotAFace { .. } | FaceError::Folded { .. } => {
                ("not-a-face", "The file was damaged or changed. Open the photo instead.")
            }
            FaceError::NotACard => ("not-a-card", "Mark the card’s four corners again."),
            FaceError::PhotoCount { .. } => ("too-many-photos", "Remove another photo first."),
            _ => ("bad-face", "Try a photo in which the face is larger and looks towards the camera."),
        };
        Self::new(code, error.to_string(), hint)
    }
}

impl From<StudioError> for FacadeError {
    fn from(error: StudioError) -> Self {
        let message = error.to_string();
        match error {
            StudioError::TooManyEntries { .. } | StudioError::TooMuchWork { .. } => {
                Self::new(TOO_MANY_EDITS.0, message, TOO_MANY_EDITS.1)
            }
            StudioError::Entry { .. } | StudioError::TooDense { .. } => {
                Self::new("bad-history", message, "Open an earlier copy of the file, or the photo.")
            }
            StudioError::NoSuchEntry { .. } => Self::new("bad-number", message, "Choose an existing entry."),
            _ => Self::new("cannot-solve", message, "Choose another point, other fixed points or a larger radius."),
        }
    }
}

impl From<ProjectError> for FacadeError {
    fn from(error: ProjectError) -> Self {
        let (code, hint) = match error {
            ProjectError::Version { .. } => OTHER_VERSION,
            ProjectError::TooManyEntries { .. } => TOO_MANY_EDITS,
            _ => ("bad-history", "Open an earlier copy of the file, or the photo."),
        };
        Self::new(code, error.to_string(), hint)
    }
}
