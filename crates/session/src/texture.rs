use glam::DVec2;
use rosto_face::{Photo, canonical_uvs};

use crate::OpenFace;

rosto_mesh::named! {
    /// Which picture is laid on the face in the round.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum TextureSource {
        /// One of the whole face: what the photo does not show is filled.
        #[default]
        Whole = "whole",
        /// The photo as it was taken, and whatever is behind the face in it.
        Photo = "photo",
    }
}

impl OpenFace {
    /// The texture of the whole face, once it is there.
    pub fn texture(&self) -> Option<&Photo> {
        self.texture.as_ref()
    }

    /// Places in that texture for every vertex shown.
    pub fn texture_uvs(&self) -> Vec<DVec2> {
        self.document().from_cage(&canonical_uvs())
    }
}
