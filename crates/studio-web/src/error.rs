use js_sys::{Error, Reflect};
use rosto_export::{ExportError, ReopenError, SolidError};
use rosto_face::FaceError;
use rosto_session::SessionError;
use rosto_studio::StudioError;
use rosto_studio::project::ProjectError;
use rosto_viewport::{Backend, ViewportError};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Codes of the errors that this module throws; they stay the same over time. */
export type StudioErrorCode =
    | "no-webgpu" | "no-webgl" | "no-adapter" | "no-device" | "canvas-in-use" | "device-lost"
    | "no-face" | "no-selection" | "bad-vertex" | "bad-face" | "bad-number" | "bad-choice"
    | "another-face" | "too-many-photos"
    | "cannot-solve" | "cannot-export" | "too-thick" | "no-body" | "surface-alone" | "bad-project" | "bad-history" | "other-version" | "damaged-glb" | "foreign-glb"
    | "not-drawn" | "no-memory" | "internal";
/** What is thrown: `message` says what happened, `hint` what to do next; `mostMm` how thick a wall may be that is too thick. */
export interface StudioError extends Error { code: StudioErrorCode; hint: string; mostMm?: number }
"#;

/// Code and hint of a file or history of another version.
const OTHER_VERSION: (&str, &str) =
    ("other-version", "Reload the page to get its newest version, or open the photo instead.");

/// What goes wrong on the way between the page and the core; reaches the page as an `Error` with `code` and `hint`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FacadeError {
    pub code: &'static str,
    pub message: String,
    pub hint: &'static str,
    /// The most in mm that would do, where a length is too large.
    pub most_mm: Option<f64>,
}

/// What façade methods return.
pub(crate) type Result<T, E = FacadeError> = std::result::Result<T, E>;

impl FacadeError {
    pub fn new(code: &'static str, message: impl Into<String>, hint: &'static str) -> Self {
        Self { code, message: message.into(), hint, most_mm: None }
    }

    pub fn no_face() -> Self {
        Self::new("no-face", "no face is open", "Open a photo first.")
    }

    pub fn no_picture() -> Self {
        Self::new("bad-face", "no picture was opened for this face", "Open the photo again.")
    }

    /// Of an id that nothing has.
    pub fn unless<T>(known: Option<T>) -> Result<T> {
        known.ok_or_else(Self::bad_choice)
    }

    /// Of a GLB that cannot be opened again.
    pub fn of_glb(error: ReopenError) -> Self {
        let (code, hint) = match error {
            ReopenError::Foreign => ("foreign-glb", "Open a GLB that was made here, or a photo."),
            ReopenError::Version { .. } => OTHER_VERSION,
            _ => ("damaged-glb", "Copy or download it again, or open the photo."),
        };
        Self::new(code, error.to_string(), hint)
    }

    /// Of a project file that cannot be opened.
    pub fn of_project(error: ReopenError) -> Self {
        let (code, hint) = match error {
            ReopenError::Version { .. } => OTHER_VERSION,
            _ => ("bad-project", "It may be incomplete. Open the photo instead."),
        };
        Self::new(code, error.to_string(), hint)
    }

    pub fn bad_choice() -> Self {
        Self::new("bad-choice", "there is no such choice", "Use one of the names in the module's types.")
    }
}

impl From<FacadeError> for JsValue {
    fn from(failure: FacadeError) -> Self {
        let error = Error::new(&failure.message);
        // An error object is extensible, so that all always succeed.
        let _ = Reflect::set(&error, &"code".into(), &failure.code.into());
        let _ = Reflect::set(&error, &"hint".into(), &failure.hint.into());
        if let Some(most_mm) = failure.most_mm {
            let _ = Reflect::set(&error, &"mostMm".into(), &most_mm.into());
        }
        error.into()
    }
}

impl From<ViewportError> for FacadeError {
    fn from(error: ViewportError) -> Self {
        let (code, hint) = match error {
            ViewportError::NoAdapter(_) => ("no-adapter", "Update the browser or the graphics driver."),
            ViewportError::NoDevice(_) => ("no-device", "Close other pages that draw in 3D, then reload."),
            // The page's canvas has no other context: the browser has none of this kind to give.
            ViewportError::CanvasInUse(_) if Backend::OF_THIS_BUILD == Backend::WebGl2 => {
                ("no-webgl", "Let the browser use the graphics card.")
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
            SessionError::NothingSelected => ("no-selection", "Choose a point first."),
            SessionError::NoSuchVertex { .. } => ("bad-vertex", "Choose a point that there is."),
            SessionError::NoSuchPhoto { .. } => ("bad-number", "Choose a photo that there is."),
            SessionError::OutOfRange { .. } => ("bad-number", "Give a number within these limits."),
            SessionError::TooManyEntries { .. } | SessionError::BadHistory { .. } | SessionError::PhotoEdit { .. } => {
                ("bad-history", "Open an earlier copy of it, or the photo instead.")
            }
            SessionError::Preferences { .. } => ("bad-choice", "Make the choices again."),
            SessionError::Face(error) => return error.into(),
            SessionError::Project(error) => return error.into(),
            SessionError::Studio(error) => return error.into(),
            SessionError::Export(error) => return error.into(),
            _ => ("internal", "Reload the page; saved work is offered again."),
        };
        Self::new(code, message, hint)
    }
}

impl From<FaceError> for FacadeError {
    fn from(error: FaceError) -> Self {
        let (code, hint) = match error {
            FaceError::AnotherFace { .. } => ("another-face", "Choose another photo of the same face."),
            FaceError::PhotoCount { .. } => ("too-many-photos", "Take another photo away first."),
            _ => ("bad-face", "Try a photo where the face is larger and looks towards the camera."),
        };
        Self::new(code, error.to_string(), hint)
    }
}

impl From<StudioError> for FacadeError {
    fn from(error: StudioError) -> Self {
        let message = error.to_string();
        match error {
            StudioError::Entry { .. } | StudioError::TooDense { .. } => {
                Self::new("bad-history", message, "Open an earlier copy of it, or the photo instead.")
            }
            StudioError::NoSuchEntry { .. } => Self::new("bad-number", message, "Choose an entry of the list."),
            _ => Self::new("cannot-solve", message, "Choose another point, other anchors or a larger radius."),
        }
    }
}

impl From<ExportError> for FacadeError {
    fn from(error: ExportError) -> Self {
        let (code, hint) = match error {
            ExportError::NoBody => ("surface-alone", "Choose a thickness or a flat back."),
            ExportError::Solid(SolidError::TooThick { .. }) => ("too-thick", "Choose a thinner wall, or a flat back."),
            ExportError::Solid(_) => ("no-body", "Choose another body, or undo the last edit."),
            _ => ("cannot-export", "Undo the last edit and try again."),
        };
        let most_mm = match error {
            ExportError::Solid(SolidError::TooThick { most_m, .. }) => Some(1000.0 * most_m),
            _ => None,
        };
        Self { most_mm, ..Self::new(code, error.to_string(), hint) }
    }
}

impl From<ProjectError> for FacadeError {
    fn from(error: ProjectError) -> Self {
        let (code, hint) = match error {
            ProjectError::Version { .. } => OTHER_VERSION,
            _ => ("bad-history", "Open an earlier copy of it, or the photo instead."),
        };
        Self::new(code, error.to_string(), hint)
    }
}
