//! The page's façade: a session and a viewport behind wasm-bindgen.
//!
//! The page forwards intents and shows state; this translates both and decides nothing: see [`rosto_session`]. What is
//! thrown is an `Error` with a stable `code` and a `hint`. Nothing here is global, and no method holds the studio over
//! an `await`.

mod editing;
mod error;
mod files;
mod in_photo;
mod live_preview;
mod measuring;
mod modes;
mod names;
mod paper;
mod photo_panel;
mod photos;
mod picture;
mod pieces;
mod readable;
mod renderer;
mod reopened;
mod seeing;
mod selecting;
mod shown;
mod state;
mod studio;
mod texture;

use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

pub use files::{FileChoices, PrintedBody, usual_density};
pub use in_photo::PhotoWarp;
pub use modes::{ChangeName, FileKindName, PointerName, RefusalName, TaskName};
pub use paper::{PaperClaims, PaperMethod, PaperRow, PaperRun};
pub use photos::StudioPhoto;
pub use renderer::{Renderer, create_renderer};
pub use reopened::{ReopenedFace, ReopenedPhoto, reopen_glb, reopen_project, sniff_file};
pub use state::{ScreenPoint, Snapshot, StudioEntry, StudioRange, StudioSlider, StudioState, StudioTarget, StudioTick};
pub use studio::Studio;

/// Gets a GPU, binds it to the canvas, and opens an empty studio on it.
///
/// # Errors
/// `no-webgpu` or `no-webgl`, `no-adapter`, `no-device` or `canvas-in-use`.
#[wasm_bindgen]
pub async fn start(canvas: HtmlCanvasElement) -> Result<Studio, JsValue> {
    console_error_panic_hook::set_once();
    Ok(Studio::new(create_renderer(canvas).await?.into_viewport()))
}
