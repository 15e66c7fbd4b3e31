//! Vertex data in textures, because WebGL2 has no storage buffers.

use std::marker::PhantomData;

use bytemuck::Pod;

use crate::gpu::texture;
use crate::{Gpu, ViewportError};

/// Texels per row; same value as in `shaders/mesh.wgsl`.
const ROW: usize = 1024;
/// Bytes per texel: four floats.
const TEXEL: usize = 16;

/// One `T` per vertex in consecutive texels, row by row; `T` fills a whole number of texels.
#[derive(Debug)]
pub(crate) struct VertexData<T> {
    texture: wgpu::Texture,
    kind: PhantomData<T>,
}

impl<T: Pod> VertexData<T> {
    /// Allocates a texture for these values and writes them.
    ///
    /// # Errors
    /// [`ViewportError::TooManyVertices`].
    pub fn new(gpu: &Gpu, values: &[T]) -> Result<Self, ViewportError> {
        const { assert!(size_of::<T>().is_multiple_of(TEXEL), "T must fill whole texels") };
        let rows = size_of_val(values).div_ceil(ROW * TEXEL).max(1);
        if rows > gpu.largest_side_px() as usize {
            return Err(ViewportError::TooManyVertices(values.len()));
        }
        let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
        let size = [ROW as u32, rows as u32];
        let descriptor = texture("vertex data", size, wgpu::TextureFormat::Rgba32Float, usage);
        let data = Self { texture: gpu.device.create_texture(&descriptor), kind: PhantomData };
        data.write(gpu, values);
        Ok(data)
    }

    /// Replaces all values.
    pub fn write(&self, gpu: &Gpu, values: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(values);
        let (rows, rest) = bytes.split_at(bytes.len() / (ROW * TEXEL) * ROW * TEXEL);
        let row_count = rows.len() / (ROW * TEXEL);
        self.write_rows(gpu, rows, 0, extent(ROW, row_count));
        self.write_rows(gpu, rest, row_count as u32, extent(rest.len() / TEXEL, 1));
    }

    /// View for a bind group.
    pub fn view(&self) -> wgpu::TextureView {
        self.texture.create_view(&Default::default())
    }

    fn write_rows(&self, gpu: &Gpu, bytes: &[u8], first_row: u32, size: wgpu::Extent3d) {
        if bytes.is_empty() {
            return;
        }
        let position = wgpu::TexelCopyTextureInfo {
            origin: wgpu::Origin3d { x: 0, y: first_row, z: 0 },
            ..self.texture.as_image_copy()
        };
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(size.width * TEXEL as u32),
            rows_per_image: None,
        };
        gpu.queue.write_texture(position, bytes, layout, size);
    }
}

fn extent(width: usize, height: usize) -> wgpu::Extent3d {
    wgpu::Extent3d { width: width as u32, height: height as u32, depth_or_array_layers: 1 }
}
