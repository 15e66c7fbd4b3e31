use rosto_viewport::{Gpu, Target, Viewport};
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

use crate::trouble::{Outcome, Trouble};

/// A GPU bound to a canvas. A lost one is replaced with `studio.useRenderer(await createRenderer(canvas))`.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Renderer {
    viewport: Viewport,
}

/// Gets a GPU, and only then binds it to the canvas.
///
/// # Errors
/// `no-webgpu`, `no-adapter`, `no-device` or `canvas-in-use`.
#[wasm_bindgen(js_name = createRenderer)]
pub async fn create_renderer(canvas: HtmlCanvasElement) -> Result<Renderer, JsValue> {
    Ok(bind(canvas).await?)
}

impl Renderer {
    pub(crate) fn into_viewport(self) -> Viewport {
        self.viewport
    }
}

async fn bind(canvas: HtmlCanvasElement) -> Outcome<Renderer> {
    if !browser_has_webgpu() {
        return Err(Trouble::new("no-webgpu", "this browser has no WebGPU", "Use a current Chrome, Edge or Safari."));
    }
    let gpu = Gpu::request().await?;
    let target = target(&gpu, canvas)?;
    Ok(Renderer { viewport: Viewport::new(gpu, target) })
}

fn browser_has_webgpu() -> bool {
    let navigator = web_sys::window().map(|window| window.navigator());
    navigator.is_some_and(|navigator| js_sys::Reflect::get(&navigator, &"gpu".into()).is_ok_and(|gpu| gpu.is_truthy()))
}

#[cfg(target_arch = "wasm32")]
fn target(gpu: &Gpu, canvas: HtmlCanvasElement) -> Outcome<Target> {
    Ok(Target::canvas(gpu, canvas)?)
}

/// Only a browser has canvases; elsewhere this crate is built for its tests alone.
#[cfg(not(target_arch = "wasm32"))]
fn target(_: &Gpu, _: HtmlCanvasElement) -> Outcome<Target> {
    Ok(Target::offscreen())
}
