//! The page's façade: studio, viewport and export behind wasm-bindgen.
//!
//! The page forwards intents and shows state; every decision about faces and meshes is made behind this façade. What is
//! thrown is an `Error` with a stable `code` and a `hint`. Nothing here is global, and no method holds the studio over
//! an `await`.

mod choices;
mod drag;
mod editing;
mod files;
mod follow;
mod hand;
mod modes;
mod names;
mod paper;
mod picture;
mod renderer;
mod reopened;
mod seeing;
mod selecting;
mod session;
mod sliding;
mod state;
mod studio;
mod trouble;

use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

pub use modes::{
    AnchorsName, AxisName, DetailsName, ExportEditsName, ExportPaintName, ExportShadingName, HandName, HoldName,
    LanguageName, MeshFormatName, OperatorName, PaintName, PointerName, TaskName, ThemeName, TriangulationName,
    UnitsName, ViewName,
};
pub use paper::{PaperClaims, PaperMethod, PaperRow, PaperRun};
pub use renderer::{Renderer, create_renderer};
pub use reopened::{ReopenedFace, reopen_glb};
pub use state::{NamedRegion, NamedSlider, ScreenPoint, Snapshot, StudioEntry, StudioState};
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
