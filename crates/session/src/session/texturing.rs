use rosto_export::TextureSize;

use super::Session;
use crate::{Changed, TextureSource};

/// The whole-face texture. A worker bakes it, because that takes longer than a frame; it is shown when it arrives.
impl Session {
    /// Number of the texture that the open face needs; `None` if it is shown. The number changes with the photos,
    /// their lenses and the selected size.
    pub fn texture_wanted(&self) -> Option<u32> {
        let wanted = self.face.as_ref().map(|_| self.textures.number(self.view.texture_size));
        wanted.filter(|wanted| self.textures.shown() != Some(*wanted))
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

    /// Reports that a texture has arrived. An outdated one is ignored.
    pub fn take_texture(&mut self, request: u32) -> Changed {
        if self.texture_wanted() != Some(request) {
            return Changed::Nothing;
        }
        self.textures.show(request);
        Changed::Mesh
    }

    /// Whether the whole-face texture is displayed.
    pub fn shows_texture(&self) -> bool {
        let is_there = self.face.is_some() && self.textures.shown().is_some();
        self.view.texture_source == TextureSource::Whole && is_there
    }
}
