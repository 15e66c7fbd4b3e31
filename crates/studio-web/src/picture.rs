use rosto_face::Photo;
use rosto_viewport::{PictureOnGpu, Viewport, ViewportError};

use crate::error::{FacadeError, Result};

/// The upright photo of a face: its pixels, for files and colours, and the same on the GPU.
#[derive(Debug, Clone)]
pub(crate) struct OpenPicture {
    pub photo: Photo,
    pub on_gpu: PictureOnGpu,
}

impl OpenPicture {
    /// The same picture on another GPU.
    pub fn on(&self, viewport: &Viewport) -> Result<Self> {
        Self::of(self.photo.clone(), viewport)
    }

    /// A picture brought to a GPU.
    pub fn of(photo: Photo, viewport: &Viewport) -> Result<Self> {
        let on_gpu = viewport.reserve_picture(photo.width(), photo.height())?;
        viewport.write_picture_rows(&on_gpu, 0, &rgba_of(&photo))?;
        viewport.finish_picture(&on_gpu);
        Ok(Self { photo, on_gpu })
    }
}

/// A picture on its way in. Millions of pixels at once would keep the page from answering, so they come some rows at a
/// time, each in a task of its own.
#[derive(Debug)]
pub(crate) struct IncomingPicture {
    width: u32,
    height: u32,
    rgb: Vec<u8>,
    on_gpu: PictureOnGpu,
}

impl IncomingPicture {
    pub fn new(viewport: &Viewport, width: u32, height: u32) -> Result<Self> {
        let on_gpu = viewport.reserve_picture(width, height)?;
        let rgb = Vec::with_capacity(width as usize * height as usize * 3);
        Ok(Self { width, height, rgb, on_gpu })
    }

    /// Takes the next rows, RGBA; alpha is left out. Gives the picture back, once it is whole.
    pub fn add(mut self, viewport: &Viewport, rgba: &[u8]) -> Result<Result<OpenPicture, Self>> {
        let row_bytes = self.width as usize * 3;
        let first_row = (self.rgb.len() / row_bytes) as u32;
        viewport.write_picture_rows(&self.on_gpu, first_row, rgba)?;
        push_rgb(&mut self.rgb, rgba);
        if self.rgb.len() < row_bytes * self.height as usize {
            return Ok(Err(self));
        }
        viewport.finish_picture(&self.on_gpu);
        let (width, height, found) = (self.width, self.height, self.rgb.len());
        let bad = |_| FacadeError::from(ViewportError::BadPicture { width, height, found });
        let photo = Photo::from_rgb(width, height, self.rgb).map_err(bad)?;
        Ok(Ok(OpenPicture { photo, on_gpu: self.on_gpu }))
    }
}

/// RGB of RGBA, its alpha left out.
pub(crate) fn rgb_of(rgba: &[u8]) -> Vec<u8> {
    let mut rgb = Vec::new();
    push_rgb(&mut rgb, rgba);
    rgb
}

/// Written in place: collected one by one, millions of bytes take three times as long.
fn push_rgb(rgb: &mut Vec<u8>, rgba: &[u8]) {
    let (start, pixels) = (rgb.len(), rgba.as_chunks::<4>().0);
    rgb.resize(start + pixels.len() * 3, 0);
    for (to, [red, green, blue, _]) in rgb[start..].as_chunks_mut::<3>().0.iter_mut().zip(pixels) {
        *to = [*red, *green, *blue];
    }
}

/// RGBA of opaque RGB.
pub(crate) fn rgba_of(photo: &Photo) -> Vec<u8> {
    let pixels = photo.pixels().as_chunks::<3>().0;
    let mut rgba = vec![u8::MAX; pixels.len() * 4];
    for (to, [red, green, blue]) in rgba.as_chunks_mut::<4>().0.iter_mut().zip(pixels) {
        *to = [*red, *green, *blue, u8::MAX];
    }
    rgba
}
