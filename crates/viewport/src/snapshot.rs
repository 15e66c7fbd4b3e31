use futures_channel::oneshot;

use crate::{Gpu, ViewportError};

/// Picture read back from the GPU: sRGB with straight alpha, row by row from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Snapshot {
    /// Width in px.
    pub width: u32,
    /// Height in px.
    pub height: u32,
    /// Red, green, blue and alpha of each pixel.
    pub rgba: Vec<u8>,
}

impl Snapshot {
    /// Pixel in column `x` and row `y`.
    ///
    /// # Panics
    /// If the pixel is outside the picture.
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        assert!(x < self.width && y < self.height, "({x}, {y}) is outside {}×{} px", self.width, self.height);
        let start = 4 * (y as usize * self.width as usize + x as usize);
        [0, 1, 2, 3].map(|channel| self.rgba[start + channel])
    }
}

/// Read-back in progress. It borrows nothing, so that drawing can continue.
#[derive(Debug)]
pub(crate) struct Pending {
    buffer: wgpu::Buffer,
    padded_row: usize,
    size: [u32; 2],
    format: wgpu::TextureFormat,
}

/// Records a copy of a texture to a readable buffer.
pub(crate) fn copy(gpu: &Gpu, encoder: &mut wgpu::CommandEncoder, texture: &wgpu::Texture) -> Pending {
    let size = [texture.width(), texture.height()];
    let padded_row = (4 * size[0]).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("snapshot"),
        size: u64::from(padded_row) * u64::from(size[1]),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(padded_row), rows_per_image: Some(size[1]) };
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
        texture.size(),
    );
    Pending { buffer, padded_row: padded_row as usize, size, format: texture.format() }
}

impl Pending {
    /// Waits for the picture. Outside browsers, the caller must poll the device.
    pub async fn read(self, device: &wgpu::Device) -> Result<Snapshot, ViewportError> {
        let (answer, mapping) = oneshot::channel();
        self.buffer.map_async(wgpu::MapMode::Read, .., |result| drop(answer.send(result)));
        // WebGPU resolves the mapping by itself, WebGL2 needs a poll. A lost device fails the mapping.
        let _ = device.poll(wgpu::PollType::Poll);
        mapping.await.map(Result::ok).ok().flatten().ok_or(ViewportError::NotRead)?;
        let view = self.buffer.get_mapped_range(..).map_err(|_| ViewportError::NotRead)?;
        let [width, height] = self.size;
        let swapped = self.format == wgpu::TextureFormat::Bgra8Unorm;
        let mut rgba = Vec::new();
        let bytes = 4 * width as usize * height as usize;
        rgba.try_reserve_exact(bytes).map_err(|_| ViewportError::OutOfMemory { width, height })?;
        for row in view.chunks_exact(self.padded_row) {
            for pixel in row[..4 * width as usize].chunks_exact(4) {
                let [first, green, third, alpha] = [pixel[0], pixel[1], pixel[2], pixel[3]];
                let [red, blue] = if swapped { [third, first] } else { [first, third] };
                rgba.extend(straight([red, green, blue], alpha));
            }
        }
        Ok(Snapshot { width, height, rgba })
    }
}

/// Converts premultiplied to straight alpha.
fn straight(colour: [u8; 3], alpha: u8) -> [u8; 4] {
    let divide = |channel: u8| ((u32::from(channel) * 255 + u32::from(alpha) / 2) / u32::from(alpha)).min(255) as u8;
    let [red, green, blue] = if alpha == 0 { [0; 3] } else { colour.map(divide) };
    [red, green, blue, alpha]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn premultiplied_alpha_is_divided_out() {
        assert_eq!(straight([128, 64, 0], 128), [255, 128, 0, 128]);
        assert_eq!(straight([10, 20, 30], 255), [10, 20, 30, 255]);
        assert_eq!(straight([0; 3], 0), [0; 4]);
    }
}
