//! Facts about one photo, the conversion of its landmarks to px, and the fit of the canonical face to them.

use glam::{DAffine3, DVec3};

use crate::irises::POINT_COUNT;
use crate::procrustes::{self, Pair, Similarity};
use crate::tables::PROCRUSTES;
use crate::{CardCorners, FaceError, LANDMARK_COUNT, PhotoLens, canonical_positions_m};

/// Facts about one photo.
#[derive(Debug, Clone, Copy)]
pub(super) struct PhotoInput<'a> {
    pub(super) landmarks: &'a [[f32; 3]],
    pub(super) size_px: [u32; 2],
    pub(super) lens: PhotoLens,
    pub(super) card: Option<CardCorners>,
}

/// Checks whether landmarks found in a picture of `width` × `height` px are accepted by
/// [`FaceModel::new`](crate::FaceModel::new).
///
/// # Errors
/// See [`FaceModel::new`](crate::FaceModel::new).
pub fn check_landmarks(landmarks: &[[f32; 3]], width: u32, height: u32) -> Result<(), FaceError> {
    fit_canonical_to(&in_px(landmarks, [width, height])?).map(|_| ())
}

pub(super) fn check_count(what: &'static str, expected: usize, found: usize) -> Result<(), FaceError> {
    if found == expected { Ok(()) } else { Err(FaceError::WrongCount { what, expected, found }) }
}

/// Maps MediaPipe's normalised coordinates to right-handed px: y up, z towards the viewer.
pub(super) fn px_from_image([width, height]: [u32; 2]) -> DAffine3 {
    let (width, height) = (f64::from(width), f64::from(height));
    DAffine3::from_scale(DVec3::new(width, -height, -width))
}

/// 468 or 478 landmarks in px, y up, z towards the camera, with a mean depth of 0 over the 468.
pub(crate) fn in_px(landmarks: &[[f32; 3]], [width, height]: [u32; 2]) -> Result<Vec<DVec3>, FaceError> {
    if landmarks.len() != POINT_COUNT {
        check_count("landmarks", LANDMARK_COUNT, landmarks.len())?;
    }
    if width == 0 || height == 0 {
        return Err(FaceError::EmptyPicture { width, height });
    }
    if let Some(landmark) = landmarks.iter().position(|p| !p.iter().all(|c| c.is_finite())) {
        return Err(FaceError::NotFinite { landmark });
    }
    let px_from_image = px_from_image([width, height]);
    let mut px: Vec<DVec3> =
        landmarks.iter().map(|p| px_from_image.transform_point3(DVec3::from(p.map(f64::from)))).collect();
    let mean = px[..LANDMARK_COUNT].iter().map(|point| point.z).sum::<f64>() / LANDMARK_COUNT as f64;
    px.iter_mut().for_each(|point| point.z -= mean);
    Ok(px)
}

pub(crate) fn fit_canonical_to(px: &[DVec3]) -> Result<Similarity, FaceError> {
    fit_to(&canonical_positions_m(), px)
}

/// Fits known landmarks to observed ones, with MediaPipe's weights.
pub(super) fn fit_to(known_m: &[DVec3], px: &[DVec3]) -> Result<Similarity, FaceError> {
    let pairs: Vec<Pair> = PROCRUSTES
        .iter()
        .map(|&(landmark, weight)| {
            let landmark = usize::from(landmark);
            Pair { source: known_m[landmark], target: px[landmark], weight }
        })
        .collect();
    procrustes::fit(&pairs)
}
