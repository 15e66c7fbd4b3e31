//! Round trips of a face from several photos, with and without photos in the file.

use crate::common::{SIDE, edits, gradient, model, rebuilt};
use glam::{DQuat, DVec3};
use rosto_export::*;
use rosto_face::{
    FaceError, FaceModel, LANDMARK_COUNT, MAX_PHOTOS, Observation, Photo, PhotoLens, Triangulation,
    canonical_positions_m,
};

const EDITS: &str = r#"{"entries":[],"version":1}"#;

/// The canonical head rotated by `by_deg` degrees to its left, seen by a distant camera.
fn turned(by_deg: f64) -> Vec<[f32; 3]> {
    let turn = DQuat::from_rotation_y(by_deg.to_radians());
    let landmark = |p: DVec3| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|at| at as f32);
    canonical_positions_m().into_iter().map(|p| landmark(turn * p)).collect()
}

/// A face from photos with the given head rotations, each with different colours and lenses.
fn several(turns: &[f64]) -> FaceModel {
    let photos = turns.iter().zip(1u8..).map(|(&by_deg, number)| Observation {
        colours_srgb: vec![[number - 1, 100, 200]; LANDMARK_COUNT],
        found_lens: PhotoLens::Exif(25.0 + f64::from(number)),
        card: None,
        lens: PhotoLens::Distance(number.into()),
        ..Observation::in_photo(&gradient(), turned(by_deg))
    });
    FaceModel::from_photos(photos.collect(), Triangulation::Canonical).unwrap()
}

fn assert_same(one: &FaceModel, other: &FaceModel) {
    assert_eq!(one.positions_m(), other.positions_m(), "bit for bit");
    for (one, other) in one.views().iter().zip(other.views()) {
        assert_eq!((one.photo, one.camera, &one.uvs), (other.photo, other.camera, &other.uvs));
        assert_eq!(one.observation.to_bytes(), other.observation.to_bytes());
    }
}

fn glb_of(face: &FaceModel, base_colour: BaseColour) -> Vec<u8> {
    let edits = edits(face, Some(EDITS));
    let source = Some(Source { face, edits: &edits });
    glb(&model(face), &GlbOptions { base_colour, source, ..GlbOptions::default() }).unwrap()
}

fn project_of(face: &FaceModel) -> Vec<u8> {
    project::write(&Source { face, edits: &edits(face, Some(EDITS)) }).unwrap()
}

#[test]
fn a_face_from_several_photos_round_trips() {
    let saved = several(&[0.0, 30.0]);
    for base_colour in BaseColour::ALL {
        assert_same(&rebuilt(reopen(&glb_of(&saved, base_colour)).unwrap().face), &saved);
    }
    // The lead photo is not the first.
    let saved = several(&[30.0, -30.0, 2.0]);
    assert_eq!(saved.views()[0].photo, 2);
    assert_same(&rebuilt(reopen(&glb_of(&saved, BaseColour::Whole)).unwrap().face), &saved);
    assert_same(&rebuilt(project::read(&project_of(&saved)).unwrap().face), &saved);
}

#[test]
fn photos_are_included_unless_the_file_has_vertex_colours() {
    let saved = several(&[0.0, 30.0, -30.0]);
    let glbs = [BaseColour::Whole, BaseColour::Photo].map(|base_colour| reopen(&glb_of(&saved, base_colour)));
    for opened in glbs.into_iter().chain([project::read(&project_of(&saved))]) {
        opened.unwrap().face.photos.into_iter().for_each(|photo| assert_placed(&photo.picture.unwrap()));
    }
    for photo in reopen(&glb_of(&saved, BaseColour::VertexColours)).unwrap().face.photos {
        let painted = photo.picture.unwrap().rgba();
        assert!(painted.as_chunks::<4>().0.contains(&[photo.colours_srgb[0][0], 100, 200, 255]));
    }
}

/// Asserts that the middle of the picture shows the gradient in its place.
fn assert_placed(picture: &Photo) {
    assert_eq!([picture.width(), picture.height()], [SIDE; 2]);
    for at in [[SIDE / 2, SIDE / 2], [SIDE / 2 + 20, SIDE / 2 - 30]] {
        let [found, cut] = [picture, &gradient()].map(|picture| picture.pixel(at[0], at[1]));
        assert!(found.iter().zip(cut).all(|(a, b)| a.abs_diff(b) <= 6), "{found:?} for {cut:?}");
    }
}

#[test]
fn the_found_and_the_chosen_lens_are_kept_apart() {
    let saved = several(&[0.0, 30.0]);
    for file in [glb_of(&saved, BaseColour::Whole), glb_of(&saved, BaseColour::VertexColours)] {
        let lenses: Vec<_> =
            reopen(&file).unwrap().face.photos.iter().map(|photo| (photo.found_lens, photo.lens)).collect();
        let expected = [1.0, 2.0].map(|number| (PhotoLens::Exif(25.0 + number), PhotoLens::Distance(number)));
        assert_eq!(lenses, expected);
    }
}

#[test]
fn texts_give_the_same_face_without_pictures() {
    let saved = reopen(&glb_of(&several(&[0.0, 30.0]), BaseColour::Whole)).unwrap().face;
    let (photos, edits) = (saved.photos_json(), saved.edits.as_ref().unwrap().to_json().unwrap());
    let read = SavedFace::from_json(&photos, Some(&edits)).unwrap();
    assert_eq!((read.photos_json(), read.edits), (photos.clone(), saved.edits));
    assert!(read.photos.iter().all(|photo| photo.picture.is_none()));
    assert_eq!(SavedFace::from_json(&photos, None).unwrap().edits, None);
    assert_eq!(SavedFace::from_json("[]", None), Err(FaceError::PhotoCount { found: 0, most: MAX_PHOTOS }.into()));
    assert_eq!(SavedFace::from_json("{}", None), Err(ReopenError::Field { field: "photos" }));
    assert_eq!(SavedFace::from_json("[", None), Err(ReopenError::NotJson));
}

#[test]
fn invalid_fields_of_photos_are_refused() {
    let file = project_of(&several(&[0.0, 30.0]));
    let refused = |from: &str, to: &str, reason: ReopenError| {
        let line = file.iter().position(|byte| *byte == b'\n').unwrap();
        let header = String::from_utf8(file[..line].to_vec()).unwrap();
        let changed = header.replace(from, to);
        assert_ne!(changed, header);
        let changed = [changed.as_bytes(), &file[line..]].concat();
        assert_eq!(project::read(&changed).unwrap_err(), reason);
    };
    let counted = |found| FaceError::PhotoCount { found, most: MAX_PHOTOS }.into();
    refused("\"photos\":[", "\"photos\":[],\"none\":[", counted(0));
    refused("\"photos\":[", "\"photos\":[{},{},{},{},{},", counted(7));
    let named = |field| ReopenError::Field { field };
    refused("\"observation\":\"", "\"observation\":\"*", named("observation"));
    refused("\"jpeg\":", "\"gif\":", named("picture"));
}
