use rosto_face::{FaceInput, Photo, PhotoLens};

/// A further photo of a face, with its landmarks.
#[derive(Debug, Clone, PartialEq)]
pub struct FurtherPhoto {
    /// MediaPipe's normalised landmarks: 468, or 478 with the irises.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo in which the landmarks were found.
    pub photo_size_px: [u32; 2],
    /// Colour at each landmark, sRGB: 468.
    pub colours_srgb: Vec<[u8; 3]>,
    /// The upright picture; it can be scaled down.
    pub picture: Photo,
    /// Lens data of the photo.
    pub lens: PhotoLens,
}

impl FurtherPhoto {
    /// The input of a face model.
    pub(crate) fn input(&self) -> FaceInput<'_> {
        let [width, height] = self.photo_size_px;
        let Self { landmarks, colours_srgb: colours, lens, .. } = self;
        FaceInput { landmarks, width, height, colours, picture: self.picture.clone(), lens: *lens }
    }
}
