use base64::prelude::{BASE64_STANDARD, Engine};
use rosto_face::{FaceModel, Triangulation};
use serde_json::{Value, json};

use super::Painted;
use crate::{ExportError, Picture, about, texture};

/// The version of the extras that is written.
pub(crate) const VERSION: u64 = 3;

/// What a face was made from. A file that carries it can be opened again, with its edits: see [`reopen`](crate::reopen).
///
/// It goes into the scene's `extras`, where other programs leave it alone or drop it:
/// ```json
/// {"rosto": "face", "version": 3, "photo_px": [512, 512], "triangulation": "canonical", "density": 0, "lens": "exif:26",
///  "landmarks": "468 or 478 × 3 little-endian f32 in base64", "colours": "468 × 3 bytes in base64",
///  "picture": {"size_px": [512, 512], "crop_at_px": [96, 0], "crop_size_px": [256, 256]}, "history": {}, "in_photo": {},
///  "positions_fnv1a": "cbf29ce484222325", "about": {}}
/// ```
/// `lens` is what was known of the lens ([`rosto_face::PhotoLens`]); a file of version 1 has none, and its face was seen from
/// infinitely far away. `about` is [`about`](crate::about), for whoever reads the file without Rosto.
/// `picture` says where in the upright picture the texture was cut out. Where a picture of the whole face is the texture,
/// that part of the photo is in it as `jpeg`, a file in base64 (since version 3): as an image that no texture uses, glTF
/// would have it dropped. A file without texture has no `picture`.
/// `positions_fnv1a` is the 64-bit FNV-1a hash of the bytes of `POSITION`, by which a mesh shows that was changed since.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// The unedited face.
    pub face: &'a FaceModel,
    /// How its landmarks are joined in the file.
    pub triangulation: Triangulation,
    /// How often its mesh was subdivided for the file.
    pub density: u32,
    /// The edits as the text of a JSON object, in the form that only their owner knows; none if there are none.
    pub history: Option<&'a str>,
    /// What was done to the photo alone, in the same way.
    pub in_photo: Option<&'a str>,
}

/// The extras but for the picture.
pub(super) fn extras(source: &Source<'_>) -> Result<Value, ExportError> {
    let face = source.face;
    let landmarks = face.landmarks().into_iter().flatten().flat_map(f32::to_le_bytes);
    let mut extras = json!({
        "rosto": "face",
        "version": VERSION,
        "photo_px": face.photo_size_px(),
        "triangulation": source.triangulation.id(),
        "density": source.density,
        "lens": face.lens().to_string(),
        "landmarks": BASE64_STANDARD.encode(landmarks.collect::<Vec<u8>>()),
        "colours": BASE64_STANDARD.encode(face.colours_srgb().as_flattened()),
        "about": about(face, face.positions_m()),
    });
    if let Some(history) = source.history {
        extras["history"] = history_object(history)?;
    }
    if let Some(in_photo) = source.in_photo {
        extras["in_photo"] = history_object(in_photo)?;
    }
    Ok(extras)
}

/// The history as JSON.
pub(crate) fn history_object(history: &str) -> Result<Value, ExportError> {
    serde_json::from_str(history).ok().filter(Value::is_object).ok_or(ExportError::HistoryNotAnObject)
}

/// The 64-bit FNV-1a hash of bytes, in sixteen hexadecimal digits.
pub(crate) fn fingerprint(bytes: impl IntoIterator<Item = u8>) -> String {
    const BASIS: u64 = 0xCBF2_9CE4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01B3;
    let hash = bytes.into_iter().fold(BASIS, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME));
    format!("{hash:016x}")
}

/// Where the photo's part was cut out, with that part itself where no texture holds it.
pub(super) fn picture(photo: &Picture<'_>, painted: &Painted, max_px: u32) -> Result<Option<Value>, ExportError> {
    let place = |crop: &texture::Crop| json!({"size_px": crop.picture_size_px, "crop_at_px": crop.at_px, "crop_size_px": crop.size_px});
    match painted {
        Painted::Photo(crop) => Ok(Some(place(crop))),
        Painted::Whole => {
            let (part, crop) = texture::crop(photo, max_px)?;
            let mut picture = place(&crop);
            picture["jpeg"] = BASE64_STANDARD.encode(texture::jpeg(&part.pixels)?).into();
            Ok(Some(picture))
        }
        Painted::Colours => Ok(None),
    }
}
