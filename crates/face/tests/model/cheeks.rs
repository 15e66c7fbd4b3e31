//! Covers painted over a cheek of the sample portrait, and pictures of it without a cover.

use crate::pictures;
use std::path::Path;

use rosto_face::{Region, covered_cheek, face_width_px, mirror_of};
use rosto_photo::{Limits, Photo, decode};
use serde_json::Value;

type Landmarks = Vec<[f32; 3]>;

/// Landmarks of a cheek's middle.
const MIDDLE: [(Region, usize); 2] = [(Region::RightCheek, 50), (Region::LeftCheek, 280)];

/// The sample portrait and its landmarks. The subject is turned slightly.
fn portrait() -> (Photo, Landmarks) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets/sample.png");
    let photo = decode(&std::fs::read(path).unwrap(), &Limits::default()).unwrap();
    let golden: Value = serde_json::from_str(include_str!("../../../../tests/golden/portrait_landmarks.json")).unwrap();
    let rows = golden["landmarks"].as_array().unwrap().iter();
    (photo, rows.map(|row| [0, 1, 2].map(|axis| row[axis].as_f64().unwrap() as f32)).collect())
}

fn flipped((photo, landmarks): &(Photo, Landmarks)) -> (Photo, Landmarks) {
    let mirrored = (0..468_u32).map(|landmark| {
        let [x, y, z] = landmarks[mirror_of(landmark) as usize];
        [1.0 - x, y, z]
    });
    (pictures::flipped(photo), mirrored.collect())
}

fn turned((photo, landmarks): &(Photo, Landmarks), degrees: f64) -> (Photo, Landmarks) {
    let (sin, cos) = (degrees as f32).to_radians().sin_cos();
    let turned = landmarks.iter().map(|&[x, y, z]| {
        let (x, y) = (x - 0.5, y - 0.5);
        [0.5 + cos * x - sin * y, 0.5 + sin * x + cos * y, z]
    });
    (pictures::turned(photo, degrees), turned.collect())
}

/// Paints each pixel by its colour and its place in px.
fn painted(photo: &Photo, colour: impl Fn([u8; 3], [f32; 2]) -> [u8; 3]) -> Photo {
    let places = (0..photo.height()).flat_map(|y| (0..photo.width()).map(move |x| (x, y)));
    let pixels = places.flat_map(|(x, y)| colour(photo.pixel(x, y), [x as f32, y as f32])).collect();
    Photo::from_rgb(photo.width(), photo.height(), pixels).unwrap()
}

/// Paints each pixel by its colour and its place relative to a landmark, in widths of the face.
fn painted_at(
    (photo, landmarks): &(Photo, Landmarks),
    landmark: usize,
    colour: impl Fn([u8; 3], [f32; 2]) -> [u8; 3],
) -> Photo {
    let [centre_x, centre_y, _] = landmarks[landmark];
    let [width, height] = [photo.width(), photo.height()];
    let face_px = face_width_px(landmarks, [width, height]).unwrap() as f32;
    painted(photo, |old, [x, y]| {
        colour(old, [(x - centre_x * width as f32) / face_px, (y - centre_y * height as f32) / face_px])
    })
}

/// A dark block, such as a microphone or a phone.
fn with_block(original: &(Photo, Landmarks), landmark: usize) -> Photo {
    painted_at(original, landmark, |colour, [x, y]| if x.hypot(y - 0.1) < 0.15 { [32, 32, 36] } else { colour })
}

/// Strands of brown hair, a fiftieth of the face wide.
fn with_strands(original: &(Photo, Landmarks), landmark: usize) -> Photo {
    painted_at(original, landmark, |colour, [x, y]| {
        let across = (x + 0.3 * y + 0.02 * (20.0 * y).sin()).rem_euclid(0.055);
        if x.abs() < 0.2 && across < 0.02 { [58, 40, 30] } else { colour }
    })
}

/// Light from one side that fades smoothly to `darkest` on the other, in the colour `tint`.
fn lit(photo: &Photo, darkest: f32, tint: [f32; 3]) -> Photo {
    painted(photo, |colour, [x, _]| {
        let share = ((x / photo.width() as f32 - 0.3) / 0.3).clamp(0.0, 1.0);
        let share = share * share * (3.0 - 2.0 * share);
        std::array::from_fn(|i| {
            (f32::from(colour[i]) * (darkest + (1.0 - darkest) * share) * (tint[i] + (1.0 - tint[i]) * share)) as u8
        })
    })
}

#[test]
fn a_cover_is_found_on_its_side() {
    let original = portrait();
    for (cheek, landmark) in MIDDLE {
        for (name, photo) in
            [("block", with_block(&original, landmark)), ("strands", with_strands(&original, landmark))]
        {
            let covered = (photo, original.1.clone());
            let [tilted, fallen] = [20.0, -100.0].map(|degrees| turned(&covered, degrees));
            for (photo, landmarks) in [&covered, &tilted, &fallen] {
                assert_eq!(covered_cheek(photo, landmarks), Some(cheek), "{name}");
            }
            let (photo, landmarks) = flipped(&covered);
            assert_eq!(covered_cheek(&photo, &landmarks), Some(cheek.mirrored()), "{name}, mirrored");
        }
    }
}

#[test]
fn nothing_is_found_on_both_cheeks() {
    let original = portrait();
    for cover in [with_block, with_strands] {
        let one = cover(&original, MIDDLE[0].1);
        assert_eq!(covered_cheek(&cover(&(one, original.1.clone()), MIDDLE[1].1), &original.1), None);
    }
}

#[test]
fn light_tone_blur_and_size_do_not_cover_a_cheek() {
    let (photo, landmarks) = portrait();
    let tones: [fn(f64) -> f64; 4] =
        [|value| value.powf(2.2), |value| value.powf(0.5), |value| 0.4 + 0.2 * value, |value| (2.0 * value).min(1.0)];
    let mut variants = vec![photo.clone(), pictures::grey(&photo)];
    variants.extend(tones.map(|tone| pictures::toned(&photo, tone)));
    variants.extend([1, 2, 4].map(|radius| pictures::blurred(&photo, radius)));
    variants.extend([200, 700, 1500].map(|side| pictures::scaled(&photo, side, side)));
    for darkest in [0.6, 0.3, 0.1] {
        for tint in [[1.0; 3], [0.4, 0.6, 1.0], [1.0, 0.6, 0.4]] {
            let light = lit(&photo, darkest, tint);
            variants.push(pictures::flipped(&lit(&pictures::flipped(&photo), darkest, tint)));
            variants.push(light);
        }
    }
    for (index, variant) in variants.iter().enumerate() {
        assert_eq!(covered_cheek(variant, &landmarks), None, "variant {index}");
    }
    for degrees in (-180..180).step_by(30) {
        let (variant, landmarks) = turned(&(photo.clone(), landmarks.clone()), f64::from(degrees));
        assert_eq!(covered_cheek(&variant, &landmarks), None, "{degrees}°");
    }
    let (mirrored, landmarks) = flipped(&(photo, landmarks));
    assert_eq!(covered_cheek(&mirrored, &landmarks), None);
}

/// Landmarks of the canonical face, turned to its left, in a picture of 500 px.
fn canonical(yaw_deg: f64) -> Landmarks {
    let turn = glam::DMat3::from_rotation_y(yaw_deg.to_radians());
    let place = |&position_m: &glam::DVec3| {
        let at = turn * position_m * 4.0;
        [0.5 + at.x, 0.5 - at.y, -at.z].map(|number| number as f32)
    };
    rosto_face::canonical_positions_m().iter().map(place).collect()
}

#[test]
fn a_cheek_that_the_head_itself_hides_is_not_judged() {
    let skin = Photo::from_rgb(500, 500, [200, 150, 130].repeat(500 * 500)).unwrap();
    for (yaw_deg, expected) in [(0.0, Some(Region::RightCheek)), (30.0, Some(Region::RightCheek)), (40.0, None)] {
        let landmarks = canonical(yaw_deg);
        let photo = with_block(&(skin.clone(), landmarks.clone()), MIDDLE[0].1);
        assert_eq!(covered_cheek(&photo, &landmarks), expected, "{yaw_deg}°");
        assert_eq!(covered_cheek(&skin, &landmarks), None);
    }
}

#[test]
fn the_width_scales_with_the_picture_and_not_with_the_turn() {
    let width_px = |landmarks: &Landmarks, side: u32| face_width_px(landmarks, [side, side]).unwrap();
    let landmarks = canonical(0.0);
    let across = f64::from(landmarks[454][0] - landmarks[234][0]) * 500.0;
    assert!((width_px(&landmarks, 500) - across).abs() < 0.01 * across);
    assert!((width_px(&landmarks, 50) - across / 10.0).abs() < 0.001 * across);
    assert!((width_px(&canonical(50.0), 500) - across).abs() < 0.01 * across);
    assert_eq!(face_width_px(&landmarks[..3], [500, 500]), None);
}
