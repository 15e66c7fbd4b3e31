use rosto_session::Session;
use rosto_viewport::{PictureOnGpu, Viewport};
use web_sys::ImageBitmap;

use crate::error::{FacadeError, Result};

/// An upright picture on the GPU. The browser holds its pixels, from which another GPU gets it.
#[derive(Debug)]
pub(crate) struct OpenPicture {
    bitmap: ImageBitmap,
    pub on_gpu: PictureOnGpu,
}

impl OpenPicture {
    /// Uploads a picture.
    pub fn new(bitmap: ImageBitmap, viewport: &Viewport) -> Result<Self> {
        let on_gpu = uploaded(&bitmap, viewport)?;
        Ok(Self { bitmap, on_gpu })
    }

    /// Width in px.
    pub fn width(&self) -> u32 {
        self.bitmap.width()
    }

    /// Height in px.
    fn height(&self) -> u32 {
        self.bitmap.height()
    }

    /// Texture of the picture on another GPU.
    fn on(&self, viewport: &Viewport) -> Result<PictureOnGpu> {
        uploaded(&self.bitmap, viewport)
    }
}

impl Drop for OpenPicture {
    /// Frees the pixels without waiting for the browser's garbage collector.
    fn drop(&mut self) {
        self.bitmap.close();
    }
}

/// The pictures of the open face, of the face to be opened next, and of the whole-face texture.
#[derive(Debug, Default)]
pub(crate) struct Pictures {
    /// Pictures with their keys.
    all: Vec<(String, OpenPicture)>,
    /// Keys of the open face's pictures, in the order of its photos.
    of_face: Vec<String>,
    pub texture: Option<OpenPicture>,
}

impl Pictures {
    /// Adds a picture, in place of another one with its key.
    pub fn add(&mut self, key: String, picture: OpenPicture) {
        self.all.retain(|(other, _)| *other != key);
        self.all.push((key, picture));
    }

    /// Checks that a picture was added.
    pub fn require(&self, key: &str) -> Result<()> {
        self.find(key).map(|_| ()).ok_or_else(FacadeError::no_picture)
    }

    /// Drops all pictures other than those of a newly opened face.
    pub fn open(&mut self, of_face: Vec<String>) {
        self.all.retain(|(key, _)| of_face.contains(key));
        (self.of_face, self.texture) = (of_face, None);
    }

    /// Adds a picture to those of the open face.
    pub fn add_to_face(&mut self, key: String) {
        self.of_face.push(key);
    }

    /// Removes a picture from those of the open face.
    pub fn remove_from_face(&mut self, photo: usize) {
        self.of_face.remove(photo);
    }

    /// Keys of the open face's pictures.
    pub fn of_face(&self) -> &[String] {
        &self.of_face
    }

    /// The picture of the open face's lead photo.
    pub fn lead(&self, session: &Session) -> Option<&OpenPicture> {
        self.find(self.of_face.get(session.face()?.lead_photo())?)
    }

    /// Width and height in px of the picture of one of the open face's photos.
    pub fn size_px(&self, photo: usize) -> Option<[u32; 2]> {
        self.find(self.of_face.get(photo)?).map(|picture| [picture.width(), picture.height()])
    }

    /// Drops a picture, unless the open face has it.
    pub fn discard(&mut self, key: &str) {
        self.all.retain(|(other, _)| other != key || self.of_face.contains(other));
    }

    /// Uploads all pictures to another GPU, or keeps the previous ones if one cannot be uploaded.
    pub fn move_to(&mut self, viewport: &Viewport) -> Result<()> {
        let uploaded: Vec<PictureOnGpu> = self.each().map(|picture| picture.on(viewport)).collect::<Result<_>>()?;
        let pictures = self.all.iter_mut().map(|(_, picture)| picture).chain(&mut self.texture);
        pictures.zip(uploaded).for_each(|(picture, on_gpu)| picture.on_gpu = on_gpu);
        Ok(())
    }

    fn each(&self) -> impl Iterator<Item = &OpenPicture> {
        self.all.iter().map(|(_, picture)| picture).chain(&self.texture)
    }

    fn find(&self, key: &str) -> Option<&OpenPicture> {
        self.all.iter().find(|(other, _)| other == key).map(|(_, picture)| picture)
    }
}

#[cfg(target_arch = "wasm32")]
fn uploaded(bitmap: &ImageBitmap, viewport: &Viewport) -> Result<PictureOnGpu> {
    let on_gpu = viewport.reserve_picture(bitmap.width(), bitmap.height())?;
    viewport.write_frame(&on_gpu, bitmap)?;
    viewport.finish_picture(&on_gpu);
    Ok(on_gpu)
}

/// Bitmaps exist only in browsers; other targets build this crate for its tests.
#[cfg(not(target_arch = "wasm32"))]
fn uploaded(bitmap: &ImageBitmap, viewport: &Viewport) -> Result<PictureOnGpu> {
    Ok(viewport.reserve_picture(bitmap.width(), bitmap.height())?)
}
