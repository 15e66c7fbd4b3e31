//! Whether landmarks can be those of a face.

use glam::DVec3;

use crate::model::{fit_canonical_to, in_px};
use crate::tables::CANONICAL;
use crate::{FaceError, LANDMARK_COUNT, canonical_positions_m};

/// Largest deviation from the canonical face, in mm of its size: root mean square over the landmarks. Faces in photos
/// deviate by up to 9 mm, turned, grimacing or on the edge of a picture; one stretched to twice its height by 24 mm;
/// random points by over 200 mm.
const MAX_DEVIATION_MM: f64 = 30.0;

/// Largest share of the surface that can be turned inside out, in per cent. It is up to 1 % in photos, 50 % for random
/// points.
const MAX_INSIDE_OUT_PER_CENT: f64 = 20.0;

/// Deviation in mm up to which landmarks are as likely a face's as any, and the spread of larger ones: of 176 photos of
/// heads, the largest deviates by 7.3 mm.
const USUAL_DEVIATION_MM: f64 = 7.5;
const DEVIATIONS_MM: f64 = 5.0;

/// How well landmarks fit a face, from 0 to 1, by their residuals from the canonical face; `None` for landmarks that
/// [`check_landmarks`](crate::check_landmarks) rejects.
pub fn likeness(landmarks: &[[f32; 3]], photo_size_px: [u32; 2]) -> Option<f64> {
    let deviation_mm = deviation_mm(&fitted_m(landmarks, photo_size_px).ok()?, &canonical_positions_m());
    let excess = (deviation_mm - USUAL_DEVIATION_MM).max(0.0) / DEVIATIONS_MM;
    Some((-0.5 * excess * excess).exp())
}

/// Landmarks in the frame and size of the canonical face.
fn fitted_m(landmarks: &[[f32; 3]], photo_size_px: [u32; 2]) -> Result<Vec<DVec3>, FaceError> {
    let landmarks_px = in_px(landmarks, photo_size_px)?;
    let model_from_px = fit_canonical_to(&landmarks_px)?.inverse();
    Ok(landmarks_px[..LANDMARK_COUNT].iter().map(|&px| model_from_px.apply(px)).collect())
}

fn deviation_mm(fitted_m: &[DVec3], canonical_m: &[DVec3]) -> f64 {
    let squared_m2 = fitted_m.iter().zip(canonical_m).map(|(found, known)| found.distance_squared(*known)).sum::<f64>();
    1000.0 * (squared_m2 / LANDMARK_COUNT as f64).sqrt()
}

/// Rejects landmarks that cannot be a face's.
pub(crate) fn check(landmarks: &[[f32; 3]], photo_size_px: [u32; 2]) -> Result<(), FaceError> {
    let canonical_m = canonical_positions_m();
    let fitted_m = fitted_m(landmarks, photo_size_px)?;
    let deviation_mm = deviation_mm(&fitted_m, &canonical_m);
    if deviation_mm.is_nan() || deviation_mm > MAX_DEVIATION_MM {
        return Err(FaceError::NotAFace { deviation_mm, most_mm: MAX_DEVIATION_MM });
    }
    let inside_out_per_cent = inside_out_per_cent(&fitted_m, &canonical_m);
    if inside_out_per_cent > MAX_INSIDE_OUT_PER_CENT {
        return Err(FaceError::Folded { inside_out_per_cent, most_per_cent: MAX_INSIDE_OUT_PER_CENT });
    }
    Ok(())
}

/// Share of the canonical face's area whose triangles face backwards in `fitted_m`, in per cent.
fn inside_out_per_cent(fitted_m: &[DVec3], canonical_m: &[DVec3]) -> f64 {
    let (mut turned, mut total) = (0.0, 0.0);
    for corners in CANONICAL {
        let normal = |at: &[DVec3]| {
            let [a, b, c] = corners.map(|corner| at[usize::from(corner)]);
            (b - a).cross(c - a)
        };
        let known = normal(canonical_m);
        total += known.length();
        if known.dot(normal(fitted_m)) < 0.0 {
            turned += known.length();
        }
    }
    100.0 * turned / total
}
