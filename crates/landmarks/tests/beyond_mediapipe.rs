//! The options that find what MediaPipe does not, and what they cost in agreement with it.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use rosto_landmarks::{Face, FaceFinder, FindOptions, Passes, Search};
use rosto_photo::Photo;
use support::pictures;

const THOROUGH: FindOptions = FindOptions { max_faces: 1, search: Search::Thorough, passes: Passes::One };
const TWO_PASSES: FindOptions = FindOptions { max_faces: 1, search: Search::Once, passes: Passes::Two };

fn only_face(finder: &FaceFinder, photo: &Photo, options: &FindOptions) -> Face {
    let mut faces = finder.find(photo, options).unwrap();
    assert_eq!(faces.len(), 1);
    faces.remove(0)
}

/// x and y of each landmark in px of the picture.
fn positions_px(face: &Face, photo: &Photo) -> Vec<[f64; 2]> {
    let (width, height) = (f64::from(photo.width()), f64::from(photo.height()));
    face.landmarks.iter().map(|&[x, y, _]| [f64::from(x) * width, f64::from(y) * height]).collect()
}

/// Where positions in `pictures::turned(portrait, degrees)` lie in the portrait.
fn turned_back(positions_px: Vec<[f64; 2]>, degrees: f64) -> Vec<[f64; 2]> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let centre = 511.0 / 2.0;
    let back = |[x, y]: [f64; 2]| {
        let (dx, dy) = (x - centre, y - centre);
        [centre + cos * dx + sin * dy, centre - sin * dx + cos * dy]
    };
    positions_px.into_iter().map(back).collect()
}

fn mean_distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let total: f64 = a.iter().zip(b).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).sum();
    total / a.len() as f64
}

#[test]
fn a_face_on_its_head_gets_the_mesh_it_has_upright() {
    let (finder, portrait) = (support::finder(), support::assets::portrait());
    let upright = positions_px(&only_face(&finder, &portrait, &FindOptions::default()), &portrait);
    for degrees in [135.0, 180.0, -150.0] {
        let picture = pictures::turned(&portrait, degrees);
        let found = positions_px(&only_face(&finder, &picture, &THOROUGH), &picture);
        let distance_px = mean_distance(&turned_back(found, degrees), &upright);
        assert!(distance_px < 3.0, "{degrees}°: {distance_px} px");
    }
}

#[test]
fn a_small_face_in_a_wide_picture_is_found_in_a_tile() {
    let (finder, portrait) = (support::finder(), support::assets::portrait());
    let upright = positions_px(&only_face(&finder, &portrait, &FindOptions::default()), &portrait);
    let (left, top) = (700, 200);
    let wide = pictures::padded(&portrait, 1600, 900, left, top);
    assert!(finder.find(&wide, &FindOptions::default()).unwrap().is_empty());
    let found = positions_px(&only_face(&finder, &wide, &THOROUGH), &wide);
    let moved: Vec<_> = found.iter().map(|[x, y]| [x - f64::from(left), y - f64::from(top)]).collect();
    let distance_px = mean_distance(&moved, &upright);
    assert!(distance_px < 3.0, "{distance_px} px");
}

#[test]
fn looking_thoroughly_invents_no_face() {
    let (finder, portrait) = (support::finder(), support::assets::portrait());
    for picture in [pictures::cropped(&portrait, 280, 240, 200, 200), pictures::toned(&portrait, |_| 0.0)] {
        assert!(finder.find(&picture, &THOROUGH).unwrap().is_empty());
    }
}

#[test]
fn two_passes_agree_better_between_pictures_of_one_face() {
    let (finder, portrait) = (support::finder(), support::assets::portrait());
    let spread_px = |options: &FindOptions| {
        let upright = positions_px(&only_face(&finder, &portrait, options), &portrait);
        let distances = [-45.0, -20.0, 15.0, 30.0, 60.0, 90.0].map(|degrees| {
            let picture = pictures::turned(&portrait, degrees);
            let found = positions_px(&only_face(&finder, &picture, options), &picture);
            mean_distance(&turned_back(found, degrees), &upright)
        });
        distances.iter().sum::<f64>() / distances.len() as f64
    };
    let (one, two) = (spread_px(&FindOptions::default()), spread_px(&TWO_PASSES));
    assert!(two < 0.6 * one, "{one} px with one pass, {two} px with two");
}

#[test]
fn tiny_and_thin_pictures_are_looked_at_without_trouble() {
    let finder = support::finder();
    for (width, height) in [(1, 1), (1, 300), (2000, 2), (7, 5)] {
        let picture = Photo::from_rgb(width, height, vec![90; width as usize * height as usize * 3]).unwrap();
        for options in [FindOptions::default(), THOROUGH] {
            assert!(finder.find(&picture, &options).unwrap().is_empty(), "{width}×{height}");
        }
    }
}
