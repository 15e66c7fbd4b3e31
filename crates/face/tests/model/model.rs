//! Invariances of the metric model under pose, picture size and mirroring.

use crate::common::observed;
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use rosto_face::*;

/// Landmarks are f32 and a face fills a fifth of the picture, so rounding errors are about 0.1 µm.
const TOLERANCE_M: f64 = 1e-6;

struct Portrait {
    width: u32,
    height: u32,
    landmarks: Vec<[f32; 3]>,
}

fn portrait() -> Portrait {
    let text = include_str!("../../../../tests/golden/portrait_landmarks.json");
    let json: serde_json::Value = serde_json::from_str(text).unwrap();
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let landmarks = json["landmarks"].as_array().unwrap().iter();
    Portrait {
        width: number(&json["width"]) as u32,
        height: number(&json["height"]) as u32,
        landmarks: landmarks.map(|p| [0, 1, 2].map(|axis| number(&p[axis]) as f32)).collect(),
    }
}

fn model(landmarks: &[[f32; 3]], width: u32, height: u32) -> Result<FaceModel, FaceError> {
    FaceModel::new(observed(landmarks, [width, height], PhotoLens::Parallel), Triangulation::Canonical)
}

/// Transforms the portrait's landmarks in px.
fn changed_in_px(portrait: &Portrait, change: impl Fn(DVec3) -> DVec3) -> Vec<[f32; 3]> {
    let size = DVec3::new(portrait.width.into(), portrait.height.into(), portrait.width.into());
    let px = portrait.landmarks.iter().map(|p| DVec3::from(p.map(f64::from)) * size);
    px.map(|p| (change(p) / size).to_array().map(|c| c as f32)).collect()
}

fn furthest_m(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

#[test]
fn the_portrait_is_upright_frontal_and_of_canonical_size() {
    let portrait = portrait();
    let model = model(&portrait.landmarks, portrait.width, portrait.height).unwrap();
    let at = |landmark: usize| model.positions_m()[landmark];
    let (forehead, chin, nose_tip, left_eye, right_eye) = (at(10), at(152), at(4), at(263), at(33));
    assert!(forehead.y - chin.y > 0.15, "upright");
    assert!(nose_tip.z > at(234).z + 0.05 && nose_tip.z > at(454).z + 0.05, "nose towards the viewer");
    assert!(left_eye.x > 0.03 && right_eye.x < -0.03, "the subject's left towards +X");
    let level = (left_eye - right_eye).normalize();
    assert!(level.x > 0.995, "the head's tilt is removed: {level}");
    let canonical = canonical_positions_m();
    let ratio = left_eye.distance(right_eye) / canonical[263].distance(canonical[33]);
    assert!((0.9..1.1).contains(&ratio), "eyes {ratio} of the canonical distance apart");
}

#[test]
fn model_displacements_map_to_image_displacements() {
    let portrait = portrait();
    let model = model(&portrait.landmarks, portrait.width, portrait.height).unwrap();
    let (metric, image) = (model.positions_m(), model.positions_image());
    for landmark in 1..LANDMARK_COUNT {
        let mapped = model.image_from_model() * (metric[landmark] - metric[0]);
        assert!(mapped.distance(image[landmark] - image[0]) < 1e-12);
    }
}

#[test]
fn padding_the_picture_does_not_change_the_model() {
    let portrait = portrait();
    let square = model(&portrait.landmarks, portrait.width, portrait.height).unwrap();
    let halved: Vec<[f32; 3]> = portrait.landmarks.iter().map(|&[x, y, z]| [x, y / 2.0, z]).collect();
    let tall = model(&halved, portrait.width, portrait.height * 2).unwrap();
    assert!(furthest_m(square.positions_m(), tall.positions_m()) < 1e-12);
}

#[test]
fn a_mirrored_photo_gives_the_mirrored_model() {
    let portrait = portrait();
    let mut flipped = portrait.landmarks.clone();
    for (landmark, &[x, y, z]) in portrait.landmarks.iter().enumerate() {
        flipped[mirror_of(landmark as u32) as usize] = [1.0 - x, y, z];
    }
    let original = model(&portrait.landmarks, portrait.width, portrait.height).unwrap();
    let mirrored = model(&flipped, portrait.width, portrait.height).unwrap();
    let expected: Vec<DVec3> = (0..LANDMARK_COUNT as u32)
        .map(|landmark| original.positions_m()[mirror_of(landmark) as usize] * DVec3::new(-1.0, 1.0, 1.0))
        .collect();
    assert!(furthest_m(&expected, mirrored.positions_m()) < TOLERANCE_M);
}

#[test]
fn invalid_landmarks_are_refused() {
    let portrait = portrait();
    let count = model(&portrait.landmarks[..400], 512, 512).unwrap_err();
    assert_eq!(count, FaceError::WrongCount { what: "landmarks", expected: 468, found: 400 });
    let mut broken = portrait.landmarks.clone();
    broken[17][1] = f32::NAN;
    assert_eq!(model(&broken, 512, 512).unwrap_err(), FaceError::NotFinite { landmark: 17 });
    let area = model(&portrait.landmarks, 0, 512).unwrap_err();
    assert_eq!(area, FaceError::EmptyPicture { width: 0, height: 512 });
    let line: Vec<[f32; 3]> = (0..LANDMARK_COUNT).map(|i| [i as f32 / 468.0, 0.5, 0.0]).collect();
    assert_eq!(model(&line, 512, 512).unwrap_err(), FaceError::Degenerate);
    assert_eq!(model(&[[0.5; 3]; LANDMARK_COUNT], 512, 512).unwrap_err(), FaceError::Degenerate);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_model_is_invariant_to_pose_position_and_size(
        axis in prop::array::uniform3(-1.0..1.0f64),
        angle in -3.0..3.0f64,
        scale in 0.3..3.0f64,
        shift_px in prop::array::uniform3(-100.0..100.0f64),
    ) {
        prop_assume!(DVec3::from(axis).length() > 0.1);
        let turn = DQuat::from_axis_angle(DVec3::from(axis).normalize(), angle);
        let portrait = portrait();
        let moved = changed_in_px(&portrait, |p| turn * p * scale + DVec3::from(shift_px));
        let original = model(&portrait.landmarks, portrait.width, portrait.height).unwrap();
        let posed = model(&moved, portrait.width, portrait.height).unwrap();
        prop_assert!(furthest_m(original.positions_m(), posed.positions_m()) < TOLERANCE_M);
    }
}
