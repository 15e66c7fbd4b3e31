use crate::Gpu;
use crate::gpu::texture;
#[cfg(target_arch = "wasm32")]
use crate::{Backend, ViewportError, gpu};

/// Samples per pixel.
pub(crate) const SAMPLES: u32 = 4;
/// Format of the depth buffer.
pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

/// Destination of frames: a canvas, or none.
#[derive(Debug)]
pub struct Target {
    destination: Destination,
    /// Format of the colour attachment; shaders encode to sRGB themselves.
    pub(crate) format: wgpu::TextureFormat,
}

#[derive(Debug)]
enum Destination {
    #[cfg(target_arch = "wasm32")]
    Surface(wgpu::Surface<'static>, wgpu::CompositeAlphaMode),
    Offscreen,
}

/// Destination of one frame.
pub(crate) enum Canvas {
    /// Texture to draw into and present.
    #[cfg(target_arch = "wasm32")]
    Ready(wgpu::SurfaceTexture),
    /// Off screen: nothing to present.
    Offscreen,
    /// Canvas unavailable (hidden or resized); draw the next frame instead.
    #[cfg(target_arch = "wasm32")]
    Unavailable,
}

impl Target {
    /// Target without a canvas; pictures are read back with [`crate::Viewport::snapshot`].
    pub fn offscreen() -> Self {
        Self { destination: Destination::Offscreen, format: wgpu::TextureFormat::Rgba8Unorm }
    }

    /// Target for a canvas, with a device that can draw on it.
    ///
    /// # Errors
    /// [`ViewportError::NoAdapter`], [`ViewportError::NoDevice`], or [`ViewportError::CanvasInUse`] if the canvas has
    /// no context for this build's [`Backend`].
    #[cfg(target_arch = "wasm32")]
    pub async fn canvas(canvas: wgpu::web_sys::HtmlCanvasElement) -> Result<(Gpu, Self), ViewportError> {
        let instance = gpu::instance();
        let (gpu, adapter, surface) = match Backend::OF_THIS_BUILD {
            // A canvas keeps the first context it creates, so create one only when the device exists.
            Backend::WebGpu => {
                let (gpu, adapter) = Gpu::open(&instance, None).await?;
                (gpu, adapter, surface(&instance, canvas)?)
            }
            // With WebGL2, the canvas' context is the device.
            Backend::WebGl2 => {
                let surface = surface(&instance, canvas)?;
                let (gpu, adapter) = Gpu::open(&instance, Some(&surface)).await?;
                (gpu, adapter, surface)
            }
        };
        let offered = surface.get_capabilities(&adapter);
        let format = offered.formats.iter().copied().find(|format| !format.is_srgb());
        let format = format.ok_or_else(|| ViewportError::CanvasInUse("it supports no format".into()))?;
        // wgpu reports only opaque canvases. WebGPU also supports premultiplied alpha, and a WebGL2 canvas already uses
        // it.
        let alpha = match Backend::OF_THIS_BUILD {
            Backend::WebGpu => wgpu::CompositeAlphaMode::PreMultiplied,
            Backend::WebGl2 => wgpu::CompositeAlphaMode::Auto,
        };
        Ok((gpu, Self { destination: Destination::Surface(surface, alpha), format }))
    }

    /// Configures the canvas for a size in px.
    pub(crate) fn configure(&self, gpu: &Gpu, width: u32, height: u32) {
        match &self.destination {
            #[cfg(target_arch = "wasm32")]
            Destination::Surface(surface, alpha) => {
                surface.configure(&gpu.device, &configuration(self.format, *alpha, width, height));
            }
            Destination::Offscreen => {
                let _ = (gpu, width, height);
            }
        }
    }

    /// Acquires the destination of the next frame.
    pub(crate) fn acquire(&self, gpu: &Gpu, width: u32, height: u32) -> Canvas {
        match &self.destination {
            #[cfg(target_arch = "wasm32")]
            Destination::Surface(surface, _) => match surface.get_current_texture() {
                wgpu::CurrentSurfaceTexture::Success(texture) | wgpu::CurrentSurfaceTexture::Suboptimal(texture) => {
                    Canvas::Ready(texture)
                }
                wgpu::CurrentSurfaceTexture::Outdated | wgpu::CurrentSurfaceTexture::Lost => {
                    self.configure(gpu, width, height);
                    Canvas::Unavailable
                }
                _ => Canvas::Unavailable,
            },
            Destination::Offscreen => {
                let _ = (gpu, width, height);
                Canvas::Offscreen
            }
        }
    }
}

#[cfg(target_arch = "wasm32")]
fn surface(
    instance: &wgpu::Instance,
    canvas: wgpu::web_sys::HtmlCanvasElement,
) -> Result<wgpu::Surface<'static>, ViewportError> {
    let target = wgpu::SurfaceTarget::Canvas(canvas);
    instance.create_surface(target).map_err(|error| ViewportError::CanvasInUse(error.to_string()))
}

#[cfg(target_arch = "wasm32")]
fn configuration(
    format: wgpu::TextureFormat,
    alpha_mode: wgpu::CompositeAlphaMode,
    width: u32,
    height: u32,
) -> wgpu::SurfaceConfiguration {
    wgpu::SurfaceConfiguration {
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        format,
        color_space: wgpu::SurfaceColorSpace::Auto,
        width,
        height,
        present_mode: wgpu::PresentMode::AutoVsync,
        desired_maximum_frame_latency: 1,
        alpha_mode,
        view_formats: Vec::new(),
    }
}

/// Multisampled colour and depth attachments for frames of one size.
#[derive(Debug)]
pub(crate) struct Attachments {
    pub colour: wgpu::TextureView,
    pub depth: wgpu::TextureView,
    pub size: [u32; 2],
}

impl Attachments {
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat, size: [u32; 2]) -> Self {
        let view = |format| {
            let descriptor = texture("attachment", size, format, wgpu::TextureUsages::RENDER_ATTACHMENT);
            let descriptor = wgpu::TextureDescriptor { sample_count: SAMPLES, ..descriptor };
            gpu.device.create_texture(&descriptor).create_view(&Default::default())
        };
        Self { colour: view(format), depth: view(DEPTH_FORMAT), size }
    }
}
