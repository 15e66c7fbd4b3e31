use rosto_face::{MOST_PHOTOS, PhotoLens, Triangulation};
use serde_json::Value;

use super::fields::{base64, colours, field, index, landmarks, size};
use super::painted::{Painted, painted};
use super::texture::texture;
use super::{PlacedTexture, ReopenError, lens};

/// The further photos of a face in several.
#[derive(Debug, Clone, PartialEq)]
pub struct Further {
    /// The place of the photo that leads among them all, in the order that they were given in.
    pub leads: usize,
    /// The others in that order: at least one.
    pub photos: Vec<FurtherPhoto>,
}

/// A photo beside the one that leads.
#[derive(Debug, Clone, PartialEq)]
pub struct FurtherPhoto {
    /// 468 landmarks, or 478 with the irises, bit for bit as they were found.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo that they were found in.
    pub photo_size_px: [u32; 2],
    /// What was known of the photo's lens.
    pub lens: PhotoLens,
    /// 468 sRGB colours.
    pub colours_srgb: Vec<[u8; 3]>,
    /// The part of the photo that the file holds; none in a GLB that is painted with colours.
    pub texture: Option<PlacedTexture<'static>>,
}

impl FurtherPhoto {
    /// What stands in for the photo in a file that holds none.
    pub fn painted(&self) -> Painted {
        painted(&self.landmarks, self.photo_size_px, &self.colours_srgb, Triangulation::Canonical)
    }
}

/// The further photos, if a file tells of any.
pub(crate) fn further_photos(fields: Option<&Value>) -> Result<Option<Further>, ReopenError> {
    let Some(fields) = fields else { return Ok(None) };
    let photos = fields["photos"].as_array().filter(|photos| (1..MOST_PHOTOS).contains(&photos.len()));
    let photos: Vec<_> = photos.ok_or_else(field("further"))?.iter().map(photo).collect::<Result<_, _>>()?;
    let leads = index(&fields["leads"]).filter(|&place| place <= photos.len()).ok_or_else(field("further"))?;
    Ok(Some(Further { leads, photos }))
}

fn photo(fields: &Value) -> Result<FurtherPhoto, ReopenError> {
    let photo_size_px = size(&fields["photo_px"], u32::MAX).ok_or_else(field("photo_px"))?;
    let numbers = base64(&fields["landmarks"]).ok_or_else(field("landmarks"))?;
    let landmarks = landmarks(&numbers, photo_size_px).ok_or_else(field("landmarks"))?;
    let own = |picture: &Value| picture.get("jpeg").and_then(|_| texture(picture, &Value::Null, &[]));
    Ok(FurtherPhoto {
        photo_size_px,
        lens: lens(&fields["lens"])?,
        colours_srgb: base64(&fields["colours"]).and_then(|bytes| colours(&bytes)).ok_or_else(field("colours"))?,
        texture: fields.get("picture").map(|picture| own(picture).ok_or_else(field("picture"))).transpose()?,
        landmarks,
    })
}
