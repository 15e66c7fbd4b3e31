use std::sync::{Arc, Mutex};

use crate::ViewportError;

/// A GPU device, obtained before any canvas is touched: the first context that a canvas gives is its only one.
#[derive(Debug)]
pub struct Gpu {
    /// Makes a canvas' surface; drawing off screen has no use for it.
    #[cfg(target_arch = "wasm32")]
    pub(crate) instance: wgpu::Instance,
    /// Tells what that surface can do.
    #[cfg(target_arch = "wasm32")]
    pub(crate) adapter: wgpu::Adapter,
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    lost: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Asks for a device with WebGPU's smallest common limits, so that phones pass too.
    ///
    /// # Errors
    /// [`ViewportError::NoAdapter`] or [`ViewportError::NoDevice`].
    pub async fn request() -> Result<Self, ViewportError> {
        let instance = wgpu::Instance::default();
        let adapter = instance
            .request_adapter(&wgpu::RequestAdapterOptions::default())
            .await
            .map_err(|error| ViewportError::NoAdapter(error.to_string()))?;
        let limits = wgpu::Limits::downlevel_defaults().using_resolution(adapter.limits());
        let descriptor = wgpu::DeviceDescriptor { label: Some("rosto"), required_limits: limits, ..Default::default() };
        let (device, queue) =
            adapter.request_device(&descriptor).await.map_err(|error| ViewportError::NoDevice(error.to_string()))?;
        let lost = Arc::new(Mutex::new(None));
        let report = Arc::clone(&lost);
        device.set_device_lost_callback(move |_, message| {
            if let Ok(mut lost) = report.lock() {
                *lost = Some(message);
            }
        });
        Ok(Self {
            #[cfg(target_arch = "wasm32")]
            instance,
            #[cfg(target_arch = "wasm32")]
            adapter,
            device,
            queue,
            lost,
        })
    }

    /// Fails once the device is gone.
    ///
    /// # Errors
    /// [`ViewportError::DeviceLost`].
    pub(crate) fn check(&self) -> Result<(), ViewportError> {
        let lost = self.lost.lock().ok().and_then(|lost| lost.clone());
        lost.map_or(Ok(()), |message| Err(ViewportError::DeviceLost(message)))
    }

    pub(crate) fn largest_side_px(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }
}
