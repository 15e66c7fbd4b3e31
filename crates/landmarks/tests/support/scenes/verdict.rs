//! Comparison of the faces found in a scene with the ground truth.

use rosto_landmarks::Face;
use serde_json::Value;

use super::{Model, Scene, error, landmarks_px};

/// Mean landmark error, relative to the distance between the eyes, below which a face is correct.
pub const RIGHT: f64 = 0.1;

/// Result of one finder on one scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// For each face of the scene, the least error of its correct results, if any.
    pub errors: Vec<Option<f64>>,
    /// Number of results that are not a face, or have a greater error.
    pub wrong: usize,
    /// Number of duplicate correct results.
    pub twice: usize,
}

impl Verdict {
    /// From the nearest face of each result, and its error; arbitrary for a scene without faces.
    fn new(count: usize, found: &[(usize, f64)]) -> Self {
        let mut errors = vec![None; count];
        let (mut wrong, mut twice) = (0, 0);
        for &(face, error) in found {
            if count == 0 || error >= RIGHT {
                wrong += 1;
                continue;
            }
            twice += usize::from(errors[face].is_some());
            errors[face] = Some(errors[face].map_or(error, |other: f64| other.min(error)));
        }
        Self { errors, wrong, twice }
    }

    pub fn of(scene: &Scene, model: &Model, photo: &rosto_photo::Photo, faces: &[Face]) -> Self {
        let truths: Vec<_> = scene.faces.iter().map(|placed| model.truth_px(placed)).collect();
        let nearest = |face: &Face| {
            let found = landmarks_px(face, photo);
            let errors = scene.faces.iter().zip(&truths).map(|(at, truth)| error(&found, truth, at, scene.size_px));
            errors.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::INFINITY))
        };
        Self::new(scene.faces.len(), &faces.iter().map(nearest).collect::<Vec<_>>())
    }

    /// MediaPipe's result, from `tests/golden/robustness.json`.
    pub fn of_mediapipe(scene: &Scene, golden: &Value) -> Self {
        let answers = golden[&scene.name].as_array().unwrap_or_else(|| panic!("no result for {}", scene.name));
        let number = |value: &Value| value.as_f64().expect("a number");
        let found = |pair: &Value| (number(&pair[0]).max(0.0) as usize, number(&pair[1]) / 1000.0);
        Self::new(scene.faces.len(), &answers.iter().map(found).collect::<Vec<_>>())
    }

    pub fn right(&self) -> usize {
        self.errors.iter().flatten().count()
    }

    /// Number of faces that are correct in `other` but not in this result.
    pub fn behind(&self, other: &Self) -> usize {
        self.errors.iter().zip(&other.errors).filter(|(own, other)| own.is_none() && other.is_some()).count()
    }
}
