use rosto_face::{FaceInput, Photo, PhotoLens};

/// A further photo of a face, and what was found in it.
#[derive(Debug, Clone, PartialEq)]
pub struct FurtherPhoto {
    /// MediaPipe's normalised landmarks: 468, or 478 with the irises.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo that they were found in.
    pub photo_size_px: [u32; 2],
    /// The colour under each landmark, sRGB: 468.
    pub colours_srgb: Vec<[u8; 3]>,
    /// The upright picture, perhaps scaled down.
    pub picture: Photo,
    /// Lens data of the photo.
    pub lens: PhotoLens,
}

impl FurtherPhoto {
    /// As a model takes it.
    pub(crate) fn input(&self) -> FaceInput<'_> {
        let [width, height] = self.photo_size_px;
        let Self { landmarks, colours_srgb: colours, lens, .. } = self;
        FaceInput { landmarks, width, height, colours, picture: self.picture.clone(), lens: *lens }
    }
}
