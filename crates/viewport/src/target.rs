use crate::Gpu;
use crate::gpu::texture;
#[cfg(target_arch = "wasm32")]
use crate::{Backend, ViewportError, gpu};

/// Samples for each pixel.
pub(crate) const SAMPLES: u32 = 4;
/// What depth is kept in.
pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

/// Where frames go: a canvas, or a picture in memory.
#[derive(Debug)]
pub struct Target {
    place: Place,
    /// The format that shaders write, already encoded.
    pub(crate) format: wgpu::TextureFormat,
}

#[derive(Debug)]
enum Place {
    #[cfg(target_arch = "wasm32")]
    Surface(wgpu::Surface<'static>, wgpu::CompositeAlphaMode),
    Offscreen,
}

/// What one frame draws into.
pub(crate) enum Canvas {
    /// Draw into the texture, then present it.
    #[cfg(target_arch = "wasm32")]
    Ready(wgpu::SurfaceTexture),
    /// Nothing to present on; the frame is only counted.
    Offscreen,
    /// Not now: hidden, resized meanwhile, or late. Another frame will do.
    #[cfg(target_arch = "wasm32")]
    Later,
}

impl Target {
    /// Nothing to present on: pictures are read back with [`crate::Viewport::snapshot`].
    pub fn offscreen() -> Self {
        Self { place: Place::Offscreen, format: wgpu::TextureFormat::Rgba8Unorm }
    }

    /// A canvas of the page, with a GPU that draws on it.
    ///
    /// # Errors
    /// [`ViewportError::NoAdapter`], [`ViewportError::NoDevice`], or [`ViewportError::CanvasInUse`] if the canvas gives no
    /// context for this build's [`Backend`].
    #[cfg(target_arch = "wasm32")]
    pub async fn canvas(canvas: wgpu::web_sys::HtmlCanvasElement) -> Result<(Gpu, Self), ViewportError> {
        let instance = gpu::instance();
        let (gpu, adapter, surface) = match Backend::OF_THIS_BUILD {
            // The first context that a canvas gives is its only one: it is not touched before there is a device.
            Backend::WebGpu => {
                let (gpu, adapter) = Gpu::open(&instance, None).await?;
                (gpu, adapter, surface(&instance, canvas)?)
            }
            // Here the canvas's context is the device.
            Backend::WebGl2 => {
                let surface = surface(&instance, canvas)?;
                let (gpu, adapter) = Gpu::open(&instance, Some(&surface)).await?;
                (gpu, adapter, surface)
            }
        };
        let offered = surface.get_capabilities(&adapter);
        let format = offered.formats.iter().copied().find(|format| !format.is_srgb());
        let format = format.ok_or_else(|| ViewportError::CanvasInUse("it offers no format".into()))?;
        // wgpu says of both that they offer opaque canvases only. WebGPU has premultiplied ones, too, and a WebGL2 canvas is
        // one already.
        let alpha = match Backend::OF_THIS_BUILD {
            Backend::WebGpu => wgpu::CompositeAlphaMode::PreMultiplied,
            Backend::WebGl2 => wgpu::CompositeAlphaMode::Auto,
        };
        Ok((gpu, Self { place: Place::Surface(surface, alpha), format }))
    }

    /// Fits the canvas to a size in px.
    pub(crate) fn configure(&self, gpu: &Gpu, width: u32, height: u32) {
        match &self.place {
            #[cfg(target_arch = "wasm32")]
            Place::Surface(surface, alpha) => {
                surface.configure(&gpu.device, &configuration(self.format, *alpha, width, height));
            }
            Place::Offscreen => {
                let _ = (gpu, width, height);
            }
        }
    }

    /// What the next frame draws into.
    pub(crate) fn acquire(&self, gpu: &Gpu, width: u32, height: u32) -> Canvas {
        match &self.place {
            #[cfg(target_arch = "wasm32")]
            Place::Surface(surface, _) => match surface.get_current_texture() {
                wgpu::CurrentSurfaceTexture::Success(texture) | wgpu::CurrentSurfaceTexture::Suboptimal(texture) => {
                    Canvas::Ready(texture)
                }
                wgpu::CurrentSurfaceTexture::Outdated | wgpu::CurrentSurfaceTexture::Lost => {
                    self.configure(gpu, width, height);
                    Canvas::Later
                }
                _ => Canvas::Later,
            },
            Place::Offscreen => {
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

/// The multisampled colour and the depth that a frame of one size needs.
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
