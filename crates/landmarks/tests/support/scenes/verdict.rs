//! What was found in a scene, held against what is there.

use rosto_landmarks::Face;
use serde_json::Value;

use super::{Model, Scene, error, landmarks_px};

/// A face counts as right if its landmarks are off by less than this share of the distance between the eyes, in the mean.
pub const RIGHT: f64 = 0.1;

/// The answer of one finder to one scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// For each face that is there, the least error of what was found for it, if anything was.
    pub errors: Vec<Option<f64>>,
    /// How many of those found are no face, or lie wrongly on one.
    pub wrong: usize,
    /// How many right ones there are beside another one of the same face.
    pub twice: usize,
}

impl Verdict {
    /// From which face each of those found is, and its error; of a scene without faces, anything.
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

    /// MediaPipe's, of `tests/golden/robustness.json`.
    pub fn of_mediapipe(scene: &Scene, golden: &Value) -> Self {
        let answers = golden[&scene.name].as_array().unwrap_or_else(|| panic!("no answer for {}", scene.name));
        let number = |value: &Value| value.as_f64().expect("a number");
        let found = |pair: &Value| (number(&pair[0]).max(0.0) as usize, number(&pair[1]) / 1000.0);
        Self::new(scene.faces.len(), &answers.iter().map(found).collect::<Vec<_>>())
    }

    pub fn right(&self) -> usize {
        self.errors.iter().flatten().count()
    }

    /// How many faces the other one has right and this one has not.
    pub fn behind(&self, other: &Self) -> usize {
        self.errors.iter().zip(&other.errors).filter(|(own, other)| own.is_none() && other.is_some()).count()
    }
}
