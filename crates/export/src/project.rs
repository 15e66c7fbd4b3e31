//! The project file: a face with its edits and its photo without loss.
//!
//! One line of JSON, then 468 × 3 little-endian `f32` landmarks, 468 × 3 bytes of colours, and the upright picture as a
//! PNG file to the end:
//! ```json
//! {"format": "rosto-project", "version": 1, "width_px": 512, "height_px": 512,
//!  "triangulation": "canonical", "density": 0, "edits": {}}
//! ```
//! The sides are those of the photo that the landmarks were found in; the picture may be a smaller copy. Of the edits
//! only their owner knows more than that they are an object.

use rosto_face::LANDMARK_COUNT;
use serde_json::Value;

use crate::glb::history_object;
use crate::reopen::fields::{bounded, colours, density, field, integer, landmarks, object, version};
use crate::reopen::texture::{MAX_PICTURE_SIDE_PX, PNG_SIGNATURE, png_size};
use crate::reopen::triangulation;
use crate::sniff::without_bom;
use crate::{ExportError, PlacedTexture, ReopenError, Reopened, Source};

const FORMAT: &str = "rosto-project";

/// The version that is written.
const VERSION: u64 = 1;

const LANDMARKS_BYTES: usize = LANDMARK_COUNT * 3 * 4;
const COLOURS_BYTES: usize = LANDMARK_COUNT * 3;

/// Writes a project. `png` is the face's whole upright picture, and goes in as it is. Media type:
/// `application/octet-stream`.
///
/// # Errors
/// [`ExportError::HistoryNotAnObject`] if the source has no history, or one that is no JSON object: a project says what
/// was edited, if only that nothing was. [`ExportError::NotPng`] if the picture is no PNG file.
pub fn write(source: &Source<'_>, png: &[u8]) -> Result<Vec<u8>, ExportError> {
    let edits = history_object(source.history.ok_or(ExportError::HistoryNotAnObject)?)?;
    if !png.starts_with(&PNG_SIGNATURE) {
        return Err(ExportError::NotPng);
    }
    let [width, height] = source.face.photo_size_px();
    let triangulation = source.triangulation.id();
    // The name of the format comes first, where earlier readers look for it.
    let header = format!(
        r#"{{"format":"{FORMAT}","version":{VERSION},"width_px":{width},"height_px":{height},"triangulation":"{triangulation}","density":{},"edits":{edits}}}"#,
        source.density
    );
    let mut file = Vec::with_capacity(header.len() + 1 + LANDMARKS_BYTES + COLOURS_BYTES + png.len());
    file.extend_from_slice(header.as_bytes());
    file.push(b'\n');
    // The landmarks came as 32-bit numbers, so that nothing is lost here.
    file.extend(source.face.positions_image().iter().flat_map(|p| p.as_vec3().to_array()).flat_map(f32::to_le_bytes));
    file.extend_from_slice(source.face.colours_srgb().as_flattened());
    file.extend_from_slice(png);
    Ok(file)
}

/// Reads a project. Its picture is checked for its size and its end, and not decoded.
///
/// # Errors
/// [`ReopenError`] for what is no project, is damaged, is of a later version, or could not be opened.
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
    version(&header["version"], VERSION)?;
    let (body, found) = (&text[line + 1..], bytes.len());
    let truncated = |missing: usize| ReopenError::Truncated { expected: found.saturating_add(missing), found };
    let parts = body.split_at_checked(LANDMARKS_BYTES).and_then(|(landmarks, rest)| {
        let (colours, png) = rest.split_at_checked(COLOURS_BYTES)?;
        Some((landmarks, colours, png))
    });
    let (points, under_them, png) = parts.ok_or_else(|| truncated(LANDMARKS_BYTES + COLOURS_BYTES - body.len()))?;
    let side = |name: &'static str| integer(&header[name]).filter(|&side| side > 0).ok_or_else(field(name));
    let photo_size_px = [side("width_px")?, side("height_px")?];
    let reopened = Reopened {
        landmarks: landmarks(points, photo_size_px).ok_or_else(field("landmarks"))?,
        photo_size_px,
        colours_srgb: colours(under_them).ok_or_else(field("colours"))?,
        triangulation: triangulation(&header["triangulation"])?,
        density: density(&header["density"]).ok_or_else(field("density"))?,
        history: Some(object(&header["edits"]).ok_or_else(field("edits"))?),
        texture: None,
        changed_elsewhere: false,
    };
    let missing = missing_of_png(png).ok_or_else(field("picture"))?;
    if missing > 0 {
        return Err(truncated(missing));
    }
    let size_px = png_size(png).and_then(|size| bounded(size, MAX_PICTURE_SIDE_PX)).ok_or_else(field("picture"))?;
    let texture = PlacedTexture { encoded: png, picture_size_px: size_px, at_px: [0, 0], size_px };
    Ok(Reopened { texture: Some(texture), ..reopened })
}

/// How many bytes are missing at least until the end chunk of a PNG file; `None` if it is no PNG file.
fn missing_of_png(png: &[u8]) -> Option<usize> {
    /// Length, name and checksum.
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
