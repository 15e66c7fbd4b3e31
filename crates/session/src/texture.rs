use glam::DVec2;
use rosto_face::{Photo, canonical_uvs};

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

impl OpenFace {
    /// The whole-face texture, if it is available.
    pub fn texture(&self) -> Option<&Photo> {
        self.texture.as_ref()
    }

    /// Texture coordinates in the whole-face texture of each displayed vertex.
    pub fn texture_uvs(&self) -> Vec<DVec2> {
        self.document().from_cage(&canonical_uvs())
    }
}
