use std::future::Future;

use glam::{DVec2, DVec3};
use rosto_stage::{Background, Stage};

use crate::error_scopes::ErrorScopes;
use crate::frame::FrameOnGpu;
use crate::gpu::texture;
use crate::mesh::{MeshOnGpu, filled};
use crate::passes::Drawn;
use crate::photo_layer::{PhotoLayerInput, PhotoLayerOnGpu};
use crate::pipelines::Pipelines;
use crate::snapshot::{Snapshot, copy};
use crate::target::{Attachments, Canvas, Target};
use crate::{Gpu, MeshInput, PictureOnGpu, ViewportError, passes, picture};

/// Draws a mesh on a target, as a stage shows it. What is on the GPU is all that it holds: the stage is the caller's.
#[derive(Debug)]
pub struct Viewport {
    gpu: Gpu,
    target: Target,
    shrink: wgpu::RenderPipeline,
    attachments: Attachments,
    drawn: Drawn,
}

impl Viewport {
    /// An empty viewport of 1×1 px.
    pub fn new(gpu: Gpu, target: Target) -> Self {
        let pipelines = Pipelines::new(&gpu, target.format);
        target.configure(&gpu, 1, 1);
        Self {
            shrink: picture::shrink_pipeline(&gpu),
            attachments: Attachments::new(&gpu, target.format, [1, 1]),
            drawn: Drawn {
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

    /// Resolves when the device is gone, as far as WebGPU tells: a canvas tells of WebGL2's end by an event of its own. The
    /// future borrows nothing.
    pub fn lost(&self) -> impl Future<Output = ()> + use<> {
        self.gpu.lost()
    }

    /// The size in device pixels that [`Self::resize`] would give the target: within what the GPU can draw.
    pub fn fitting(&self, width_px: u32, height_px: u32) -> [u32; 2] {
        let largest = self.gpu.largest_side_px();
        [width_px, height_px].map(|side| side.clamp(1, largest))
    }

    /// Fits the target to a size in device pixels, within what the GPU can draw, and gives the size that it has then: a
    /// stage's camera must know it before the next [`Self::draw`].
    pub fn resize(&mut self, width_px: u32, height_px: u32) -> [u32; 2] {
        let size = self.fitting(width_px, height_px);
        if self.attachments.size != size {
            self.attachments = Attachments::new(&self.gpu, self.target.format, size);
            self.target.configure(&self.gpu, size[0], size[1]);
        }
        size
    }

    /// Room for an upright picture in the GPU's memory. Its rows are to follow, and then [`Self::finish_picture`].
    ///
    /// # Errors
    /// [`ViewportError::BadPicture`] for one without area, or larger than the GPU takes.
    pub fn reserve_picture(&self, width: u32, height: u32) -> Result<PictureOnGpu, ViewportError> {
        picture::reserve(&self.gpu, width, height)
    }

    /// Writes whole rows of a picture from its row `first_row` on: sRGB with opaque alpha, four bytes a pixel.
    ///
    /// # Errors
    /// [`ViewportError::BadPicture`] for a part of a row, or more rows than the picture has.
    pub fn write_picture_rows(&self, picture: &PictureOnGpu, first_row: u32, rgba: &[u8]) -> Result<(), ViewportError> {
        picture::write_rows(&self.gpu, picture, first_row, rgba)
    }

    /// Makes a picture ready to be seen small, once all its rows are written; for [`MeshInput::picture`].
    pub fn finish_picture(&self, picture: &PictureOnGpu) {
        picture::finish(&self.gpu, &self.shrink, picture);
    }

    /// A texture for the frames of a camera stream, without mip levels: pixels change sixty times a second. Sizes are in px.
    ///
    /// # Errors
    /// As [`Self::reserve_picture`].
    pub fn reserve_camera_stream(&self, width: u32, height: u32) -> Result<PictureOnGpu, ViewportError> {
        picture::reserve_levels(&self.gpu, width, height, 1)
    }

    /// The next frame of a camera stream, which is to have its size.
    ///
    /// # Errors
    /// [`ViewportError::BadPicture`] for a bitmap of another size, or one that was closed.
    #[cfg(target_arch = "wasm32")]
    pub fn write_frame(
        &self,
        camera_stream: &PictureOnGpu,
        frame: &wgpu::web_sys::ImageBitmap,
    ) -> Result<(), ViewportError> {
        picture::write_bitmap(&self.gpu, camera_stream, frame)
    }

    /// Shows a mesh in place of the one before. No handle moves it yet: a stage's offsets must be zero until the next
    /// [`Self::set_fields`].
    ///
    /// As with all that changes the mesh, the stage does not notice: [`Stage::request_frame`].
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`] or [`ViewportError::TooManyVertices`].
    pub fn show(&mut self, input: &MeshInput<'_>) -> Result<(), ViewportError> {
        let blank = picture::blank(&self.gpu)?;
        self.drawn.mesh = Some(MeshOnGpu::new(&self.gpu, &self.drawn.pipelines, &blank, input)?);
        Ok(())
    }

    /// Moves the vertices, before what the handles add. Nothing without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_positions(&mut self, positions_m: &[DVec3]) -> Result<(), ViewportError> {
        self.drawn.mesh.as_mut().map_or(Ok(()), |mesh| mesh.write_positions(&self.gpu, positions_m))
    }

    /// Moves each vertex' place in the picture, 0..1 from its top left. Nothing without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_uvs(&mut self, uvs: &[DVec2]) -> Result<(), ViewportError> {
        self.drawn.mesh.as_mut().map_or(Ok(()), |mesh| mesh.write_uvs(&self.gpu, uvs))
    }

    /// Sets the shape that `rosto_stage::RenderSettings::before` blends to. Nothing without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_before(&mut self, positions_m: &[DVec3]) -> Result<(), ViewportError> {
        self.drawn.mesh.as_ref().map_or(Ok(()), |mesh| mesh.write_before(&self.gpu, positions_m))
    }

    /// Sets how each vertex follows up to two handles, for [`Stage::set_offsets_m`], and how far it is from them: 1 where
    /// `rosto_stage::RenderSettings::rim` is drawn. Call it after [`Self::set_positions`]. Nothing without a mesh.
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

    /// Sets the values, −1 to 1, that `rosto_stage::ShadingMode::Distortion` shows. Nothing without a mesh.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn set_scalars(&mut self, scalars: &[f64]) -> Result<(), ViewportError> {
        self.drawn.mesh.as_mut().map_or(Ok(()), |mesh| mesh.write_scalars(&self.gpu, scalars))
    }

    /// Has a picture that was taken of the mesh lie on its plane ([`Stage::set_picture`]), or none.
    pub fn show_photo_layer(&mut self, input: Option<&PhotoLayerInput<'_>>) {
        self.drawn.photo_layer = input.map(|input| PhotoLayerOnGpu::new(&self.gpu, &self.drawn.pipelines, input));
    }

    /// Moves the places of the picture that move. Nothing without a picture.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn move_photo_layer(&mut self, to_px: &[DVec2]) -> Result<(), ViewportError> {
        self.drawn.photo_layer.as_mut().map_or(Ok(()), |photo_layer| photo_layer.follow(&self.gpu, to_px))
    }

    /// The same where what moves is elsewhere in each picture, as in those of a camera stream. Nothing without a picture.
    ///
    /// # Errors
    /// [`ViewportError::LengthMismatch`].
    pub fn carry_photo_layer(&mut self, from_px: &[DVec2], to_px: &[DVec2]) -> Result<(), ViewportError> {
        self.drawn.photo_layer.as_mut().map_or(Ok(()), |photo_layer| photo_layer.carry(&self.gpu, from_px, to_px))
    }

    /// Draws if anything changed; true asks to be called again in the next frame. `time_ms` is any steady clock's.
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
            Canvas::Later => {
                stage.request_frame();
                return Ok(true);
            }
        }
        Ok(step.again)
    }

    /// A picture of what a stage shows in any size, as seen now; the canvas does not change. The future borrows nothing.
    ///
    /// # Errors
    /// [`ViewportError::DeviceLost`] at once; [`ViewportError::OutOfMemory`], [`ViewportError::NotDrawn`] or
    /// [`ViewportError::NotRead`] later.
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
