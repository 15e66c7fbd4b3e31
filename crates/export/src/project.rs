//! The project file: a face with its edits and its lossless photo.
//!
//! A line of JSON, then `points` × 3 little-endian `f32` landmarks, 468 × 3 bytes of colours, and the upright picture
//! as a PNG file:
//! ```json
//! {"format": "rosto-project", "version": 1, "width_px": 512, "height_px": 512, "points": 478, "lens": "exif:26",
//!  "triangulation": "canonical", "density": 0, "edits": {}}
//! ```
//! Optional fields are `"in_photo"`, the edits of the photo, and `"further"`, the further photos as in a GLB
//! ([`Source`]), each with the face's part as JPEG. There are 468 points, or 478 with the irises.
//!
//! `width_px` and `height_px` are those of the photo in which the landmarks were found; the picture may be a smaller
//! copy. This crate does not interpret the edits.

use std::borrow::Cow;

use rosto_face::{LANDMARK_COUNT, POINT_COUNT};
use serde_json::Value;

use crate::glb::{Pictures, further, history_object};
use crate::reopen::fields::{bounded, check_version, colours, density, field, integer, landmarks, object};
use crate::reopen::texture::{MAX_PICTURE_SIDE_PX, PNG_SIGNATURE, png_size};
use crate::reopen::{further_photos, in_photo, lens, triangulation};
use crate::sniff::without_bom;
use crate::{ExportError, PlacedTexture, ReopenError, Reopened, Source};

const FORMAT: &str = "rosto-project";

/// Format version that is written and read.
const VERSION: u64 = 1;

/// Longest side of a further photo's picture, in px.
const MAX_FURTHER_PX: u32 = 2048;

const POINT_BYTES: usize = 3 * 4;
const COLOURS_BYTES: usize = LANDMARK_COUNT * 3;

/// Writes a project (`application/octet-stream`). `png` is the whole upright picture and is stored unchanged.
///
/// # Errors
/// [`ExportError::HistoryNotAnObject`] if the history is missing or not a JSON object: a project requires one, even if
/// empty. [`ExportError::NotPng`] if the picture is not a PNG file.
pub fn write(source: &Source<'_>, png: &[u8]) -> Result<Vec<u8>, ExportError> {
    let edits = history_object(source.history.ok_or(ExportError::HistoryNotAnObject)?)?;
    if !png.starts_with(&PNG_SIGNATURE) {
        return Err(ExportError::NotPng);
    }
    let [width, height] = source.face.photo_size_px();
    let triangulation = source.triangulation.id();
    let (landmarks, lens) = (source.face.landmarks(), source.face.lens());
    let in_photo = source.in_photo.map(history_object).transpose()?.map(|edits| format!(r#","in_photo":{edits}"#));
    let in_photo = in_photo.unwrap_or_default();
    let further = further(source.face, Pictures::UpTo(MAX_FURTHER_PX))?;
    let further = further.map(|photos| format!(r#","further":{photos}"#)).unwrap_or_default();
    let header = format!(
        r#"{{"format":"{FORMAT}","version":{VERSION},"width_px":{width},"height_px":{height},"points":{},"lens":"{lens}","triangulation":"{triangulation}","density":{},"edits":{edits}{in_photo}{further}}}"#,
        landmarks.len(),
        source.density
    );
    let mut file = Vec::with_capacity(header.len() + 1 + landmarks.len() * POINT_BYTES + COLOURS_BYTES + png.len());
    file.extend_from_slice(header.as_bytes());
    file.push(b'\n');
    file.extend(landmarks.iter().flatten().flat_map(|number| number.to_le_bytes()));
    file.extend_from_slice(source.face.colours_srgb().as_flattened());
    file.extend_from_slice(png);
    Ok(file)
}

/// Reads a project. Checks the picture's size and completeness, but does not decode it.
///
/// # Errors
/// [`ReopenError`] if the file is not a project, is damaged, or has another version.
pub fn read(bytes: &[u8]) -> Result<Reopened<'_>, ReopenError> {
    let text = without_bom(bytes).trim_ascii_start();
    if !text.starts_with(b"{") {
        return Err(ReopenError::Foreign);
    }
    let line = text.iter().position(|&byte| byte == b'\n').ok_or(ReopenError::NotJson)?;
    let header: Value = serde_json::from_slice(&text[..line]).map_err(|_| ReopenError::NotJson)?;
    if header["format"] != FORMAT {
        return Err(ReopenError::Foreign);
    }
    check_version(&header["version"], VERSION)?;
    let (body, found) = (&text[line + 1..], bytes.len());
    let truncated = |missing: usize| ReopenError::Truncated { expected: found.saturating_add(missing), found };
    let points = integer(&header["points"]);
    let is_count = |&count: &usize| count == LANDMARK_COUNT || count == POINT_COUNT;
    let point_count = points.map(|count| count as usize).filter(is_count).ok_or_else(field("points"))?;
    let landmarks_bytes = point_count * POINT_BYTES;
    let parts = body.split_at_checked(landmarks_bytes).and_then(|(landmarks, rest)| {
        let (colours, png) = rest.split_at_checked(COLOURS_BYTES)?;
        Some((landmarks, colours, png))
    });
    let (points, colour_bytes, png) = parts.ok_or_else(|| truncated(landmarks_bytes + COLOURS_BYTES - body.len()))?;
    let side = |name: &'static str| integer(&header[name]).filter(|&side| side > 0).ok_or_else(field(name));
    let photo_size_px = [side("width_px")?, side("height_px")?];
    let reopened = Reopened {
        landmarks: landmarks(points, photo_size_px).ok_or_else(field("landmarks"))?,
        photo_size_px,
        colours_srgb: colours(colour_bytes).ok_or_else(field("colours"))?,
        triangulation: triangulation(&header["triangulation"])?,
        density: density(&header["density"]).ok_or_else(field("density"))?,
        lens: lens(&header["lens"])?,
        history: Some(object(&header["edits"]).ok_or_else(field("edits"))?),
        in_photo: in_photo(&header)?,
        further: further_photos(header.get("further"))?,
        texture: None,
        changed_elsewhere: false,
    };
    let missing = missing_of_png(png).ok_or_else(field("picture"))?;
    if missing > 0 {
        return Err(truncated(missing));
    }
    let size_px = png_size(png).and_then(|size| bounded(size, MAX_PICTURE_SIDE_PX)).ok_or_else(field("picture"))?;
    let texture = PlacedTexture { encoded: Cow::Borrowed(png), picture_size_px: size_px, at_px: [0, 0], size_px };
    Ok(Reopened { texture: Some(texture), ..reopened })
}

/// Minimum number of bytes missing before the end chunk of a PNG file; `None` if it is not a PNG file.
fn missing_of_png(png: &[u8]) -> Option<usize> {
    /// Bytes of a chunk without its content: length, name and checksum.
    const AROUND: usize = 12;
    let mut rest = png.strip_prefix(&PNG_SIGNATURE)?;
    loop {
        let Some(&[a, b, c, d, ref name @ ..]) = rest.first_chunk::<8>() else { return Some(AROUND - rest.len()) };
        let length = AROUND.checked_add(usize::try_from(u32::from_be_bytes([a, b, c, d])).ok()?)?;
        match rest.get(length..) {
            Some(_) if name == b"IEND" => return Some(0),
            Some(after) => rest = after,
            None => return Some(length - rest.len()),
        }
    }
}
