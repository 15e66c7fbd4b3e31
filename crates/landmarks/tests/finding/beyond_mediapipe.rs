//! Faces found beyond MediaPipe, on a subset of the scenes of docs/accuracy.md.

use crate::support;
use crate::support::pictures;
use crate::support::scenes::canvas::Ground;
use crate::support::scenes::verdict::Verdict;
use crate::support::scenes::{self, Model, Scene, families};
use rosto_landmarks::{Face, FaceFinder, FindOptions, Search, Stage};
use rosto_photo::Photo;

fn only_face(finder: &FaceFinder, photo: &Photo, options: &FindOptions) -> Face {
    let mut faces = finder.find(photo, options).unwrap();
    assert_eq!(faces.len(), 1);
    faces.remove(0)
}

fn scene(name: &str) -> Scene {
    families::all().into_iter().find(|scene| scene.name == name).unwrap_or_else(|| panic!("no scene {name}"))
}

/// Asserts that all faces and no others are found, with a mean landmark error below 5 % of the distance between the
/// eyes.
fn assert_all_found(names: &[&str]) {
    let finder = support::attention_finder();
    let model = Model::new(&finder, &support::assets::portrait());
    for name in names {
        let scene = scene(name);
        let photo = scene.picture(&model);
        let options = FindOptions { max_faces: 30, ..FindOptions::default() };
        let verdict = Verdict::of(&scene, &model, &photo, &finder.find(&photo, &options).unwrap());
        assert_eq!((verdict.right(), verdict.wrong, verdict.twice), (scene.faces.len(), 0, 0), "{name}");
        assert!(verdict.errors.iter().flatten().all(|&error| error < 0.05), "{name}: {:?}", verdict.errors);
    }
}

#[test]
fn rotated_faces_have_the_upright_mesh() {
    assert_all_found(&["turned_75_near", "turned_105_far", "turned_135_near", "turned_180_far", "turned_210_near"]);
}

#[test]
#[ignore = "slow; runs at night"]
fn a_face_with_32_px_between_the_eyes_is_found_in_12_megapixels() {
    assert_all_found(&["12mp_eyes_32_corner"]);
}

#[test]
fn faces_cut_by_the_border_are_found() {
    assert_all_found(&["cut_left_30", "cut_bottom_40", "cut_top_30"]);
}

#[test]
#[ignore = "slow; runs at night"]
fn all_faces_of_a_group_are_found_once() {
    assert_all_found(&["group_5_cells_280_tilt_20", "group_24_cells_240_tilt_15"]);
}

#[test]
#[ignore = "slow; runs at night"]
fn dark_low_contrast_noisy_and_blurred_faces_are_found() {
    assert_all_found(&["gamma_3_near", "contrast_10_far", "noise_80_near", "blur_3_near", "jpeg_10_far"]);
}

#[test]
#[ignore = "slow; runs at night"]
fn no_face_is_found_in_pictures_without_faces() {
    let finder = support::attention_finder();
    let portrait = support::assets::portrait();
    let grounds = Ground::ALL.map(|ground| ground.picture(600, 500, 7, &portrait));
    let portraits_rest = pictures::cropped(&portrait, 280, 240, 200, 200);
    let folds = scene("empty_7_4000x3000").picture(&Model::new(&finder, &portrait));
    for (index, picture) in grounds.iter().chain([&portraits_rest, &folds]).enumerate() {
        assert!(finder.find(picture, &FindOptions::default()).unwrap().is_empty(), "picture {index}");
    }
}

#[test]
fn the_large_face_comes_first_for_any_limit() {
    let finder = support::attention_finder();
    let model = Model::new(&finder, &support::assets::portrait());
    let mut scene = scene("group_2_cells_400_tilt_10");
    scene.size_px = [900, 700];
    scene.faces =
        vec![scenes::Placement::upright([120.0, 110.0], 0.6), scenes::Placement::upright([520.0, 380.0], 2.4)];
    let photo = scene.picture(&model);
    for max_faces in [1, 2] {
        let faces = finder.find(&photo, &FindOptions { max_faces, ..FindOptions::default() }).unwrap();
        assert_eq!(faces.len(), max_faces);
        let first_px = scenes::landmarks_px(&faces[0], &photo)[1];
        assert!((first_px[0] - 520.0).hypot(first_px[1] - 380.0) < 40.0, "{first_px:?}");
    }
}

/// In this picture, a sleeve is detected with lower confidence; it is larger and nearer to the centre than the face.
#[test]
fn a_prominent_doubtful_face_comes_after_certain_ones() {
    let finder = support::attention_finder();
    let portrait = pictures::scaled(&support::assets::portrait(), 850, 850);
    let photo = pictures::padded(&portrait, 1600, 900, 700, 0);
    for max_faces in [1, 20] {
        let faces = finder.find(&photo, &FindOptions { max_faces, ..FindOptions::default() }).unwrap();
        let nose_px = scenes::landmarks_px(&faces[0], &photo)[1];
        assert!((nose_px[0] - 1073.0).hypot(nose_px[1] - 220.0) < 60.0, "{nose_px:?}");
        assert!(faces[0].confidence >= 0.9 && !faces[0].is_doubtful());
        assert_eq!(faces.len(), max_faces.min(2));
        assert!(faces[1..].iter().all(Face::is_doubtful));
    }
}

#[test]
#[ignore = "slow; runs at night"]
fn at_least_counts_faces_beyond_the_limit() {
    let finder = support::attention_finder();
    let (cell_px, columns, rows) = (256, 8, 5);
    let portrait = pictures::scaled(&support::assets::portrait(), cell_px, cell_px);
    let row = (1..columns).fold(portrait.clone(), |row, _| pictures::side_by_side(&row, &portrait));
    let sheet = Photo::from_rgb(columns * cell_px, rows * cell_px, row.pixels().repeat(rows as usize)).unwrap();
    for max_faces in [2, 20, 100] {
        let options = FindOptions { max_faces, ..FindOptions::default() };
        let found = finder.find_with_progress(&sheet, &options, |_| ()).unwrap();
        assert_eq!((found.faces.len(), found.at_least), (max_faces.min(40), 40));
    }
}

/// Mean distance of the landmarks of every other variant of a face from those of the portrait, px.
fn spread_px(finder: &FaceFinder, model: &Model, options: &FindOptions) -> f64 {
    let upright = scenes::landmarks_px(&only_face(finder, &model.portrait, options), &model.portrait);
    let distances = families::variants().into_iter().step_by(2).map(|scene| {
        let photo = scene.picture(model);
        let found = scenes::landmarks_px(&only_face(finder, &photo, options), &photo);
        let truth = model.placed_landmarks_px(&upright, &scene.faces[0]);
        scenes::error(&found, &truth, &scene.faces[0], scene.size_px) * scenes::EYE_DISTANCE_PX
    });
    let distances: Vec<f64> = distances.collect();
    distances.iter().sum::<f64>() / distances.len() as f64
}

#[test]
#[ignore = "slow; runs at night"]
fn thorough_landmarks_vary_less_between_variants_of_a_face() {
    let finder = support::attention_finder();
    let model = Model::new(&finder, &support::assets::portrait());
    let (one, settled) = (
        spread_px(&finder, &model, &FindOptions::mediapipe()),
        spread_px(&finder, &model, &FindOptions { max_faces: 1, ..FindOptions::default() }),
    );
    assert!(settled < 0.7 * one, "{one} px with MediaPipe's options, {settled} px with the thorough search");
}

#[test]
fn progress_does_not_decrease_and_ends() {
    let finder = support::attention_finder();
    let photo = pictures::padded(&support::assets::portrait(), 1600, 900, 700, 200);
    let mut shares = Vec::new();
    let report = |stage| {
        shares.push(match stage {
            Stage::Detecting { share } => share,
            Stage::Meshing { face, of } => 1.0 + face as f32 / of as f32,
        });
    };
    let found = finder.find_with_progress(&photo, &FindOptions::default(), report).unwrap();
    assert_eq!((found.faces.len(), found.at_least), (1, 1));
    assert!(
        shares.is_sorted() && shares[0] == 0.0 && shares.iter().all(|share| (0.0..2.0).contains(share)),
        "{shares:?}"
    );
}

#[test]
fn tiny_and_thin_pictures_have_no_faces() {
    let finder = support::attention_finder();
    for (width, height) in [(1, 1), (1, 300), (2000, 2), (7, 5)] {
        let picture = Photo::from_rgb(width, height, vec![90; width as usize * height as usize * 3]).unwrap();
        for search in [Search::Once, Search::Thorough] {
            let options = FindOptions { search, ..FindOptions::default() };
            assert!(finder.find(&picture, &options).unwrap().is_empty(), "{width}×{height}");
        }
    }
}
