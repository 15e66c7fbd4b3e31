use base64::prelude::{BASE64_STANDARD, Engine};
use rosto_face::{FaceModel, PhotoLens, Triangulation};
use serde_json::{Value, json};

use super::Painted;
use crate::{ExportError, Picture, about, texture};

/// Version of the extras: the one that is written and read.
pub(crate) const VERSION: u64 = 1;

/// What a face was made from. A file that carries it can be opened again, with its edits: see [`reopen`](crate::reopen).
///
/// It goes into the scene's `extras`, where other programs leave it alone or drop it:
/// ```json
/// {"rosto": "face", "version": 1, "photo_px": [512, 512], "triangulation": "canonical", "density": 0, "lens": "exif:26",
///  "landmarks": "468 or 478 × 3 little-endian f32 in base64", "colours": "468 × 3 bytes in base64",
///  "picture": {"size_px": [512, 512], "crop_at_px": [96, 0], "crop_size_px": [256, 256]}, "history": {}, "in_photo": {},
///  "positions_fnv1a": "cbf29ce484222325", "about": {}}
/// ```
/// `lens` holds the lens data ([`rosto_face::PhotoLens`]). `about` is [`about`](crate::about), for readers of the
/// file without Rosto.
/// `picture` says where in the upright picture the texture was cut out. Where a picture of the whole face is the texture,
/// that part of the photo is in it as `jpeg`, a file in base64: as an image that no texture uses, glTF would have it dropped. A
/// file without texture has no `picture`.
/// All that is of the photo that leads. Of a face in several photos there are the others in `further`, each
/// with `photo_px`, `lens`, `landmarks`, `colours` and a `picture` with its `jpeg`; `leads` says the place of the one that leads
/// among them all, in the order that they were given in:
/// ```json
/// {"leads": 0, "photos": [{"photo_px": [512, 512], "lens": "estimated", "landmarks": "", "colours": "", "picture": {}}]}
/// ```
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

/// The extras but for the pictures.
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

/// A face found in a photo: landmarks as little-endian numbers, and the colours under them, both in base64.
pub(super) fn found(photo_px: [u32; 2], lens: PhotoLens, landmarks: &[[f32; 3]], colours: &[[u8; 3]]) -> Value {
    let landmarks: Vec<u8> = landmarks.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
    let [landmarks, colours] = [&landmarks, colours.as_flattened()].map(|bytes| BASE64_STANDARD.encode(bytes));
    json!({"photo_px": photo_px, "lens": lens.to_string(), "landmarks": landmarks, "colours": colours})
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
    match painted {
        Painted::Photo(crop) => Ok(Some(place(crop))),
        Painted::Whole => part_of(photo, max_px).map(Some),
        Painted::Colours => Ok(None),
    }
}

/// The face's part of a photo, and where it was cut out.
pub(super) fn part_of(photo: &Picture<'_>, max_px: u32) -> Result<Value, ExportError> {
    let (part, crop) = texture::crop(photo, max_px)?;
    let mut picture = place(&crop);
    picture["jpeg"] = BASE64_STANDARD.encode(texture::jpeg(&part.pixels)?).into();
    Ok(picture)
}

fn place(crop: &texture::Crop) -> Value {
    json!({"size_px": crop.picture_size_px, "crop_at_px": crop.at_px, "crop_size_px": crop.size_px})
}
