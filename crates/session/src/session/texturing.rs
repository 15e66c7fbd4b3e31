use rosto_export::TextureSize;
use rosto_face::Photo;
use rosto_studio::{texture_plan, texture_side_px};

use super::Session;
use crate::{Changed, SessionError, TextureSource};

/// The texture of the whole face is made elsewhere, since it takes longer than a frame, and is shown once it is there.
impl Session {
    /// How long the side of the open face's texture is, or is to be, in px: no longer than what was chosen, nor than its photos
    /// can fill.
    pub fn texture_side_px(&self) -> Option<u32> {
        self.face().map(|face| texture_side_px(face.model(), self.view().texture_size.px()))
    }

    /// How long the side of a texture is to be, in px, that the open face lacks; none where it lacks none.
    pub fn texture_wanted_px(&self) -> Option<u32> {
        let there = self.face()?.texture.as_ref().map(Photo::width);
        self.texture_side_px().filter(|side_px| there != Some(*side_px))
    }

    pub(super) fn set_texture_source(&mut self, texture_source: TextureSource) -> Changed {
        self.view.texture_source = texture_source;
        Changed::Mesh
    }

    /// The texture that is there is shown until the other one is.
    pub(super) fn set_texture_size(&mut self, size: TextureSize) -> Changed {
        self.view.texture_size = size;
        Changed::Document
    }

    /// What it is made of but for the pixels of the photos, the one that leads first: a plan as bytes, of which `rosto-texture`
    /// makes it.
    ///
    /// # Errors
    /// [`SessionError::NoFace`].
    pub fn texture_plan(&self) -> Result<Vec<u8>, SessionError> {
        let model = self.open_face()?.model();
        let others: Vec<_> = model.views().iter().skip(1).map(|view| (&view.uvs[..], &view.camera)).collect();
        Ok(texture_plan(model, &others).to_bytes())
    }

    /// Takes the texture, which changes nothing but what is seen. One that is not as large as the one that is wanted is
    /// passed over: it was made for something else.
    pub fn take_texture(&mut self, texture: Photo) -> Changed {
        let is_wanted = self.texture_wanted_px() == Some(texture.width());
        match self.face.as_mut().filter(|_| is_wanted) {
            Some(face) => {
                face.texture = Some(texture);
                Changed::Mesh
            }
            None => Changed::Nothing,
        }
    }

    /// Whether the texture of the whole face is what is seen of the open one.
    pub fn shows_texture(&self) -> bool {
        self.view().texture_source == TextureSource::Whole && self.face().is_some_and(|face| face.texture.is_some())
    }
}
