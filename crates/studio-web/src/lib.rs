//! The page's façade: a session and a viewport behind wasm-bindgen.
//!
//! The page forwards intents and shows state; this crate translates both. Decisions are in [`rosto_session`]. Errors
//! are thrown as an `Error` with a stable `code` and a `hint`. There is no global state, and no method borrows the
//! studio across an `await`.

mod appearance;
mod editing;
mod error;
mod files;
mod live_preview;
mod measuring;
mod modes;
mod names;
mod paper;
mod photo_panel;
mod photo_warp;
mod photos;
mod picture;
mod pieces;
mod readable;
mod renderer;
mod reopened;
mod selecting;
mod shown;
mod state;
mod studio;
mod texture;

use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

pub use files::{PrintedBody, StudioFileOptions, default_density};
pub use modes::{ChangeName, FileKindName, PointerName, RefusalName, TaskName};
pub use paper::{PaperClaims, PaperMethod, PaperRow, PaperRun};
pub use photo_warp::PhotoWarp;
pub use photos::StudioPhoto;
pub use renderer::{Renderer, create_renderer};
pub use reopened::{ReopenedFace, ReopenedPhoto, reopen_glb, reopen_project, sniff_file};
pub use state::{ScreenPoint, Snapshot, StudioEntry, StudioRange, StudioSlider, StudioState, StudioTarget, StudioTick};
pub use studio::Studio;

/// Requests a GPU, binds it to the canvas, and creates an empty studio on it.
///
/// # Errors
/// `no-webgpu` or `no-webgl`, `no-adapter`, `no-device` or `canvas-in-use`.
#[wasm_bindgen]
pub async fn start(canvas: HtmlCanvasElement) -> Result<Studio, JsValue> {
    console_error_panic_hook::set_once();
    Ok(Studio::new(create_renderer(canvas).await?.into_viewport()))
}
