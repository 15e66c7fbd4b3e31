use rosto_face::Photo;
use rosto_viewport::{PictureOnGpu, Viewport, ViewportError};

use crate::error::{FacadeError, Result};

/// The upright photo of a face: its pixels, for files and colours, and its GPU texture.
#[derive(Debug, Clone)]
pub(crate) struct OpenPicture {
    pub photo: Photo,
    pub on_gpu: PictureOnGpu,
}

impl OpenPicture {
    /// Uploads the picture to another GPU.
    pub fn on(&self, viewport: &Viewport) -> Result<Self> {
        Self::of(self.photo.clone(), viewport)
    }

    /// Uploads a picture.
    pub fn of(photo: Photo, viewport: &Viewport) -> Result<Self> {
        let on_gpu = viewport.reserve_picture(photo.width(), photo.height())?;
        viewport.write_picture_rows(&on_gpu, 0, &photo.rgbx())?;
        viewport.finish_picture(&on_gpu);
        Ok(Self { photo, on_gpu })
    }
}

/// A picture that arrives in rows. One call with millions of pixels would block the page, so each batch of rows comes
/// in a separate task.
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

    /// Adds the next rows, RGBA without alpha. Returns the picture once it is complete.
    pub fn add(mut self, viewport: &Viewport, rgba: &[u8]) -> Result<Result<OpenPicture, Self>> {
        let (width, height) = (self.width, self.height);
        let (row_bytes, found) = (width as usize * 3, rgba.len());
        let bad = |_| FacadeError::from(ViewportError::BadPicture { width, height, found });
        viewport.write_picture_rows(&self.on_gpu, (self.rgb.len() / row_bytes) as u32, rgba)?;
        let rows = Photo::from_rgbx(width, (rgba.len() / 4 / width as usize) as u32, rgba).map_err(bad)?;
        self.rgb.extend_from_slice(rows.pixels());
        if self.rgb.len() < row_bytes * height as usize {
            return Ok(Err(self));
        }
        viewport.finish_picture(&self.on_gpu);
        let photo = Photo::from_rgb(width, height, self.rgb).map_err(bad)?;
        Ok(Ok(OpenPicture { photo, on_gpu: self.on_gpu }))
    }
}
