//! The page's façade: a session and a viewport behind wasm-bindgen.
//!
//! The page applies intents and shows state, both as plain objects whose types [`rosto_session`] declares. Decisions are
//! there too; this crate uploads changes to the GPU. Errors are thrown as an `Error` with a stable `code` and a `hint`.
//! There is no global state, and no method borrows the studio across an `await`.

mod error;
mod files;
mod live_preview;
mod messages;
mod photo_panel;
mod photo_warp;
mod photos;
mod picture;
mod pieces;
mod print;
mod queries;
mod renderer;
mod sent;
mod shown;
mod snapshot;
mod studio;
mod texture;

use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

pub use messages::catalogue;
pub use renderer::{Renderer, create_renderer};
pub use snapshot::Snapshot;
pub use studio::Studio;

/// Replaces this instance of the module, whose memory may be corrupt after a trap. Call [`renew`] next, which creates the
/// new one; objects of the old one then throw.
#[wasm_bindgen(js_name = replaceInstance)]
pub fn replace_instance() {
    wasm_bindgen::handler::schedule_reinit();
}

/// Creates the new instance after [`replace_instance`].
///
/// Calls that return through memory must not do that: wasm-bindgen 0.2.130 would move the old instance's stack pointer
/// down by 16 bytes and the new one's up, so that the new stack would overlap static data.
#[wasm_bindgen]
pub fn renew() {}

/// Requests a GPU, binds it to the canvas, and creates an empty studio on it.
///
/// # Errors
/// `no-webgpu` or `no-webgl`, `no-adapter`, `no-device` or `canvas-in-use`.
#[wasm_bindgen]
pub async fn start(canvas: HtmlCanvasElement) -> Result<Studio, JsValue> {
    console_error_panic_hook::set_once();
    Ok(Studio::new(create_renderer(canvas).await?.into_viewport()))
}
