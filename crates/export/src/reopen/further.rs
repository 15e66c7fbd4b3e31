use rosto_face::{MAX_PHOTOS, PhotoLens, Triangulation};
use serde_json::Value;

use super::fields::{base64, colours, field, index, landmarks, size};
use super::painted::{Painted, painted};
use super::texture::texture;
use super::{PlacedTexture, ReopenError, lens};

/// The further photos of a face from several.
#[derive(Debug, Clone, PartialEq)]
pub struct Further {
    /// Index of the lead photo among all photos, in input order.
    pub leads: usize,
    /// The other photos in input order, at least one.
    pub photos: Vec<FurtherPhoto>,
}

/// A photo other than the lead one.
#[derive(Debug, Clone, PartialEq)]
pub struct FurtherPhoto {
    /// 468 landmarks, or 478 with the irises, unchanged bit for bit.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo in which the landmarks were found.
    pub photo_size_px: [u32; 2],
    /// Lens data of the photo.
    pub lens: PhotoLens,
    /// 468 sRGB colours.
    pub colours_srgb: Vec<[u8; 3]>,
    /// The part of the photo in the file; `None` in a GLB with vertex colours.
    pub texture: Option<PlacedTexture<'static>>,
}

impl FurtherPhoto {
    /// A substitute for the photo, painted from the landmarks' colours.
    pub fn painted(&self) -> Painted {
        painted(&self.landmarks, self.photo_size_px, &self.colours_srgb, Triangulation::Canonical)
    }
}

/// Reads the further photos, if the file has any.
pub(crate) fn further_photos(fields: Option<&Value>) -> Result<Option<Further>, ReopenError> {
    let Some(fields) = fields else { return Ok(None) };
    let photos = fields["photos"].as_array().filter(|photos| (1..MAX_PHOTOS).contains(&photos.len()));
    let photos: Vec<_> = photos.ok_or_else(field("further"))?.iter().map(photo).collect::<Result<_, _>>()?;
    let leads = index(&fields["leads"]).filter(|&index| index <= photos.len()).ok_or_else(field("further"))?;
    Ok(Some(Further { leads, photos }))
}

fn photo(fields: &Value) -> Result<FurtherPhoto, ReopenError> {
    let photo_size_px = size(&fields["photo_px"], u32::MAX).ok_or_else(field("photo_px"))?;
    let numbers = base64(&fields["landmarks"]).ok_or_else(field("landmarks"))?;
    let landmarks = landmarks(&numbers, photo_size_px).ok_or_else(field("landmarks"))?;
    let embedded = |picture: &Value| picture.get("jpeg").and_then(|_| texture(picture, &Value::Null, &[]));
    Ok(FurtherPhoto {
        photo_size_px,
        lens: lens(&fields["lens"])?,
        colours_srgb: base64(&fields["colours"]).and_then(|bytes| colours(&bytes)).ok_or_else(field("colours"))?,
        texture: fields.get("picture").map(|picture| embedded(picture).ok_or_else(field("picture"))).transpose()?,
        landmarks,
    })
}
