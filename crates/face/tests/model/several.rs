//! Joint fits of synthetic heads from several photos with pinhole cameras.

use crate::common::observed;
use glam::{DQuat, DVec2, DVec3};
use proptest::prelude::*;
use rosto_face::*;

const SIZE_PX: [u32; 2] = [900, 1200];
const FOCAL_PX: f64 = 1500.0;
const DISTANCE_M: f64 = 0.45;

/// Parameters of a synthetic photo.
#[derive(Debug, Clone, Copy)]
struct Shot {
    yaw_deg: f64,
    pitch_deg: f64,
    /// Amplitude of the landmark noise.
    noise_px: f64,
    /// Amplitude of a systematic depth error, which varies over the face.
    bias_m: f64,
    seed: f64,
}

const fn turned(yaw_deg: f64) -> Shot {
    Shot { yaw_deg, pitch_deg: 3.0, noise_px: 0.0, bias_m: 0.003, seed: 1.0 }
}

const ROUND: [Shot; 3] = [turned(0.0), turned(40.0), turned(-40.0)];

/// Pseudo-random number from -1 to 1.
fn scattered(seed: f64) -> f64 {
    (seed * 12.9898).sin() * 43_758.545_3 % 1.0
}

/// The canonical face with a smooth shape deviation of a few mm.
fn head(seed: f64) -> Vec<DVec3> {
    let wave = |p: DVec3, at: f64| (p.x * 31.0 + p.y * 23.0 + at).sin() + (p.y * 37.0 - p.x * 11.0 + 2.0 * at).cos();
    let grown = |p: DVec3| p + DVec3::new(0.3 * wave(p, seed + 4.0), 0.3 * wave(p, seed + 7.0), wave(p, seed)) * 0.002;
    canonical_positions_m().into_iter().map(grown).collect()
}

fn rotation(shot: Shot) -> DQuat {
    DQuat::from_euler(glam::EulerRot::YXZ, shot.yaw_deg.to_radians(), shot.pitch_deg.to_radians(), 0.05)
}

/// Transforms a head to the camera's frame.
fn in_camera(head: &[DVec3], shot: Shot) -> Vec<DVec3> {
    let middle_m = canonical_positions_m().iter().sum::<DVec3>() / LANDMARK_COUNT as f64;
    head.iter().map(|&p| rotation(shot) * (p - middle_m) + DVec3::new(0.01, -0.02, -DISTANCE_M)).collect()
}

/// The head with the network's bias, applied along the lead photo's rays, where it cannot be observed.
fn biased(head: &[DVec3], lead: Shot) -> Vec<DVec3> {
    let out = in_camera(head, lead).into_iter().enumerate().map(|(i, p)| p / p.z * depth_bias_m(i as u32));
    head.iter().zip(out).map(|(&p, out)| p + rotation(lead).inverse() * out).collect()
}

/// Landmarks that the network finds in a photo of a head.
fn landmarks(head: &[DVec3], shot: Shot) -> Vec<[f32; 3]> {
    let [width, height] = SIZE_PX.map(f64::from);
    let seen = in_camera(head, shot).into_iter().enumerate().map(|(i, p)| {
        let noise_px =
            DVec2::new(scattered(i as f64 + shot.seed), scattered(i as f64 + shot.seed + 0.5)) * shot.noise_px;
        let at_px = DVec2::new(p.x, -p.y) * FOCAL_PX / -p.z + noise_px;
        let bias_m = shot.bias_m * (p.x * 40.0 + p.y * 25.0 + shot.seed).sin();
        let depth_px = (-DISTANCE_M - p.z + bias_m) * FOCAL_PX / DISTANCE_M;
        [at_px.x / width + 0.5, at_px.y / height + 0.5, depth_px / width]
    });
    seen.map(|point| point.map(|coordinate| coordinate as f32)).collect()
}

fn lens() -> PhotoLens {
    PhotoLens::Given(FOCAL_PX * 36_f64.hypot(24.0) / f64::from(SIZE_PX[0]).hypot(f64::from(SIZE_PX[1])))
}

fn several(photos: &[Vec<[f32; 3]>], lens: PhotoLens) -> Result<FaceModel, FaceError> {
    FaceModel::from_photos(
        photos.iter().map(|photo| observed(photo, SIZE_PX, lens)).collect(),
        Triangulation::Canonical,
    )
}

/// Landmarks in several photos of a head; the least turned photo leads.
fn photos(head: &[DVec3], shots: &[Shot]) -> Vec<Vec<[f32; 3]>> {
    let lead = shots.iter().min_by(|a, b| a.yaw_deg.abs().total_cmp(&b.yaw_deg.abs())).unwrap();
    let biased = biased(head, *lead);
    shots.iter().map(|&shot| landmarks(&biased, shot)).collect()
}

fn of(head: &[DVec3], shots: &[Shot]) -> FaceModel {
    several(&photos(head, shots), lens()).unwrap()
}

fn furthest_m(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

/// Errors of the model in m, at landmarks well visible to the lead camera and another one, in the lead camera's frame. The model
/// is scaled to the head's size.
fn errors_m(model: &FaceModel, head: &[DVec3], shots: &[Shot]) -> Vec<(usize, f64)> {
    let truth = in_camera(head, shots[model.views()[0].photo]);
    let found: Vec<DVec3> =
        model.positions_m().iter().map(|&p| model.camera().camera_from_model.transform_point3(p)).collect();
    let times = truth.iter().map(|p| p.z).sum::<f64>() / found.iter().map(|p| p.z).sum::<f64>();
    let normals = rosto_mesh::vertex_normals(&Triangulation::Canonical.topology(), head);
    let sees = |shot: &Shot, i: usize| (rotation(*shot) * normals[i]).dot(-in_camera(head, *shot)[i].normalize()) > 0.5;
    let lead = &shots[model.views()[0].photo];
    let seen_twice =
        (0..LANDMARK_COUNT).filter(|&i| sees(lead, i) && shots.iter().filter(|shot| sees(shot, i)).count() > 1);
    seen_twice.map(|i| (i, (found[i] * times).distance(truth[i]))).collect()
}

fn rms(errors: &[(usize, f64)]) -> f64 {
    (errors.iter().map(|(_, error)| error * error).sum::<f64>() / errors.len() as f64).sqrt()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn a_head_is_recovered_from_three_sides(seed in 0.0..60.0f64) {
        let head = head(seed);
        let [one, three] = [&ROUND[..1], &ROUND].map(|shots| rms(&errors_m(&of(&head, shots), &head, &ROUND)));
        prop_assert!(one > 0.001 && three < one / 12.0, "{one} m by one photo, {three} m by three");
    }

    #[test]
    fn noise_has_little_effect(seed in 0.0..60.0f64) {
        let head = head(seed);
        let noisy = ROUND.map(|shot| Shot { noise_px: 0.5, seed: seed + shot.yaw_deg, ..shot });
        let [one, three] = [&noisy[..1], &noisy].map(|shots| rms(&errors_m(&of(&head, shots), &head, &noisy)));
        prop_assert!(three < 6e-4 && three < one / 4.0, "{one} m by one photo, {three} m by three");
    }

    #[test]
    #[ignore = "slow; runs at night"]
    fn the_model_coincides_with_the_lead_photo(seed in 0.0..60.0f64, yaw_deg in -14.0..14.0f64, others in 0..4usize) {
        let shots: Vec<Shot> = [45.0, -30.0, yaw_deg, 20.0].into_iter().rev().take(others + 1).map(turned).collect();
        for lens in [lens(), PhotoLens::Estimated, PhotoLens::Parallel, PhotoLens::Distance(0.35)] {
            let noisy: Vec<Shot> = shots.iter().map(|&shot| Shot { noise_px: 1.0, ..shot }).collect();
            let photos = photos(&head(seed), &noisy);
            let model = several(&photos, lens).unwrap();
            let lead = &model.views()[0];
            prop_assert_eq!(model.positions_image()[7].as_vec3().to_array(), photos[lead.photo][7]);
            let normals = rosto_mesh::vertex_normals(model.topology(), model.positions_m());
            let eye_m = model.camera().camera_from_model.inverse().translation;
            for ((&position_m, uv), normal) in model.positions_m().iter().zip(&lead.uvs).zip(normals) {
                // Landmarks that do not face the camera leave their rays.
                if normal.dot((eye_m - position_m).normalize()) < 0.8 {
                    continue;
                }
                let apart_px = model.camera().project(position_m).unwrap().distance(*uv * DVec2::new(900.0, 1200.0));
                prop_assert!(apart_px < 1e-6, "{lens:?}: {apart_px} px");
            }
        }
    }

    #[test]
    #[ignore = "slow; runs at night"]
    fn the_order_of_the_photos_does_not_matter(seed in 0.0..60.0f64) {
        let shots = [turned(-35.0), turned(2.0), turned(28.0), turned(50.0)].map(|shot| Shot { noise_px: 1.0, seed, ..shot });
        let reference = of(&head(seed), &shots);
        for order in [[1, 0, 2, 3], [3, 2, 1, 0], [2, 3, 0, 1]] {
            let other = of(&head(seed), &order.map(|at: usize| shots[at]));
            prop_assert!(furthest_m(reference.positions_m(), other.positions_m()) < 1e-9);
            prop_assert_eq!(order[other.views()[0].photo], 1, "the same photo leads");
        }
    }

    #[test]
    #[ignore = "slow; runs at night"]
    fn duplicate_photos_do_not_change_the_model(seed in 0.0..60.0f64) {
        let head = head(seed);
        let shots = ROUND.map(|shot| Shot { noise_px: 1.0, seed, ..shot });
        let [front, left, right] = shots;
        let once = of(&head, &shots);
        for twice in [[front, left, right, left], [front, right, left, right]] {
            let apart_m = furthest_m(once.positions_m(), of(&head, &twice).positions_m());
            prop_assert!(apart_m < 1e-9, "{apart_m} m");
        }
        let apart_m = furthest_m(of(&head, &[front]).positions_m(), of(&head, &[front, front]).positions_m());
        prop_assert!(apart_m < 1e-9, "{apart_m} m");
    }

    #[test]
    #[ignore = "slow; runs at night"]
    fn more_photos_predict_a_left_out_photo_better(seed in 0.0..60.0f64) {
        let shots = [turned(0.0), turned(25.0), turned(-35.0), turned(45.0)].map(|shot| Shot { noise_px: 0.3, seed, ..shot });
        let left_out = of(&head(seed), &shots).left_out().unwrap();
        prop_assert_eq!(left_out.len(), shots.len());
        for LeftOut { photo, by_one, by_others } in left_out {
            prop_assert!(by_others.rms_px < 0.7 * by_one.rms_px, "{photo}: {by_one:?} {by_others:?}");
        }
    }
}

#[test]
fn a_single_photo_gives_the_same_model_as_new() {
    let photo = landmarks(&head(5.0), turned(8.0));
    let together = several(std::slice::from_ref(&photo), PhotoLens::Estimated).unwrap();
    let alone = FaceModel::new(observed(&photo, SIZE_PX, PhotoLens::Estimated), Triangulation::Canonical).unwrap();
    assert_eq!((together.positions_m(), together.camera()), (alone.positions_m(), alone.camera()));
    assert_eq!(together.views().len(), 1);
    assert!(together.left_out().unwrap().is_empty());
}

#[test]
fn cameras_of_all_photos_are_recovered() {
    let head = head(11.0);
    for lens in [lens(), PhotoLens::Distance(DISTANCE_M)] {
        let model = several(&photos(&head, &ROUND), lens).unwrap();
        for view in model.views() {
            let pose = view.camera.pose();
            assert!((pose.yaw_deg - model.camera().pose().yaw_deg - ROUND[view.photo].yaw_deg).abs() < 0.5, "{pose:?}");
            let shown = in_camera(&head, ROUND[view.photo]);
            let mut apart_px: Vec<f64> = (model.positions_m().iter().zip(&shown))
                .map(|(&position_m, p)| {
                    let at_px = DVec2::new(p.x, -p.y) * FOCAL_PX / -p.z + DVec2::new(450.0, 600.0);
                    view.camera.project(position_m).unwrap().distance(at_px)
                })
                .collect();
            apart_px.sort_by(f64::total_cmp);
            assert!(apart_px[234] < 0.3, "{}: {} px", view.photo, apart_px[234]);
            assert!(view.reprojection.rms_px < 0.5, "{:?}", view.reprojection);
            assert!((view.camera.distance_m / DISTANCE_M - 1.0).abs() < 0.02, "{}", view.camera.distance_m);
        }
    }
}

#[test]
fn changing_the_lens_of_several_photos_is_reversible() {
    let near = of(&head(3.0), &[turned(-30.0), turned(4.0), turned(35.0)]);
    let far = near.with_lens(PhotoLens::Distance(1.5)).unwrap();
    assert!((far.camera().distance_m - 1.5).abs() < 0.005, "{}", far.camera().distance_m);
    assert_eq!(far.views()[1].observation.lens, lens(), "the other photos keep their lenses");
    let back = far.with_lens(near.lens()).unwrap();
    assert_eq!((back.positions_m(), back.views()[2].camera), (near.positions_m(), near.views()[2].camera));
}

#[test]
fn adding_and_removing_photos_equals_a_joint_fit() {
    let shots = [turned(-30.0), turned(4.0), turned(35.0)];
    let shown = photos(&head(3.0), &shots);
    let same = |one: &FaceModel, other: &FaceModel| {
        assert_eq!(one.positions_m(), other.positions_m(), "bit for bit");
        let cameras =
            |model: &FaceModel| model.views().iter().map(|view| (view.photo, view.camera)).collect::<Vec<_>>();
        assert_eq!(cameras(one), cameras(other));
    };
    let all = several(&shown, lens()).unwrap();
    let last = observed(&shown[2], SIZE_PX, lens());
    same(&several(&shown[..2], lens()).unwrap().with_photo(last).unwrap(), &all);
    same(&all.without_photo(2).unwrap(), &several(&shown[..2], lens()).unwrap());
    same(&all.without_photo(1).unwrap(), &several(&[shown[0].clone(), shown[2].clone()], lens()).unwrap());
    same(&all.without_photo(3).unwrap(), &all);
    let alone = all.without_photo(2).unwrap().without_photo(0).unwrap();
    same(&alone, &several(&shown[1..2], lens()).unwrap());
    assert_eq!(alone.without_photo(0).unwrap_err(), FaceError::PhotoCount { found: 0, most: MAX_PHOTOS });
}

#[test]
fn another_expression_has_little_effect_elsewhere() {
    let (head, mut smiling) = (head(21.0), head(21.0));
    let moved = [Region::Lips, Region::RightUpperEyelid].map(Region::vertices).concat();
    for &landmark in &moved {
        let position_m = &mut smiling[landmark as usize];
        *position_m += DVec3::new(position_m.x * 0.2, 0.004, -0.002);
    }
    let [front, ..] = &photos(&head, &ROUND)[..] else { unreachable!() };
    let [_, left, right] = &photos(&smiling, &ROUND)[..] else { unreachable!() };
    let mixed = several(&[front.clone(), left.clone(), right.clone()], lens()).unwrap();
    let [alone, calm, mixed] = [&of(&head, &ROUND[..1]), &of(&head, &ROUND), &mixed].map(|model| {
        let mut errors = errors_m(model, &head, &ROUND);
        errors.retain(|(landmark, _)| !moved.contains(&(*landmark as u32)));
        rms(&errors)
    });
    assert!(calm < mixed && mixed < alone / 3.0, "{calm} m, {mixed} m with smiles, {alone} m by one photo");
}

#[test]
fn other_faces_and_invalid_photos_are_refused() {
    let head = head(2.0);
    let photos = photos(&head, &ROUND);
    let mut strange = head.clone();
    // A distortion that no camera explains.
    strange.iter_mut().for_each(|p| p.y += 0.02 * (p.y * 60.0).sin());
    let [front, left, _] = &photos[..] else { unreachable!() };
    let error = several(&[front.clone(), left.clone(), landmarks(&strange, ROUND[2])], lens()).unwrap_err();
    let FaceError::AnotherFace { photo: 2, reprojection_px, most_px } = error else { panic!("{error}") };
    assert!(reprojection_px > most_px && most_px > 5.0);
    assert_eq!(several(&[], lens()).unwrap_err(), FaceError::PhotoCount { found: 0, most: MAX_PHOTOS });
    let many = vec![front.clone(); MAX_PHOTOS + 1];
    assert_eq!(several(&many, lens()).unwrap_err(), FaceError::PhotoCount { found: 6, most: MAX_PHOTOS });
    let short = several(&[front.clone(), left[..400].to_vec()], lens()).unwrap_err();
    let reason = Box::new(FaceError::WrongCount { what: "landmarks", expected: 468, found: 400 });
    assert_eq!(short, FaceError::InPhoto { photo: 1, reason });
}

#[test]
fn missing_turns_are_reported() {
    let pose = |yaw_deg: f64| Pose { yaw_deg, pitch_deg: 0.0, roll_deg: 0.0 };
    assert_eq!(Turn::missing([]), Turn::ALL);
    assert_eq!(Turn::missing([0.0, 30.0].map(pose)), [Turn::Right]);
    assert_eq!(Turn::missing([17.0, -21.0, 80.0].map(pose)), [Turn::Front, Turn::Left]);
    let model = of(&head(1.0), &ROUND);
    assert!(Turn::missing(model.views().iter().map(|view| view.camera.pose())).is_empty());
}
