use rosto_export::TextureSize;
use rosto_face::Photo;
use rosto_studio::{texture_plan, texture_side_px};

use super::Session;
use crate::{Changed, SessionError, TextureSource};

/// The whole-face texture. A worker bakes it, because that takes longer than a frame; it is shown when it arrives.
impl Session {
    /// Side of the open face's texture in px: the selected size, limited by the resolution of its photos.
    pub fn texture_side_px(&self) -> Option<u32> {
        self.face().map(|face| texture_side_px(face.model(), self.view().texture_size.px()))
    }

    /// Side in px of the texture that the open face needs; `None` if it has it.
    pub fn texture_wanted_px(&self) -> Option<u32> {
        let there = self.face()?.texture.as_ref().map(Photo::width);
        self.texture_side_px().filter(|side_px| there != Some(*side_px))
    }

    pub(super) fn set_texture_source(&mut self, texture_source: TextureSource) -> Changed {
        self.view.texture_source = texture_source;
        Changed::Mesh
    }

    /// The current texture is shown until the new one arrives.
    pub(super) fn set_texture_size(&mut self, size: TextureSize) -> Changed {
        self.view.texture_size = size;
        Changed::Document
    }

    /// Plan of the texture as bytes for `rosto-texture`: everything except the pixels of the photos, the leading one
    /// first.
    ///
    /// # Errors
    /// [`SessionError::NoFace`].
    pub fn texture_plan(&self) -> Result<Vec<u8>, SessionError> {
        let model = self.open_face()?.model();
        let others: Vec<_> = model.views().iter().skip(1).map(|view| (&view.uvs[..], &view.camera)).collect();
        Ok(texture_plan(model, &others).to_bytes())
    }

    /// Sets the texture. A texture of another size than the wanted one is ignored, because it was baked for an earlier
    /// request.
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

    /// Whether the whole-face texture is displayed.
    pub fn shows_texture(&self) -> bool {
        self.view().texture_source == TextureSource::Whole && self.face().is_some_and(|face| face.texture.is_some())
    }
}
