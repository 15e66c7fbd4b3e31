//! Whole-face textures.

use rosto_face::*;
use rosto_studio::*;

use crate::faces::portrait_landmarks;
use crate::texture_truth::{DISTANCE_M, Head, SIZE_PX, errors, face, observed};

const SIDE_PX: u32 = 1024;

fn taken(head: &Head, yaw_deg: f64) -> (FaceModel, Camera) {
    let camera = head.camera(yaw_deg);
    (face(head.photo(&camera), &head.landmarks(&camera), PhotoLens::Distance(DISTANCE_M)), camera)
}

/// Masks of the skin that none of the cameras sees, and of the skin that one of them sees.
fn hidden_and_seen(head: &Head, cameras: &[Camera]) -> [Vec<bool>; 2] {
    let side = SIDE_PX as usize;
    let seen: Vec<Vec<bool>> = cameras.iter().map(|camera| head.seen(camera, side)).collect();
    let skin = head.skin(side);
    [false, true].map(|wanted| {
        (0..side * side).map(|texel| skin[texel] && seen.iter().any(|seen| seen[texel]) == wanted).collect()
    })
}

#[test]
fn hidden_skin_is_closer_to_the_truth_than_projected_pixels() {
    let head = Head::painted(SIDE_PX);
    for yaw_deg in [0.0, 40.0, -40.0] {
        let (face, camera) = taken(&head, yaw_deg);
        let whole = whole_texture(&face, SIDE_PX).unwrap();
        let [hidden, seen] = hidden_and_seen(&head, &[camera]);
        let of = |texels: &[bool], found: &Photo| errors(&head.texture, found, texels);
        let before = of(&hidden, &head.projected(&face, SIDE_PX as usize));
        let ([median, most], [seen_median, seen_most]) = (of(&hidden, &whole.picture), of(&seen, &whole.picture));
        assert!(most < 30.0 && most < 0.5 * before[1], "{most} levels at {yaw_deg}°, and {before:?} before");
        assert!(median < 12.0, "{median} levels at {yaw_deg}°, and {before:?} before");
        assert!(seen_median < 1.0 && seen_most < 8.0, "{seen_median} and {seen_most} in visible areas at {yaw_deg}°");
    }
}

#[test]
#[ignore = "slow; runs at night"]
fn three_photos_of_different_exposure_cover_the_face() {
    let head = Head::painted(SIDE_PX);
    let cameras = [0.0, 40.0, -40.0].map(|yaw_deg| head.camera(yaw_deg));
    let [front, left, right] = cameras.map(|camera| {
        let (picture, landmarks) = (head.photo(&camera), head.landmarks(&camera));
        observed(picture, &landmarks, PhotoLens::Distance(DISTANCE_M))
    });
    let dimmed = |photo: Observation| {
        let pixels = photo.picture.unwrap();
        let levels = pixels.pixels().iter().map(|level| (f64::from(*level) * 0.75) as u8);
        Observation { picture: Some(Photo::from_rgb(SIZE_PX, SIZE_PX, levels.collect()).unwrap()), ..photo }
    };
    let [left, right] = [left, right].map(dimmed);
    let texture = |photos: [&Observation; 3]| {
        let photos = photos.map(Clone::clone).to_vec();
        whole_texture(&FaceModel::from_photos(photos, Triangulation::Canonical).unwrap(), SIDE_PX).unwrap()
    };
    let whole = texture([&front, &left, &right]);
    let [_, seen] = hidden_and_seen(&head, &cameras);
    let [median, most] = errors(&head.texture, &whole.picture, &seen);
    assert!(median < 1.5 && most < 6.0, "{median} and {most} levels");
    assert!(whole.shares.seen > 0.9, "{:?}", whole.shares);
    let again = texture([&front, &right, &left]);
    let [_, most] = errors(&whole.picture, &again.picture, &vec![true; (SIDE_PX * SIDE_PX) as usize]);
    assert!(most <= 3.0, "{most} levels by the order of the photos");
}

/// The texture depends on the face, not on its triangulation.
#[test]
fn both_triangulations_give_the_same_texture() {
    let head = Head::painted(SIDE_PX);
    let (canonical, camera) = taken(&head, 20.0);
    let observation = observed(head.photo(&camera), &head.landmarks(&camera), PhotoLens::Distance(DISTANCE_M));
    let tessellated = FaceModel::new(observation, Triangulation::Tessellation).unwrap();
    assert_eq!(whole_texture(&canonical, 256), whole_texture(&tessellated, 256));
}

#[test]
fn a_face_without_its_picture_is_refused() {
    let observation = crate::faces::observed(portrait_landmarks(), 512, PhotoLens::Estimated);
    let face = FaceModel::new(observation, Triangulation::Canonical).unwrap();
    assert_eq!(whole_texture(&face, 256), Err(StudioError::NoPicture));
}

/// Two texels per photo pixel, so that a photo of twice the width needs a texture of twice the side.
#[test]
fn the_texture_side_fits_the_photo_and_the_limit() {
    let head = Head::painted(256);
    let camera = head.camera(0.0);
    let face_in = |size_px: u32| {
        let picture = Photo::from_rgb(size_px, size_px, vec![128; 3 * (size_px * size_px) as usize]).unwrap();
        face(picture, &head.landmarks(&camera), PhotoLens::Distance(DISTANCE_M))
    };
    let side_px = |size_px, at_most_px| texture_side_px(&face_in(size_px), |_| Some([size_px; 2]), at_most_px);
    assert_eq!([16, 1024, 2048].map(|size_px| side_px(size_px, 4096)), [1024, 2048, 4096]);
    assert_eq!([256, 1024, 2048].map(|at_most_px| side_px(2048, at_most_px)), [256, 1024, 2048]);
}
