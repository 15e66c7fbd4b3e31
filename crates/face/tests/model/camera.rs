//! Recovery of the face and the camera from landmarks of a pinhole camera.

use crate::common::observed;
use glam::{DQuat, DVec2, DVec3};
use proptest::prelude::*;
use rosto_face::*;
use rosto_mesh::vertex_normals;

const SIZE_PX: [u32; 2] = [900, 1200];

/// A head in front of a camera.
#[derive(Debug, Clone, Copy)]
struct Scene {
    distance_m: f64,
    /// Yaw, pitch and roll in degrees.
    pose_deg: [f64; 3],
    /// Size relative to the canonical face.
    size: f64,
    /// Image position of the face's centre, in px from the principal point.
    aside_px: [f64; 2],
    focal_px: f64,
}

const FRONT: Scene = Scene { distance_m: 0.4, pose_deg: [0.0; 3], size: 1.0, aside_px: [0.0, 0.0], focal_px: 1000.0 };

fn rotation(pose_deg: [f64; 3]) -> DQuat {
    let [yaw, pitch, roll] = pose_deg.map(f64::to_radians);
    DQuat::from_euler(glam::EulerRot::YXZ, yaw, pitch, roll)
}

/// The canonical face in metres, optionally with irises of 11.8 mm at its eyes.
fn head(with_irises: bool) -> Vec<DVec3> {
    let mut head = canonical_positions_m();
    if with_irises {
        let middles = [[159, 145], [386, 374]].map(|[a, b]: [usize; 2]| (head[a] + head[b]) / 2.0);
        for middle in middles {
            // The lids cover a part of the height.
            let high = DVec3::Y / 1.09;
            let around = [DVec3::ZERO, DVec3::X, high, -DVec3::X, -high];
            head.extend(around.map(|direction| middle + direction * 0.011_8 / 2.0));
        }
    }
    head
}

/// Landmarks of a head in a photo, in MediaPipe's convention: depths relative to their mean, at the image's scale.
fn landmarks(head: &[DVec3], scene: Scene) -> Vec<[f32; 3]> {
    let turned: Vec<DVec3> = head.iter().map(|&p| rotation(scene.pose_deg) * p * scene.size).collect();
    let mean = turned[..LANDMARK_COUNT].iter().sum::<DVec3>() / LANDMARK_COUNT as f64;
    let px_per_m = scene.focal_px / scene.distance_m;
    let aside_m = DVec2::from(scene.aside_px) / px_per_m;
    let [width, height] = SIZE_PX.map(f64::from);
    let seen = turned.iter().map(|&p| {
        let p = p - mean;
        let at = (p.truncate() + aside_m) * scene.focal_px / (scene.distance_m - p.z);
        [(at.x + width / 2.0) / width, (height / 2.0 - at.y) / height, -p.z * px_per_m / width]
    });
    seen.map(|point| point.map(|coordinate| coordinate as f32)).collect()
}

fn model(landmarks: &[[f32; 3]], lens: PhotoLens) -> FaceModel {
    FaceModel::new(observed(landmarks, SIZE_PX, lens), Triangulation::Canonical).unwrap()
}

fn furthest_m(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

/// 35-mm-equivalent focal length of a lens with `focal_px` for pictures of [`SIZE_PX`].
fn lens_mm(focal_px: f64) -> f64 {
    focal_px * 36_f64.hypot(24.0) / f64::from(SIZE_PX[0]).hypot(f64::from(SIZE_PX[1]))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_head_seen_from_its_plane_of_symmetry_is_recovered(
        distance_m in 0.25..2.0f64,
        pitch in -25.0..25.0f64,
        size in 0.9..1.1f64,
    ) {
        let scene = Scene { distance_m, pose_deg: [0.0, pitch, 0.0], size, focal_px: 3000.0 * distance_m, ..FRONT };
        let model = model(&landmarks(&head(false), scene), PhotoLens::Given(lens_mm(scene.focal_px)));
        let furthest_m = furthest_m(model.positions_m(), &canonical_positions_m());
        prop_assert!(furthest_m < 2e-6, "{furthest_m} m, limited by f32 landmarks");
        // A photo does not distinguish a large head from a near one.
        prop_assert!((model.camera().distance_m * size / distance_m - 1.0).abs() < 1e-4);
    }

    #[test]
    fn a_turned_head_is_corrected_by_millimetres(
        distance_m in 0.25..2.0f64,
        yaw in -40.0..40.0f64, pitch in -25.0..25.0f64, roll in -50.0..50.0f64,
        aside_px in prop::array::uniform2(-200.0..200.0f64),
    ) {
        let pose_deg = [yaw, pitch, roll];
        let scene = Scene { distance_m, pose_deg, size: 1.0, aside_px, focal_px: 3000.0 * distance_m };
        let model = model(&landmarks(&head(false), scene), PhotoLens::Given(lens_mm(scene.focal_px)));
        prop_assert!(furthest_m(model.positions_m(), &canonical_positions_m()) < 0.004);
        let pose = model.camera().pose();
        let found = [pose.yaw_deg, pose.pitch_deg, pose.roll_deg];
        prop_assert!(found.iter().zip(pose_deg).all(|(a, b)| (a - b).abs() < 1.0), "{found:?}");
    }

    #[test]
    fn parts_that_face_the_camera_coincide_with_the_photo(
        lens in prop_oneof![
            Just(PhotoLens::Estimated),
            (20.0..200.0f64).prop_map(PhotoLens::Given),
            (0.2..3.0f64).prop_map(PhotoLens::Distance),
        ],
        yaw in -40.0..40.0f64,
        seed in 0.0..6.0f64,
    ) {
        let bumpy: Vec<DVec3> = head(true)
            .iter()
            .enumerate()
            .map(|(i, &p)| p + DVec3::new((i as f64 * 0.7 + seed).sin(), (i as f64 * 1.3).cos(), (i as f64).sin()) * 0.000_5)
            .collect();
        let seen = landmarks(&bumpy, Scene { pose_deg: [yaw, 5.0, 3.0], aside_px: [60.0, -40.0], ..FRONT });
        let model = model(&seen, lens);
        let camera = model.camera();
        let normals = vertex_normals(model.topology(), model.positions_m());
        let eye_m = camera.camera_from_model.inverse().translation;
        let placed = model.positions_m().iter().zip(&seen).enumerate().filter(|(landmark, (position_m, _))| {
            normals[*landmark].dot((eye_m - **position_m).normalize()) > 0.7
        });
        let irises = model.irises_m().iter().zip(&seen[LANDMARK_COUNT..]);
        for (&position, at) in placed.map(|(_, pair)| pair).chain(irises) {
            let on_photo = camera.project(position).unwrap();
            let expected = DVec2::new(f64::from(at[0]) * 900.0, f64::from(at[1]) * 1200.0);
            prop_assert!(on_photo.distance(expected) < 1e-6, "{on_photo} {expected}");
        }
    }

    #[test]
    fn lenses_round_trip_as_text(mm in 5.0..2000.0f64, m in 0.1..20.0f64) {
        for lens in [PhotoLens::Estimated, PhotoLens::Parallel, PhotoLens::Exif(mm), PhotoLens::Given(mm), PhotoLens::Distance(m)] {
            prop_assert_eq!(lens.to_string().parse::<PhotoLens>().unwrap(), lens);
        }
        for text in ["", "exif", "exif:", "given:0", "distance:0.05", "distance:NaN", "estimated:3", "near"] {
            prop_assert!(text.parse::<PhotoLens>().is_err(), "{text}");
        }
    }
}

/// The distance at which the canonical face fits a network's landmarks, for a frontal face at `distance_m`.
fn apparent_m(distance_m: f64) -> f64 {
    1.0 / (1.0 + 0.65 / distance_m)
}

#[test]
fn the_distance_of_a_frontal_face_is_estimated_with_its_interval() {
    for pose_deg in [[0.0, 0.0, 0.0], [8.0, 0.0, 20.0], [0.0, -8.0, -70.0], [-6.0, 6.0, 180.0]] {
        let mut nearer_m = 0.0;
        for distance_m in [0.25, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.5, 2.5] {
            let apparent_m = apparent_m(distance_m);
            let scene = Scene { distance_m: apparent_m, pose_deg, focal_px: 2500.0 * apparent_m, ..FRONT };
            let model = model(&landmarks(&head(false), scene), PhotoLens::Estimated);
            let [nearest_m, farthest_m] = model.camera().distance_interval_m;
            let found_m = model.camera().distance_m;
            assert!((nearest_m..farthest_m).contains(&distance_m), "{distance_m} m: {nearest_m} to {farthest_m} m");
            assert!((nearest_m..farthest_m).contains(&found_m) && found_m > nearer_m, "{distance_m} m: {found_m} m");
            nearer_m = found_m;
        }
    }
}

#[test]
fn an_unusual_face_does_not_overrule_lens_data() {
    let seen = landmarks(&head(false), Scene { distance_m: 0.6, focal_px: 3000.0, ..FRONT });
    for focal_px in [1500.0, 3000.0, 12_000.0] {
        let model = model(&seen, PhotoLens::Exif(lens_mm(focal_px)));
        assert!(matches!(model.camera().lens, PhotoLens::Exif(_)));
        assert!((model.camera().distance_m / (focal_px / 5000.0) - 1.0).abs() < 0.1, "{}", model.camera().distance_m);
    }
}

#[test]
fn lens_data_that_put_the_face_before_the_lens_are_rejected() {
    let seen = landmarks(&head(false), Scene { distance_m: 0.6, focal_px: 3000.0, ..FRONT });
    // EXIF of the whole frame, although the picture is a small crop.
    let of_whole_frame = PhotoLens::Exif(lens_mm(800.0));
    let cropped = model(&seen, of_whole_frame);
    assert_eq!(cropped.camera().lens, PhotoLens::Estimated);
    assert_eq!(cropped.lens(), of_whole_frame, "the lens data are retained");
}

#[test]
fn irises_determine_the_size_unless_the_eyes_are_closed() {
    let mut smaller_m = 0.0;
    for size in [0.85, 1.0, 1.15] {
        let scene = Scene { focal_px: 1500.0, ..FRONT };
        // The head is scaled; its irises keep their size.
        let mut grown: Vec<DVec3> = head(true).iter().map(|&p| p * size).collect();
        for eye in 0..2 {
            let at = LANDMARK_COUNT + 5 * eye;
            let centre = grown[at];
            grown[at..at + 5].iter_mut().for_each(|p| *p = centre + (*p - centre) / size);
        }
        let open = model(&landmarks(&grown, scene), PhotoLens::Given(lens_mm(1500.0)));
        assert_eq!(open.scale().source, ScaleSource::Irises);
        let canonical_m = Measure::FaceWidth.of(&canonical_positions_m());
        let width_m = Measure::FaceWidth.of(open.positions_m());
        let error = (width_m / canonical_m / size - 1.0).abs();
        assert!(error < 1.5 * open.scale().error, "{size}: {error}");
        assert!(width_m > smaller_m);
        smaller_m = width_m;
        for [upper, lower] in [[159, 145], [386, 374]] {
            grown[upper] = grown[lower];
        }
        let shut = model(&landmarks(&grown, scene), PhotoLens::Given(lens_mm(1500.0)));
        assert_eq!(shut.scale().source, ScaleSource::Canonical);
        assert!((Measure::FaceWidth.of(shut.positions_m()) / canonical_m - 1.0).abs() < 0.01);
    }
}

#[test]
fn changing_the_lens_is_reversible() {
    let seen = landmarks(&head(true), Scene { pose_deg: [12.0, 3.0, 0.0], ..FRONT });
    let near = model(&seen, PhotoLens::Distance(0.3));
    let far = near.with_lens(PhotoLens::Distance(1.5)).unwrap();
    assert!(furthest_m(near.positions_m(), far.positions_m()) > 0.001, "the nose comes forward");
    assert_eq!(far.with_lens(PhotoLens::Distance(0.3)).unwrap().positions_m(), near.positions_m());
    assert!((far.camera().distance_m - 1.5).abs() < 0.01 && (near.camera().distance_m - 0.3).abs() < 0.003);
    assert!(matches!(near.with_lens(PhotoLens::Distance(0.01)), Err(FaceError::Lens { .. })));
}
