use crate::{Gpu, ViewportError};

/// Samples for each pixel.
pub(crate) const SAMPLES: u32 = 4;
/// What depth is kept in.
pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

/// Where frames go: a canvas, or a picture in memory.
#[derive(Debug)]
pub struct Target {
    place: Place,
    /// The format that shaders write, always one that encodes sRGB by itself.
    pub(crate) format: wgpu::TextureFormat,
}

#[derive(Debug)]
enum Place {
    Surface { surface: wgpu::Surface<'static>, stored_format: wgpu::TextureFormat },
    Offscreen,
}

/// What one frame draws into.
pub(crate) enum Canvas {
    /// Draw into the view, then present.
    Ready(wgpu::SurfaceTexture, wgpu::TextureView),
    /// Nothing to present on; the frame is only counted.
    Offscreen,
    /// Not now: hidden, resized meanwhile, or late. Another frame will do.
    Later,
}

impl Target {
    /// Nothing to present on: pictures are read back with [`crate::Viewport::snapshot`].
    pub fn offscreen() -> Self {
        Self { place: Place::Offscreen, format: wgpu::TextureFormat::Rgba8UnormSrgb }
    }

    /// A canvas of the page.
    ///
    /// # Errors
    /// [`ViewportError::CanvasInUse`] if the canvas gives no WebGPU context.
    #[cfg(target_arch = "wasm32")]
    pub fn canvas(gpu: &Gpu, canvas: web_sys::HtmlCanvasElement) -> Result<Self, ViewportError> {
        let surface = gpu
            .instance
            .create_surface(wgpu::SurfaceTarget::Canvas(canvas))
            .map_err(|error| ViewportError::CanvasInUse(error.to_string()))?;
        let stored_format = surface
            .get_capabilities(&gpu.adapter)
            .formats
            .into_iter()
            .find(|format| format.add_srgb_suffix() != *format)
            .ok_or_else(|| ViewportError::CanvasInUse("no format of 8 bits".into()))?;
        let format = stored_format.add_srgb_suffix();
        Ok(Self { place: Place::Surface { surface, stored_format }, format })
    }

    /// Fits the canvas to a size in px.
    pub(crate) fn configure(&self, gpu: &Gpu, width: u32, height: u32) {
        if let Place::Surface { surface, stored_format } = &self.place {
            surface.configure(
                &gpu.device,
                &wgpu::SurfaceConfiguration {
                    usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                    format: *stored_format,
                    color_space: wgpu::SurfaceColorSpace::Auto,
                    width,
                    height,
                    present_mode: wgpu::PresentMode::AutoVsync,
                    desired_maximum_frame_latency: 1,
                    alpha_mode: wgpu::CompositeAlphaMode::PreMultiplied,
                    view_formats: vec![self.format],
                },
            );
        }
    }

    /// What the next frame draws into.
    pub(crate) fn acquire(&self, gpu: &Gpu, width: u32, height: u32) -> Canvas {
        let Place::Surface { surface, .. } = &self.place else {
            return Canvas::Offscreen;
        };
        match surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(texture) | wgpu::CurrentSurfaceTexture::Suboptimal(texture) => {
                let view = texture
                    .texture
                    .create_view(&wgpu::TextureViewDescriptor { format: Some(self.format), ..Default::default() });
                Canvas::Ready(texture, view)
            }
            wgpu::CurrentSurfaceTexture::Outdated | wgpu::CurrentSurfaceTexture::Lost => {
                self.configure(gpu, width, height);
                Canvas::Later
            }
            _ => Canvas::Later,
        }
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
