use base64::prelude::{BASE64_STANDARD, Engine};
use rosto_face::{LANDMARK_COUNT, MAX_DENSITY, check_landmarks};
use serde_json::Value;

use super::ReopenError;

/// Largest landmark coordinate, in picture widths or heights.
const MAX_COORDINATE: f32 = 300.0;

/// Smallest extent of a face, in picture widths or heights: below it, a face has less than one pixel.
const MIN_EXTENT: f32 = 1e-5;

/// Error for a missing or invalid field.
pub(crate) fn field(field: &'static str) -> impl FnOnce() -> ReopenError {
    move || ReopenError::Field { field }
}

/// Refuses all versions except `known`.
pub(crate) fn check_version(value: &Value, known: u64) -> Result<(), ReopenError> {
    match value.as_u64().ok_or_else(field("version"))? {
        found if found == known => Ok(()),
        found => Err(ReopenError::Version { found, known }),
    }
}

/// Reads landmarks from little-endian bytes; `None` if they do not form a valid face.
pub(crate) fn landmarks(bytes: &[u8], [width, height]: [u32; 2]) -> Option<Vec<[f32; 3]>> {
    let (numbers, rest) = bytes.as_chunks::<4>();
    let numbers: Vec<f32> = numbers.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect();
    let (points, more) = numbers.as_chunks::<3>();
    let near = |number: &f32| number.abs() <= MAX_COORDINATE;
    let plausible = rest.is_empty() && more.is_empty() && numbers.iter().all(near) && extent(points) >= MIN_EXTENT;
    (plausible && check_landmarks(points, width, height).is_ok()).then(|| points.to_vec())
}

/// Longer side of the landmarks' bounding box, in picture widths or heights.
fn extent(points: &[[f32; 3]]) -> f32 {
    let side = |axis: usize| {
        let along = || points.iter().map(|point| point[axis]);
        along().fold(f32::NEG_INFINITY, f32::max) - along().fold(f32::INFINITY, f32::min)
    };
    side(0).max(side(1))
}

/// Reads 468 colours.
pub(crate) fn colours(bytes: &[u8]) -> Option<Vec<[u8; 3]>> {
    let (colours, rest) = bytes.as_chunks::<3>();
    (rest.is_empty() && colours.len() == LANDMARK_COUNT).then(|| colours.to_vec())
}

pub(crate) fn base64(value: &Value) -> Option<Vec<u8>> {
    BASE64_STANDARD.decode(value.as_str()?).ok()
}

pub(crate) fn density(value: &Value) -> Option<u32> {
    integer(value).filter(|&density| density <= MAX_DENSITY)
}

/// Reads a width and height in px, both non-zero.
pub(crate) fn size(value: &Value, most_px: u32) -> Option<[u32; 2]> {
    let [width, height] = value.as_array()?.as_slice() else { return None };
    bounded([integer(width)?, integer(height)?], most_px)
}

pub(crate) fn bounded(size: [u32; 2], most_px: u32) -> Option<[u32; 2]> {
    size.iter().all(|side| (1..=most_px).contains(side)).then_some(size)
}

/// Text of a JSON object.
pub(crate) fn object(value: &Value) -> Option<String> {
    value.is_object().then(|| value.to_string())
}

pub(crate) fn integer(value: &Value) -> Option<u32> {
    value.as_u64()?.try_into().ok()
}

pub(crate) fn index(value: &Value) -> Option<usize> {
    value.as_u64()?.try_into().ok()
}
