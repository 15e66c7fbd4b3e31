use base64::prelude::{BASE64_STANDARD, Engine};
use rosto_face::{LANDMARK_COUNT, Triangulation};
use serde_json::Value;
use thiserror::Error;

use crate::glb::{VERSION, triangulation_from_name};

mod chunks;
mod painted;

use chunks::Chunks;
pub use painted::Painted;

/// A picture with a longer side, in px, is not one that this crate has written.
const MAX_PICTURE_SIDE_PX: u32 = 8192;

/// A face out of a GLB that [`glb`](crate::glb()) wrote with a [`Source`](crate::Source): all that opens it again.
#[derive(Debug, Clone, PartialEq)]
pub struct Reopened<'a> {
    /// 468 landmarks in MediaPipe's normalised convention (x/W, y/H, z/W), bit for bit as they were found.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo that they were found in.
    pub photo_size_px: [u32; 2],
    /// 468 sRGB colours.
    pub colours_srgb: Vec<[u8; 3]>,
    /// How the landmarks are joined.
    pub triangulation: Triangulation,
    /// How often the mesh was subdivided.
    pub density: u32,
    /// The edits as the text of a JSON object.
    pub history: Option<String>,
    /// The part of the photo that the file holds; none in a file that is painted with colours.
    pub texture: Option<PlacedTexture<'a>>,
}

/// A texture, and where in the upright picture it was cut out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlacedTexture<'a> {
    /// The encoded picture.
    pub jpeg: &'a [u8],
    /// Width and height in px of the whole upright picture.
    pub picture_size_px: [u32; 2],
    /// The texture's left and top in that picture in px; negative where it reaches beyond.
    pub at_px: [i32; 2],
}

/// Why a file cannot be opened again.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReopenError {
    /// It does not begin as a binary glTF 2.0 file does.
    #[error("this is not a binary glTF 2.0 file")]
    NotGlb,
    /// It ends too early.
    #[error("the file has {found} bytes where it promises {expected}")]
    Truncated {
        /// Bytes that the file says it has.
        expected: usize,
        /// Bytes there are.
        found: usize,
    },
    /// Its description is not JSON.
    #[error("the file's description of itself cannot be read")]
    NotJson,
    /// Another program wrote it, or wrote it anew without what Rosto had put in.
    #[error("the file holds no Rosto face")]
    Foreign,
    /// A later Rosto wrote it.
    #[error("the file has version {found}, and this Rosto reads up to version {known}")]
    Newer {
        /// The version in the file.
        found: u64,
        /// The latest version that is known.
        known: u64,
    },
    /// Something is missing or not as expected.
    #[error("the file has no usable {field:?}")]
    Field {
        /// The field's name.
        field: &'static str,
    },
}

/// Reads what makes a face out of a GLB: landmarks, colours, the texture and its place, and the edits.
///
/// Nothing of a stranger's file is trusted: every length and place is checked, and no picture is decoded. Whether the
/// history is one is for its owner to say.
///
/// # Errors
/// [`ReopenError`] for what is no GLB, is damaged, or was not written by this crate.
pub fn reopen(bytes: &[u8]) -> Result<Reopened<'_>, ReopenError> {
    let chunks = Chunks::of(bytes)?;
    let root: Value = serde_json::from_slice(chunks.json).map_err(|_| ReopenError::NotJson)?;
    let extras = &root["scenes"][0]["extras"];
    if extras["rosto"] != "face" {
        return Err(ReopenError::Foreign);
    }
    let found = extras["version"].as_u64().ok_or(ReopenError::Field { field: "version" })?;
    if found > VERSION {
        return Err(ReopenError::Newer { found, known: VERSION });
    }
    let field = |field| move || ReopenError::Field { field };
    Ok(Reopened {
        landmarks: landmarks(&extras["landmarks"]).ok_or_else(field("landmarks"))?,
        photo_size_px: size(&extras["photo_px"], u32::MAX).ok_or_else(field("photo_px"))?,
        colours_srgb: colours(&extras["colours"]).ok_or_else(field("colours"))?,
        triangulation: extras["triangulation"]
            .as_str()
            .and_then(triangulation_from_name)
            .ok_or_else(field("triangulation"))?,
        density: integer(&extras["density"]).ok_or_else(field("density"))?,
        history: extras.get("history").map(Value::to_string),
        texture: match extras.get("picture") {
            Some(picture) => Some(texture(picture, &root, chunks.binary).ok_or_else(field("picture"))?),
            None => None,
        },
    })
}

fn landmarks(value: &Value) -> Option<Vec<[f32; 3]>> {
    let bytes = BASE64_STANDARD.decode(value.as_str()?).ok()?;
    let (numbers, rest) = bytes.as_chunks::<4>();
    let numbers: Vec<f32> = numbers.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect();
    let (points, more) = numbers.as_chunks::<3>();
    let whole = rest.is_empty() && more.is_empty() && points.len() == LANDMARK_COUNT;
    (whole && numbers.iter().all(|number| number.is_finite())).then(|| points.to_vec())
}

fn colours(value: &Value) -> Option<Vec<[u8; 3]>> {
    let bytes = BASE64_STANDARD.decode(value.as_str()?).ok()?;
    let (colours, rest) = bytes.as_chunks::<3>();
    (rest.is_empty() && colours.len() == LANDMARK_COUNT).then(|| colours.to_vec())
}

fn size(value: &Value, most_px: u32) -> Option<[u32; 2]> {
    let [width, height] = value.as_array()?.as_slice() else { return None };
    let size = [integer(width)?, integer(height)?];
    size.iter().all(|side| (1..=most_px).contains(side)).then_some(size)
}

fn texture<'a>(picture: &Value, root: &Value, binary: &'a [u8]) -> Option<PlacedTexture<'a>> {
    let [left, top] = picture["crop_at_px"].as_array()?.as_slice() else { return None };
    let beyond = |at: &i32| at.unsigned_abs() <= MAX_PICTURE_SIDE_PX;
    let place = |value: &Value| i32::try_from(value.as_i64()?).ok().filter(beyond);
    let view = &root["bufferViews"][index(&root["images"][0]["bufferView"])?];
    let start = index(view.get("byteOffset").unwrap_or(&Value::from(0)))?;
    let end = start.checked_add(index(&view["byteLength"])?)?;
    Some(PlacedTexture {
        jpeg: binary.get(start..end)?,
        picture_size_px: size(&picture["size_px"], MAX_PICTURE_SIDE_PX)?,
        at_px: [place(left)?, place(top)?],
    })
}

fn integer(value: &Value) -> Option<u32> {
    value.as_u64()?.try_into().ok()
}

fn index(value: &Value) -> Option<usize> {
    value.as_u64()?.try_into().ok()
}
