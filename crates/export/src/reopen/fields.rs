use base64::prelude::{BASE64_STANDARD, Engine};
use rosto_face::{LANDMARK_COUNT, MAX_DENSITY, check_landmarks};
use serde_json::Value;

use super::ReopenError;

/// No landmark lies farther from the picture than this, in pictures.
const MAX_COORDINATE: f32 = 300.0;

/// Nor is a face smaller than this, in pictures: it would have less than a pixel.
const MIN_EXTENT: f32 = 1e-5;

/// What is missing or not as expected.
pub(crate) fn field(field: &'static str) -> impl FnOnce() -> ReopenError {
    move || ReopenError::Field { field }
}

/// The version, unless it is one that is not known yet.
pub(crate) fn version(value: &Value, known: u64) -> Result<u64, ReopenError> {
    match value.as_u64() {
        Some(found) if found > known => Err(ReopenError::Newer { found, known }),
        Some(found) if found > 0 => Ok(found),
        _ => Err(ReopenError::Field { field: "version" }),
    }
}

/// 468 landmarks out of little-endian numbers, if they are those of a face that can be modelled.
pub(crate) fn landmarks(bytes: &[u8], [width, height]: [u32; 2]) -> Option<Vec<[f32; 3]>> {
    let (numbers, rest) = bytes.as_chunks::<4>();
    let numbers: Vec<f32> = numbers.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect();
    let (points, more) = numbers.as_chunks::<3>();
    let near = |number: &f32| number.abs() <= MAX_COORDINATE;
    let plausible = rest.is_empty() && more.is_empty() && numbers.iter().all(near) && extent(points) >= MIN_EXTENT;
    (plausible && check_landmarks(points, width, height).is_ok()).then(|| points.to_vec())
}

/// The longer side of the rectangle around the landmarks, in pictures.
fn extent(points: &[[f32; 3]]) -> f32 {
    let side = |axis: usize| {
        let along = || points.iter().map(|point| point[axis]);
        along().fold(f32::NEG_INFINITY, f32::max) - along().fold(f32::INFINITY, f32::min)
    };
    side(0).max(side(1))
}

/// 468 colours.
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

/// Two sides in px, neither of them 0.
pub(crate) fn size(value: &Value, most_px: u32) -> Option<[u32; 2]> {
    let [width, height] = value.as_array()?.as_slice() else { return None };
    bounded([integer(width)?, integer(height)?], most_px)
}

pub(crate) fn bounded(size: [u32; 2], most_px: u32) -> Option<[u32; 2]> {
    size.iter().all(|side| (1..=most_px).contains(side)).then_some(size)
}

/// The text of a JSON object.
pub(crate) fn object(value: &Value) -> Option<String> {
    value.is_object().then(|| value.to_string())
}

pub(crate) fn integer(value: &Value) -> Option<u32> {
    value.as_u64()?.try_into().ok()
}

pub(crate) fn index(value: &Value) -> Option<usize> {
    value.as_u64()?.try_into().ok()
}
