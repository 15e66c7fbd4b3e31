use rosto_viewport::{Backend, Gpu, Target, Viewport};
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

use crate::error::{FacadeError, Result};

/// A GPU bound to a canvas. To replace a lost one, call `studio.useRenderer(await createRenderer(canvas))`.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Renderer {
    viewport: Viewport,
}

/// Requests a GPU and binds it to the canvas. Without WebGPU the canvas stays untouched.
///
/// # Errors
/// `no-webgpu` or `no-webgl`, `no-adapter`, `no-device` or `canvas-in-use`.
#[wasm_bindgen(js_name = createRenderer)]
pub async fn create_renderer(canvas: HtmlCanvasElement) -> Result<Renderer, JsValue> {
    Ok(bind(canvas).await?)
}

impl Renderer {
    pub(crate) fn into_viewport(self) -> Viewport {
        self.viewport
    }
}

async fn bind(canvas: HtmlCanvasElement) -> Result<Renderer> {
    if Backend::OF_THIS_BUILD == Backend::WebGpu && !browser_has_webgpu() {
        return Err(FacadeError::new(
            "no-webgpu",
            "this browser has no WebGPU",
            "Use a current Chrome, Edge or Safari.",
        ));
    }
    let (gpu, target) = gpu_and_target(canvas).await?;
    Ok(Renderer { viewport: Viewport::new(gpu, target) })
}

fn browser_has_webgpu() -> bool {
    let navigator = web_sys::window().map(|window| window.navigator());
    navigator.is_some_and(|navigator| js_sys::Reflect::get(&navigator, &"gpu".into()).is_ok_and(|gpu| gpu.is_truthy()))
}

#[cfg(target_arch = "wasm32")]
async fn gpu_and_target(canvas: HtmlCanvasElement) -> Result<(Gpu, Target)> {
    Ok(Target::canvas(canvas).await?)
}

/// Canvases exist only in browsers; other targets build this crate for its tests.
#[cfg(not(target_arch = "wasm32"))]
async fn gpu_and_target(_: HtmlCanvasElement) -> Result<(Gpu, Target)> {
    Ok((Gpu::request().await?, Target::offscreen()))
}
