use base64::prelude::{BASE64_STANDARD, Engine};
use rosto_face::{FaceModel, PhotoLens, Triangulation};
use serde_json::{Value, json};

use super::Painted;
use crate::{ExportError, Picture, about, texture};

/// Version of the extras that is written and read.
pub(crate) const VERSION: u64 = 1;

/// Data from which [`reopen`](crate::reopen) restores a face and its edits.
///
/// It is stored in the scene's `extras`, which other programs preserve or drop:
/// ```json
/// {"rosto": "face", "version": 1, "photo_px": [512, 512], "triangulation": "canonical", "density": 0, "lens": "exif:26",
///  "landmarks": "468 or 478 × 3 little-endian f32 in base64", "colours": "468 × 3 bytes in base64",
///  "picture": {"size_px": [512, 512], "crop_at_px": [96, 0], "crop_size_px": [256, 256]}, "history": {}, "in_photo": {},
///  "positions_fnv1a": "cbf29ce484222325", "about": {}}
/// ```
/// `lens` holds the lens data ([`rosto_face::PhotoLens`]); `about` is [`about`](crate::about), for readers other than
/// Rosto.
/// `picture` places the texture's crop in the upright photo. If the texture is the whole-face texture, `picture` holds
/// the crop itself as `jpeg`, in base64, because programs may drop an unused glTF image. A file without a texture has
/// no `picture`.
///
/// These fields describe the lead photo. For a face from several photos, `further` lists the others and `leads` is the
/// index of the lead photo among all of them, in input order:
/// ```json
/// {"leads": 0, "photos": [{"photo_px": [512, 512], "lens": "estimated", "landmarks": "", "colours": "", "picture": {}}]}
/// ```
/// `positions_fnv1a` is the 64-bit FNV-1a hash of the `POSITION` bytes, used to detect changes by other programs.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// The unedited face.
    pub face: &'a FaceModel,
    /// Triangulation of the landmarks in the file.
    pub triangulation: Triangulation,
    /// Subdivision level of the mesh in the file.
    pub density: u32,
    /// Edits as the text of a JSON object, in a format that this crate does not interpret; `None` if there are none.
    pub history: Option<&'a str>,
    /// Edits of the photo, in the same form.
    pub in_photo: Option<&'a str>,
}

/// Builds the extras, without the pictures.
pub(super) fn extras(source: &Source<'_>) -> Result<Value, ExportError> {
    let face = source.face;
    let mut extras = found(face.photo_size_px(), face.lens(), face.landmarks(), face.colours_srgb());
    extras["rosto"] = "face".into();
    extras["version"] = VERSION.into();
    extras["triangulation"] = source.triangulation.id().into();
    extras["density"] = source.density.into();
    extras["about"] = about(face, face.positions_m());
    if let Some(history) = source.history {
        extras["history"] = history_object(history)?;
    }
    if let Some(in_photo) = source.in_photo {
        extras["in_photo"] = history_object(in_photo)?;
    }
    Ok(extras)
}

/// Landmarks (little-endian `f32`) and their colours, both in base64, with the photo's size and lens.
pub(super) fn found(photo_px: [u32; 2], lens: PhotoLens, landmarks: &[[f32; 3]], colours: &[[u8; 3]]) -> Value {
    let landmarks: Vec<u8> = landmarks.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
    let [landmarks, colours] = [&landmarks, colours.as_flattened()].map(|bytes| BASE64_STANDARD.encode(bytes));
    json!({"photo_px": photo_px, "lens": lens.to_string(), "landmarks": landmarks, "colours": colours})
}

/// Parses the history.
pub(crate) fn history_object(history: &str) -> Result<Value, ExportError> {
    serde_json::from_str(history).ok().filter(Value::is_object).ok_or(ExportError::HistoryNotAnObject)
}

/// 64-bit FNV-1a hash, as sixteen hexadecimal digits.
pub(crate) fn fingerprint(bytes: impl IntoIterator<Item = u8>) -> String {
    const BASIS: u64 = 0xCBF2_9CE4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01B3;
    let hash = bytes.into_iter().fold(BASIS, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME));
    format!("{hash:016x}")
}

/// Placement of the photo's crop, with the crop itself unless it is the texture.
pub(super) fn picture(photo: &Picture<'_>, painted: &Painted, max_px: u32) -> Result<Option<Value>, ExportError> {
    match painted {
        Painted::Photo(crop) => Ok(Some(placement(crop))),
        Painted::Whole => part_of(photo, max_px).map(Some),
        Painted::Colours => Ok(None),
    }
}

/// The face's part of a photo, with its placement.
pub(super) fn part_of(photo: &Picture<'_>, max_px: u32) -> Result<Value, ExportError> {
    let (part, crop) = texture::crop(photo, max_px)?;
    let mut picture = placement(&crop);
    picture["jpeg"] = BASE64_STANDARD.encode(texture::jpeg(&part.pixels)?).into();
    Ok(picture)
}

fn placement(crop: &texture::Crop) -> Value {
    json!({"size_px": crop.picture_size_px, "crop_at_px": crop.at_px, "crop_size_px": crop.size_px})
}
