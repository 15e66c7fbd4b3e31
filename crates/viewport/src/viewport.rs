use std::future::Future;

use glam::{DVec2, DVec3};
use rosto_stage::{Background, Stage};

use crate::error_scopes::ErrorScopes;
use crate::frame::FrameOnGpu;
use crate::gpu::texture;
use crate::mesh::{MeshOnGpu, filled};
use crate::passes::FrameResources;
use crate::photo_layer::{PhotoLayerInput, PhotoLayerOnGpu};
use crate::pipelines::Pipelines;
use crate::snapshot::{Snapshot, copy};
use crate::target::{Attachments, Canvas, Target};
use crate::{Gpu, MeshInput, PictureOnGpu, ViewportError, passes, picture};

/// Draws a mesh as a stage describes it. It holds only GPU resources; the caller owns the stage.
#[derive(Debug)]
pub struct Viewport {
    gpu: Gpu,
    target: Target,
    shrink: wgpu::RenderPipeline,
    attachments: Attachments,
    drawn: FrameResources,
}

impl Viewport {
    /// An empty viewport of 1×1 px.
    pub fn new(gpu: Gpu, target: Target) -> Self {
        let pipelines = Pipelines::new(&gpu, target.format);
        target.configure(&gpu, 1, 1);
        Self {
            shrink: picture::shrink_pipeline(&gpu),
            attachments: Attachments::new(&gpu, target.format, [1, 1]),
            drawn: FrameResources {
                frame: FrameOnGpu::new(&gpu, &pipelines),
                frame_before: FrameOnGpu::new(&gpu, &pipelines),
                mesh: None,
                photo_layer: None,
                marks: filled(&gpu, &[], wgpu::BufferUsages::VERTEX),
                mark_count: 0,
                pipelines,
            },
            gpu,
            target,
        }
    }

    /// Resolves when the device is lost. WebGPU only: with WebGL2, the canvas fires an event instead. The future
    /// borrows nothing.
    pub fn lost(&self) -> impl Future<Output = ()> + use<> {
        self.gpu.lost()
    }

    /// Size in device pixels that [`Self::resize`] would set: the requested one, limited by the GPU.
    pub fn fitting(&self, width_px: u32, height_px: u32) -> [u32; 2] {
        let largest = self.gpu.largest_side_px();
        [width_px, height_px].map(|side| side.clamp(1, largest))
    }

    /// Resizes the target to device pixels, limited by the GPU, and returns the new size. Pass it to the stage's camera
    /// before the next [`Self::draw`].
    pub fn resize(&mut self, width_px: u32, height_px: u32) -> [u32; 2] {
        let size = self.fitting(width_px, height_px);
        if self.attachments.size != size {
            self.attachments = Attachments::new(&self.gpu, self.target.format, size);
            self.target.configure(&self.gpu, size[0], size[1]);
        }
        size
    }

    /// Allocates an upright picture in GPU memory. Write its rows, then call [`Self::finish_picture`].
    ///
    /// # Errors
    /// [`ViewportError::BadPicture`] if the picture is empty or exceeds the GPU's limit.
    pub fn reserve_picture(&self, width: u32, height: u32) -> Result<PictureOnGpu, ViewportError> {
        picture::reserve(&self.gpu, width, height)
    }

    /// Writes complete rows of a picture, starting at `first_row`: opaque sRGB, four bytes per pixel.
    ///
    /// # Errors
    /// [`ViewportError::BadPicture`] for incomplete rows or rows outside the picture.
    pub fn write_picture_rows(&self, picture: &PictureOnGpu, first_row: u32, rgba: &[u8]) -> Result<(), ViewportError> {
        picture::write_rows(&self.gpu, picture, first_row, rgba)
    }

    /// Computes the mip levels of a completely written picture, for [`MeshInput::picture`].
    pub fn finish_picture(&self, picture: &PictureOnGpu) {
        picture::finish(&self.gpu, &self.shrink, picture);
    }

    /// Allocates a texture for the frames of a camera stream, without mip levels, which would be too expensive per
    /// frame. Sizes are in px.
    ///
    /// # Errors
    /// See [`Self::reserve_picture`].
    pub fn reserve_camera_stream(&self, width: u32, height: u32) -> Result<PictureOnGpu, ViewportError> {
        picture::reserve_levels(&self.gpu, width, height, 1)
    }

    /// Writes the next frame of a camera stream.
    ///
    /// # Errors
    /// [`ViewportError::BadPicture`] if the bitmap is closed or has another size.
    #[cfg(target_arch = "wasm32")]
    pub fn write_frame(
        &self,
        camera_stream: &PictureOnGpu,
        frame: &wgpu::web_sys::ImageBitmap,
    ) -> Result<(), ViewportError> {
        picture::write_bitmap(&self.gpu, camera_stream, frame)
    }

    /// Replaces the mesh. It has no response fields: set the stage's offsets to zero until the next
    /// [`Self::set_fields`].
    ///
    /// Changes of the mesh do not request a frame; call [`Stage::request_frame`].
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`] or [`ViewportError::TooManyVertices`].
    pub fn show(&mut self, input: &MeshInput<'_>) -> Result<(), ViewportError> {
        let blank = picture::blank(&self.gpu)?;
        self.drawn.mesh = Some(MeshOnGpu::new(&self.gpu, &self.drawn.pipelines, &blank, input)?);
        Ok(())
    }

    /// Sets the vertex positions, before handles' offsets. No effect without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_positions(&mut self, positions_m: &[DVec3]) -> Result<(), ViewportError> {
        self.drawn.mesh.as_mut().map_or(Ok(()), |mesh| mesh.write_positions(&self.gpu, positions_m))
    }

    /// Sets the texture coordinates, 0..1 from the picture's top left. No effect without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_uvs(&mut self, uvs: &[DVec2]) -> Result<(), ViewportError> {
        self.drawn.mesh.as_mut().map_or(Ok(()), |mesh| mesh.write_uvs(&self.gpu, uvs))
    }

    /// Sets the original shape, to which `rosto_stage::RenderSettings::before` blends. No effect without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_before(&mut self, positions_m: &[DVec3]) -> Result<(), ViewportError> {
        self.drawn.mesh.as_ref().map_or(Ok(()), |mesh| mesh.write_before(&self.gpu, positions_m))
    }

    /// Sets the response fields of up to two handles, for [`Stage::set_offsets_m`], and the distances from them as
    /// multiples of the influence radius, for `rosto_stage::RenderSettings::rim`. Call it after
    /// [`Self::set_positions`]. No effect without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_fields(
        &mut self,
        fields: [Option<&[f64]>; 2],
        influence_distances: Option<&[f64]>,
    ) -> Result<(), ViewportError> {
        self.drawn.mesh.as_ref().map_or(Ok(()), |mesh| mesh.write_fields(&self.gpu, fields, influence_distances))
    }

    /// Sets the values, −1 to 1, for `rosto_stage::ShadingMode::Distortion`. No effect without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_scalars(&mut self, scalars: &[f64]) -> Result<(), ViewportError> {
        self.drawn.mesh.as_mut().map_or(Ok(()), |mesh| mesh.write_scalars(&self.gpu, scalars))
    }

    /// Sets or removes the picture drawn in its plane ([`Stage::set_picture`]).
    pub fn show_photo_layer(&mut self, input: Option<&PhotoLayerInput<'_>>) {
        self.drawn.photo_layer = input.map(|input| PhotoLayerOnGpu::new(&self.gpu, &self.drawn.pipelines, input));
    }

    /// Moves the points of the photo layer. No effect without one.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn move_photo_layer(&mut self, to_px: &[DVec2]) -> Result<(), ViewportError> {
        self.drawn.photo_layer.as_mut().map_or(Ok(()), |photo_layer| photo_layer.follow(&self.gpu, to_px))
    }

    /// Moves the points of the photo layer and sets new rest positions, as for frames of a camera stream. No effect
    /// without one.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn carry_photo_layer(&mut self, from_px: &[DVec2], to_px: &[DVec2]) -> Result<(), ViewportError> {
        self.drawn.photo_layer.as_mut().map_or(Ok(()), |photo_layer| photo_layer.carry(&self.gpu, from_px, to_px))
    }

    /// Draws after changes; returns whether to call again in the next frame. `time_ms` is from any monotonic clock.
    ///
    /// # Errors
    /// [`ViewportError::DeviceLost`].
    pub fn draw(&mut self, stage: &mut Stage, time_ms: f64) -> Result<bool, ViewportError> {
        self.gpu.check()?;
        let step = stage.advance(time_ms);
        if !step.draw {
            return Ok(step.again);
        }
        let [width, height] = self.attachments.size;
        match self.target.acquire(&self.gpu, width, height) {
            #[cfg(target_arch = "wasm32")]
            Canvas::Ready(surface) => {
                self.record_onto(stage, &surface.texture);
                self.gpu.queue.present(surface);
            }
            Canvas::Offscreen => {}
            #[cfg(target_arch = "wasm32")]
            Canvas::Unavailable => {
                stage.request_frame();
                return Ok(true);
            }
        }
        Ok(step.again)
    }

    /// Draws the stage in any size and reads the picture back; the canvas does not change. The future borrows nothing.
    ///
    /// # Errors
    /// [`ViewportError::DeviceLost`] immediately; the future returns [`ViewportError::OutOfMemory`],
    /// [`ViewportError::NotDrawn`] or [`ViewportError::NotRead`].
    pub fn snapshot(
        &mut self,
        stage: &Stage,
        size_px: [u32; 2],
        background: Background,
    ) -> Result<impl Future<Output = Result<Snapshot, ViewportError>> + use<>, ViewportError> {
        self.gpu.check()?;
        let size = self.fitting(size_px[0], size_px[1]);
        let mut resized = stage.clone();
        let scale = f64::from(size[1]) / stage.camera().size_px().y;
        resized.camera_mut().resize(size[0], size[1]);
        resized.set_pixel_ratio(stage.pixel_ratio() * scale);
        resized.render_settings_mut().background = background;
        let scopes = ErrorScopes::open(&self.gpu);
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let texture = self.gpu.device.create_texture(&texture("still", size, self.target.format, usage));
        let attachments = Attachments::new(&self.gpu, self.target.format, size);
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.upload(&resized);
        passes::record(&self.drawn, &resized, &mut encoder, &attachments, &texture.create_view(&Default::default()));
        let pending = copy(&self.gpu, &mut encoder, &texture);
        self.gpu.queue.submit([encoder.finish()]);
        let (drawn, device) = (scopes.close(size), self.gpu.device.clone());
        Ok(async move {
            drawn.await?;
            pending.read(&device).await
        })
    }

    #[cfg(target_arch = "wasm32")]
    fn record_onto(&mut self, stage: &Stage, texture: &wgpu::Texture) {
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.upload(stage);
        passes::record(&self.drawn, stage, &mut encoder, &self.attachments, &texture.create_view(&Default::default()));
        self.gpu.queue.submit([encoder.finish()]);
    }

    fn upload(&mut self, stage: &Stage) {
        self.drawn.frame.write(&self.gpu, &stage.uniforms());
        if stage.render_settings().wipe.is_some() {
            self.drawn.frame_before.write(&self.gpu, &stage.uniforms_before());
        }
        let words = stage.mark_words();
        self.drawn.mark_count = words.len() as u32;
        let bytes: &[u8] = bytemuck::cast_slice(&words);
        if bytes.len() as u64 > self.drawn.marks.size() {
            self.drawn.marks = filled(&self.gpu, bytes, wgpu::BufferUsages::VERTEX);
        } else if !bytes.is_empty() {
            self.gpu.queue.write_buffer(&self.drawn.marks, 0, bytes);
        }
    }
}
