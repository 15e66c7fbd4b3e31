use js_sys::{Error, Reflect};
use rosto_export::{ExportError, ReopenError};
use rosto_face::FaceError;
use rosto_laplacian::LaplacianError;
use rosto_studio::StudioError;
use rosto_studio::project::ProjectError;
use rosto_viewport::{Backend, ViewportError};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Codes of the errors that this module throws; they stay the same over time. */
export type StudioErrorCode =
    | "no-webgpu" | "no-webgl" | "no-adapter" | "no-device" | "canvas-in-use" | "device-lost"
    | "no-face" | "no-selection" | "bad-vertex" | "bad-face" | "bad-number" | "bad-choice" | "bad-anchors"
    | "cannot-solve" | "cannot-export" | "bad-project" | "damaged-glb" | "foreign-glb" | "newer-glb"
    | "not-drawn" | "internal";
/** What is thrown: `message` says what happened, `hint` what to do next. */
export interface StudioError extends Error { code: StudioErrorCode; hint: string }
"#;

/// What goes wrong on the way between the page and the core; reaches the page as an `Error` with `code` and `hint`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Trouble {
    pub code: &'static str,
    pub message: String,
    pub hint: &'static str,
}

/// What façade methods return.
pub(crate) type Outcome<T> = Result<T, Trouble>;

impl Trouble {
    pub fn new(code: &'static str, message: impl Into<String>, hint: &'static str) -> Self {
        Self { code, message: message.into(), hint }
    }

    pub fn no_face() -> Self {
        Self::new("no-face", "no face is open", "Open a photo first.")
    }

    pub fn no_picture() -> Self {
        Self::new("bad-face", "no picture was opened for this face", "Open the photo again.")
    }

    pub fn no_selection() -> Self {
        Self::new("no-selection", "no landmark is held", "Choose a landmark first.")
    }

    pub fn no_entry() -> Self {
        Self::new("bad-number", "there is no such entry of the history", "Choose an entry of the list.")
    }

    pub fn bad_number(what: &str) -> Self {
        Self::new("bad-number", format!("{what} is not a finite number"), "Give a number.")
    }

    pub fn bad_choice() -> Self {
        Self::new("bad-choice", "there is no such choice", "Use one of the names in the module's types.")
    }

    pub fn bad_vertex(vertex: u32, count: usize) -> Self {
        Self::new(
            "bad-vertex",
            format!("there is no landmark {vertex}: there are {count}"),
            "Choose one from 0 to 467.",
        )
    }
}

impl From<Trouble> for JsValue {
    fn from(trouble: Trouble) -> Self {
        let error = Error::new(&trouble.message);
        // An error object is extensible, so that both always succeed.
        let _ = Reflect::set(&error, &"code".into(), &trouble.code.into());
        let _ = Reflect::set(&error, &"hint".into(), &trouble.hint.into());
        error.into()
    }
}

impl From<ViewportError> for Trouble {
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
            ViewportError::NotRead => ("not-drawn", "Try again."),
            _ => ("internal", "Reload the page; saved work is offered again."),
        };
        Self::new(code, error.to_string(), hint)
    }
}

impl From<FaceError> for Trouble {
    fn from(error: FaceError) -> Self {
        Self::new("bad-face", error.to_string(), "Try a photo where the face is larger and looks towards the camera.")
    }
}

impl From<StudioError> for Trouble {
    fn from(error: StudioError) -> Self {
        let message = error.to_string();
        match error {
            StudioError::Laplacian(LaplacianError::NoSuchVertex { vertex, vertex_count }) => {
                Self::bad_vertex(vertex, vertex_count)
            }
            StudioError::Laplacian(
                LaplacianError::PinnedHandle { .. }
                | LaplacianError::Unanchored { .. }
                | LaplacianError::Repeated { .. },
            ) => Self::new("bad-anchors", message, "Choose anchors that are not the landmark itself."),
            StudioError::NothingHeld => Self::no_selection(),
            StudioError::OffsetNotFinite { .. } => Self::bad_number("the offset"),
            StudioError::NoSuchEntry { .. } => Self::new("bad-number", message, "Choose an entry of the list."),
            _ => Self::new("cannot-solve", message, "Choose another landmark, other anchors or a larger radius."),
        }
    }
}

impl From<ExportError> for Trouble {
    fn from(error: ExportError) -> Self {
        Self::new("cannot-export", error.to_string(), "Undo the last edit and try again.")
    }
}

impl From<ReopenError> for Trouble {
    fn from(error: ReopenError) -> Self {
        let (code, hint) = match error {
            ReopenError::Foreign => ("foreign-glb", "Open a GLB that was made here, or a photo."),
            ReopenError::Newer { .. } => ("newer-glb", "Reload the page to get its newest version."),
            _ => ("damaged-glb", "Copy or download it again, or open the photo."),
        };
        Self::new(code, error.to_string(), hint)
    }
}

impl From<ProjectError> for Trouble {
    fn from(error: ProjectError) -> Self {
        Self::new("bad-project", error.to_string(), "It may be incomplete or from a newer version.")
    }
}
