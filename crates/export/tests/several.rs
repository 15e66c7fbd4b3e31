//! Round trips of a face from several photos, with and without photos in the file.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::{SIDE, gradient, model, png, source};
use glam::{DQuat, DVec3};
use rosto_export::*;
use rosto_face::{FaceInput, FaceModel, LANDMARK_COUNT, Photo, PhotoLens, Triangulation, canonical_positions_m};

const EDITS: &str = r#"{"entries":[],"version":1}"#;

/// The canonical head rotated by `by_deg` degrees to its left, seen by a distant camera.
fn turned(by_deg: f64) -> Vec<[f32; 3]> {
    let turn = DQuat::from_rotation_y(by_deg.to_radians());
    let landmark = |p: DVec3| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|at| at as f32);
    canonical_positions_m().into_iter().map(|p| landmark(turn * p)).collect()
}

/// A face from photos with the given head rotations, each with different colours and lens data.
fn several(turns: &[f64]) -> FaceModel {
    let landmarks: Vec<_> = turns.iter().map(|&by_deg| turned(by_deg)).collect();
    let colours: Vec<_> = (0..turns.len()).map(|photo| vec![[photo as u8, 100, 200]; LANDMARK_COUNT]).collect();
    let inputs = landmarks.iter().zip(&colours).zip(1..).map(|((landmarks, colours), number)| FaceInput {
        landmarks,
        width: SIDE,
        height: SIDE,
        colours,
        picture: gradient(),
        lens: PhotoLens::Distance(f64::from(number)),
    });
    FaceModel::from_photos(inputs.collect(), Triangulation::Canonical).unwrap()
}

/// Rebuilds the face from a reopened file, as the page and the command line do.
fn opened(file: &Reopened<'_>) -> FaceModel {
    let input = |landmarks, [width, height]: [u32; 2], colours, lens| FaceInput {
        landmarks,
        width,
        height,
        colours,
        picture: gradient(),
        lens,
    };
    let further = file.further.as_ref().unwrap();
    let others = further.photos.iter();
    let others = others.map(|photo| input(&photo.landmarks, photo.photo_size_px, &photo.colours_srgb, photo.lens));
    let mut inputs: Vec<_> = others.collect();
    let lead = input(&file.landmarks, file.photo_size_px, &file.colours_srgb, file.lens);
    inputs.insert(further.leads, lead);
    FaceModel::from_photos(inputs, file.triangulation).unwrap()
}

fn assert_same(one: &FaceModel, other: &FaceModel) {
    assert_eq!(one.positions_m(), other.positions_m(), "bit for bit");
    for (one, other) in one.views().iter().zip(other.views()) {
        assert_eq!((one.photo, one.camera, one.lens), (other.photo, other.camera, other.lens));
        assert_eq!((&one.uvs, &one.colours_srgb), (&other.uvs, &other.colours_srgb));
    }
}

fn glb_of(face: &FaceModel, base_colour: BaseColour) -> Vec<u8> {
    let source = Some(source(face, Some(EDITS)));
    glb(&model(face), &GlbOptions { base_colour, source, ..GlbOptions::default() }).unwrap()
}

fn project_of(face: &FaceModel) -> Vec<u8> {
    project::write(&source(face, Some(EDITS)), &png()).unwrap()
}

#[test]
fn a_face_from_several_photos_round_trips() {
    let saved = several(&[0.0, 30.0]);
    for base_colour in BaseColour::ALL {
        assert_same(&opened(&reopen(&glb_of(&saved, base_colour)).unwrap()), &saved);
    }
    // The lead photo is not the first.
    let saved = several(&[30.0, -30.0, 2.0]);
    assert_eq!(saved.views()[0].photo, 2);
    assert_same(&opened(&reopen(&glb_of(&saved, BaseColour::Whole)).unwrap()), &saved);
    assert_same(&opened(&project::read(&project_of(&saved)).unwrap()), &saved);
}

#[test]
fn photos_are_included_unless_the_file_has_vertex_colours() {
    let saved = several(&[0.0, 30.0, -30.0]);
    let photos = |file: &Reopened<'_>| file.further.clone().unwrap().photos;
    for file in [glb_of(&saved, BaseColour::Whole), glb_of(&saved, BaseColour::Photo)] {
        for photo in photos(&reopen(&file).unwrap()) {
            assert_placed(photo.texture.unwrap());
        }
    }
    for photo in photos(&project::read(&project_of(&saved)).unwrap()) {
        assert_placed(photo.texture.unwrap());
    }
    for photo in photos(&reopen(&glb_of(&saved, BaseColour::VertexColours)).unwrap()) {
        assert_eq!(photo.texture, None);
        let painted = photo.painted();
        assert!(painted.rgba.as_chunks::<4>().0.contains(&[photo.colours_srgb[0][0], 100, 200, 255]));
    }
}

fn assert_placed(texture: PlacedTexture<'_>) {
    let crop = rosto_photo::decode(&texture.encoded, &rosto_photo::Limits::default()).unwrap();
    let [left, top] = texture.at_px.map(|at| u32::try_from(at).unwrap());
    let (x, y) = (crop.width() / 2, crop.height() / 3);
    let [found, cut]: [[u8; 3]; 2] = [crop.pixel(x, y), Photo::pixel(&gradient(), left + x, top + y)];
    assert!(found.iter().zip(cut).all(|(a, b)| a.abs_diff(b) <= 6), "{found:?} for {cut:?}");
}

#[test]
fn invalid_fields_of_further_photos_are_named() {
    let file = project_of(&several(&[0.0, 30.0]));
    let refused = |from: &str, to: &str, field: &'static str| {
        let line = file.iter().position(|byte| *byte == b'\n').unwrap();
        let header = String::from_utf8(file[..line].to_vec()).unwrap();
        let changed = header.replace(from, to);
        assert_ne!(changed, header);
        let changed = [changed.as_bytes(), &file[line..]].concat();
        assert_eq!(project::read(&changed).unwrap_err(), ReopenError::Field { field });
    };
    refused("\"leads\":0", "\"leads\":2", "further");
    refused("\"photos\":[{", "\"photos\":[],\"none\":[{", "further");
    refused("\"lens\":\"distance:2\",\"photo_px\"", "\"lens\":\"none\",\"photo_px\"", "lens");
    refused("\"photo_px\":[300,300]", "\"photo_px\":[300,0]", "photo_px");
    refused("\"jpeg\":", "\"gif\":", "picture");
}
