use glam::DVec2;
use rosto_export::TextureSize;
use rosto_face::canonical_uvs;

use crate::OpenFace;

rosto_mesh::named! {
    /// Source of the 3D face's texture.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum TextureSource {
        /// The whole-face texture, in which areas that the photo does not show are filled in.
        #[default]
        Whole = "whole",
        /// The original photo, with the background that it shows behind the face.
        Photo = "photo",
    }
}

/// Requests of the whole-face texture, which the worker bakes and the caller holds.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct TextureRequests {
    /// Number of changes of the photos or their lenses, over all faces.
    changes: u32,
    /// The request whose texture is shown.
    shown: Option<u32>,
}

impl TextureRequests {
    /// Number of the request for the current photos in a size.
    pub(crate) fn number(&self, size: TextureSize) -> u32 {
        self.changes * TextureSize::ALL.len() as u32 + size as u32
    }

    /// Shows no texture after a change of the photos or their lenses.
    pub(crate) fn restart(&mut self) {
        (self.changes, self.shown) = (self.changes + 1, None);
    }

    pub(crate) fn shown(&self) -> Option<u32> {
        self.shown
    }

    pub(crate) fn show(&mut self, request: u32) {
        self.shown = Some(request);
    }
}

impl OpenFace {
    /// Texture coordinates in the whole-face texture of each displayed vertex.
    pub fn texture_uvs(&self) -> Vec<DVec2> {
        self.document().from_cage(&canonical_uvs())
    }
}
