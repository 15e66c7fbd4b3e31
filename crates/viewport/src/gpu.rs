use std::future::{Future, poll_fn};
use std::sync::{Arc, Mutex};
use std::task::{Context, Poll, Waker};

use crate::ViewportError;

/// Graphics API of the page. A build contains one, so that no code for the other is downloaded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Backend {
    /// WebGPU.
    WebGpu,
    /// WebGL2, for browsers without WebGPU; enabled by the feature `webgl`.
    WebGl2,
}

impl Backend {
    /// API of this build. WebGL2 exists only in browsers.
    pub const OF_THIS_BUILD: Self =
        if cfg!(all(feature = "webgl", target_arch = "wasm32")) { Self::WebGl2 } else { Self::WebGpu };
}

/// GPU device and queue.
#[derive(Debug)]
pub struct Gpu {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    loss: Arc<Mutex<Loss>>,
}

/// State of a device's loss, and the tasks that wait for it.
#[derive(Debug, Default)]
struct Loss {
    message: Option<String>,
    waiting: Vec<Waker>,
}

impl Gpu {
    /// Requests a device for drawing off screen; a canvas creates its device itself. Not available with WebGL2.
    ///
    /// # Errors
    /// [`ViewportError::NoAdapter`] or [`ViewportError::NoDevice`].
    pub async fn request() -> Result<Self, ViewportError> {
        Ok(Self::open(&instance(), None).await?.0)
    }

    /// Requests a device with the lowest common limits, which phones support; `surface` must be supported if given.
    pub(crate) async fn open(
        instance: &wgpu::Instance,
        surface: Option<&wgpu::Surface<'static>>,
    ) -> Result<(Self, wgpu::Adapter), ViewportError> {
        let wish = wgpu::RequestAdapterOptions { compatible_surface: surface, ..Default::default() };
        let adapter =
            instance.request_adapter(&wish).await.map_err(|error| ViewportError::NoAdapter(error.to_string()))?;
        let limits = match Backend::OF_THIS_BUILD {
            Backend::WebGpu => wgpu::Limits::downlevel_defaults(),
            Backend::WebGl2 => wgpu::Limits::downlevel_webgl2_defaults(),
        };
        let required_limits = limits.using_resolution(adapter.limits());
        let descriptor = wgpu::DeviceDescriptor { label: Some("rosto"), required_limits, ..Default::default() };
        let (device, queue) =
            adapter.request_device(&descriptor).await.map_err(|error| ViewportError::NoDevice(error.to_string()))?;
        let loss = Arc::new(Mutex::new(Loss::default()));
        let report = Arc::clone(&loss);
        device.set_device_lost_callback(move |_, message| {
            if let Ok(mut loss) = report.lock() {
                loss.report(message);
            }
        });
        Ok((Self { device, queue, loss }, adapter))
    }

    /// Returns an error after the device is lost.
    ///
    /// # Errors
    /// [`ViewportError::DeviceLost`].
    pub(crate) fn check(&self) -> Result<(), ViewportError> {
        let message = self.loss.lock().ok().and_then(|loss| loss.message.clone());
        message.map_or(Ok(()), |message| Err(ViewportError::DeviceLost(message)))
    }

    /// Resolves when the device is lost.
    pub(crate) fn lost(&self) -> impl Future<Output = ()> + use<> {
        let loss = Arc::clone(&self.loss);
        poll_fn(move |context| loss.lock().map_or(Poll::Ready(()), |mut loss| loss.poll(context)))
    }

    /// Bind group with these resources, in the order of the layout's bindings.
    pub(crate) fn bind_group<'a>(
        &self,
        layout: &wgpu::BindGroupLayout,
        resources: impl IntoIterator<Item = wgpu::BindingResource<'a>>,
    ) -> wgpu::BindGroup {
        let entries: Vec<_> =
            (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
        self.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
    }

    pub(crate) fn largest_side_px(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }
}

/// Frees the GPU's memory at once, rather than at the browser's next garbage collection.
impl Drop for Gpu {
    fn drop(&mut self) {
        if Backend::OF_THIS_BUILD == Backend::WebGpu {
            self.device.destroy();
        }
    }
}

impl Loss {
    fn report(&mut self, message: String) {
        self.message = Some(message);
        self.waiting.drain(..).for_each(Waker::wake);
    }

    fn poll(&mut self, context: &Context<'_>) -> Poll<()> {
        if self.message.is_some() {
            return Poll::Ready(());
        }
        self.waiting.push(context.waker().clone());
        Poll::Pending
    }
}

/// Descriptor of a texture with one mip level and one sample per pixel.
pub(crate) fn texture(
    label: &'static str,
    [width, height]: [u32; 2],
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::TextureDescriptor<'static> {
    wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    }
}

pub(crate) fn instance() -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    if Backend::OF_THIS_BUILD == Backend::WebGl2 {
        descriptor.backends = wgpu::Backends::GL;
        // Reading a buffer back already waits for the GPU; a fence would be signalled only in the page's next task.
        descriptor.backend_options.gl.fence_behavior = wgpu::GlFenceBehavior::AutoFinish;
    }
    wgpu::Instance::new(descriptor)
}
