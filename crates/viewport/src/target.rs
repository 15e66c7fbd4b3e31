use crate::Gpu;
#[cfg(target_arch = "wasm32")]
use crate::ViewportError;

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
    Surface(wgpu::Surface<'static>),
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

    /// A canvas of the page.
    ///
    /// # Errors
    /// [`ViewportError::CanvasInUse`] if the canvas gives no WebGPU context.
    #[cfg(target_arch = "wasm32")]
    pub fn canvas(gpu: &Gpu, canvas: wgpu::web_sys::HtmlCanvasElement) -> Result<Self, ViewportError> {
        let surface = gpu
            .instance
            .create_surface(wgpu::SurfaceTarget::Canvas(canvas))
            .map_err(|error| ViewportError::CanvasInUse(error.to_string()))?;
        let preferred = surface.get_capabilities(&gpu.adapter).formats.first().copied();
        let format = preferred.ok_or_else(|| ViewportError::CanvasInUse("it offers no format".into()))?;
        Ok(Self { place: Place::Surface(surface), format })
    }

    /// Fits the canvas to a size in px.
    pub(crate) fn configure(&self, gpu: &Gpu, width: u32, height: u32) {
        match &self.place {
            #[cfg(target_arch = "wasm32")]
            Place::Surface(surface) => surface.configure(&gpu.device, &configuration(self.format, width, height)),
            Place::Offscreen => {
                let _ = (gpu, width, height);
            }
        }
    }

    /// What the next frame draws into.
    pub(crate) fn acquire(&self, gpu: &Gpu, width: u32, height: u32) -> Canvas {
        match &self.place {
            #[cfg(target_arch = "wasm32")]
            Place::Surface(surface) => match surface.get_current_texture() {
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
fn configuration(format: wgpu::TextureFormat, width: u32, height: u32) -> wgpu::SurfaceConfiguration {
    wgpu::SurfaceConfiguration {
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        format,
        color_space: wgpu::SurfaceColorSpace::Auto,
        width,
        height,
        present_mode: wgpu::PresentMode::AutoVsync,
        desired_maximum_frame_latency: 1,
        alpha_mode: wgpu::CompositeAlphaMode::PreMultiplied,
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
            let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some("attachment"),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: SAMPLES,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&Default::default())
        };
        Self { colour: view(format), depth: view(DEPTH_FORMAT), size }
    }
}
