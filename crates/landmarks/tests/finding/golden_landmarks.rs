//! Agreement with MediaPipe's landmarks on the pictures of `support::pictures`.

use crate::support;
use crate::support::pictures::{self, Picture};
use rosto_landmarks::{Face, FaceFinder, FindOptions};
use serde_json::Value;

const GOLDEN: &str = include_str!("../../../../tests/golden/landmarks.json");
/// Landmarks of the attention network, with refined lips and eyes, and irises.
const GOLDEN_REFINED: &str = include_str!("../../../../tests/golden/refined_landmarks.json");

#[test]
fn landmarks_are_within_a_twentieth_of_a_pixel_of_mediapipes() {
    assert_agrees(&support::finder(), GOLDEN, 0.05);
}

#[test]
fn refined_landmarks_and_irises_are_within_a_tenth_of_a_pixel_of_mediapipes() {
    assert_agrees(&support::attention_finder(), GOLDEN_REFINED, 0.1);
}

fn assert_agrees(finder: &FaceFinder, golden: &str, tolerance_px: f64) {
    let golden: Value = serde_json::from_str(golden).unwrap();
    let pictures = pictures::all(&support::assets::portrait());
    assert_eq!(pictures.len(), golden.as_object().unwrap().len());
    for picture in &pictures {
        let options = FindOptions { max_faces: picture.max_faces, ..FindOptions::mediapipe() };
        let faces = finder.find(&picture.photo, &options).unwrap();
        let expected = golden[picture.name]["faces"].as_array().unwrap();
        assert_eq!(faces.len(), expected.len(), "number of faces in {}", picture.name);
        for (face, expected) in faces.iter().zip(expected) {
            let error_px = worst_error_px(picture, face, expected);
            assert!(error_px < tolerance_px, "{}: {error_px} px", picture.name);
        }
    }
}

/// Largest difference in x, y or z, in px of the picture. The golden numbers are thousandths of a px.
fn worst_error_px(picture: &Picture, face: &Face, millipixels: &Value) -> f64 {
    let (width, height) = (f64::from(picture.photo.width()), f64::from(picture.photo.height()));
    let found_px = face
        .landmarks
        .iter()
        .flat_map(|&[x, y, z]| [f64::from(x) * width, f64::from(y) * height, f64::from(z) * width]);
    let expected = millipixels.as_array().unwrap();
    assert_eq!(face.landmarks.len() * 3, expected.len());
    found_px
        .zip(expected)
        .map(|(found, expected)| (found - expected.as_f64().unwrap() / 1000.0).abs())
        .fold(0.0, f64::max)
}
