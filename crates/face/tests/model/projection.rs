//! Projection of model points by the photo's camera, at its own and at other distances.

use crate::common::observed;
use glam::{DQuat, DVec2, DVec3};
use rosto_face::*;

const SIZE_PX: [u32; 2] = [900, 1200];
const LENSES: [PhotoLens; 6] = [
    PhotoLens::Estimated,
    PhotoLens::Parallel,
    PhotoLens::Exif(26.0),
    PhotoLens::Given(26.0),
    PhotoLens::Given(85.0),
    PhotoLens::Distance(0.35),
];

/// A turned head away from the centre of the photo, seen from 40 cm.
fn landmarks() -> Vec<[f32; 3]> {
    let turn = DQuat::from_euler(glam::EulerRot::YXZ, 0.2, -0.1, 0.15);
    let head: Vec<DVec3> = canonical_positions_m().into_iter().map(|position_m| turn * position_m).collect();
    let mean_m = head.iter().sum::<DVec3>() / head.len() as f64;
    let [width, height] = SIZE_PX.map(f64::from);
    let seen = head.iter().map(|position_m| {
        let at_m = *position_m - mean_m + DVec3::new(0.05, 0.03, 0.0);
        let at_px = at_m.truncate() * 1000.0 / (0.4 - at_m.z);
        [(at_px.x + width / 2.0) / width, (height / 2.0 - at_px.y) / height, -at_m.z * 2500.0 / width]
    });
    seen.map(|point| point.map(|coordinate| coordinate as f32)).collect()
}

fn model(lens: PhotoLens) -> FaceModel {
    FaceModel::new(observed(&landmarks(), SIZE_PX, lens), Triangulation::Canonical).unwrap()
}

/// Offsets from the face's centre in the camera's frame, within and around the face.
fn around() -> impl Iterator<Item = DVec3> {
    let steps = || [-0.1, 0.0, 0.07].into_iter();
    steps().flat_map(move |x| steps().flat_map(move |y| steps().map(move |z| DVec3::new(x, y, z))))
}

fn middle_m(face: &FaceModel) -> DVec3 {
    face.positions_m().iter().sum::<DVec3>() / face.positions_m().len() as f64
}

#[test]
fn landmarks_project_to_their_image_positions() {
    let size_px = DVec2::from(SIZE_PX.map(f64::from));
    for lens in LENSES {
        let face = model(lens);
        let normals = rosto_mesh::vertex_normals(face.topology(), face.positions_m());
        let eye_m = face.camera().camera_from_model.inverse().translation;
        let faces = |landmark: usize| normals[landmark].dot((eye_m - face.positions_m()[landmark]).normalize()) > 0.6;
        let placed = face.positions_m().iter().zip(face.positions_image()).enumerate();
        for (_, (position_m, found)) in placed.filter(|(landmark, _)| faces(*landmark)) {
            let seen_px = face.camera().project(*position_m).unwrap();
            let apart_px = seen_px.distance(found.truncate() * size_px);
            assert!(apart_px < 1e-6, "{lens:?}: {apart_px} px from {seen_px}");
        }
    }
}

#[test]
fn points_behind_the_camera_and_nan_are_not_projected() {
    for lens in LENSES {
        let camera = *model(lens).camera();
        let model_from_camera = camera.camera_from_model.inverse();
        assert_eq!(camera.project(model_from_camera.transform_point3(DVec3::new(0.1, 0.1, 0.2))), None, "{lens:?}");
        assert_eq!(camera.project(DVec3::NAN), None);
        let [near, far] = [-0.2, -0.3].map(|z| model_from_camera.transform_point3(DVec3::new(0.0, 0.0, z)));
        assert!((camera.towards_camera_m(near) - camera.towards_camera_m(far) - 0.1).abs() < 1e-9);
    }
}

#[test]
fn changing_the_distance_keeps_the_pivot_plane_fixed() {
    for lens in LENSES {
        let face = model(lens);
        let (camera, pivot_m) = (face.camera(), middle_m(&face));
        let model_from_camera = camera.camera_from_model.matrix3.transpose();
        for distance_m in [0.2, 0.7, 3.0, 20.0] {
            let moved = camera.at_distance(distance_m, pivot_m);
            assert_eq!(moved.distance_m, distance_m);
            for offset in around() {
                let position_m = pivot_m + model_from_camera * DVec3::new(offset.x, offset.y, 0.0);
                let (before, after) = (camera.project(position_m).unwrap(), moved.project(position_m).unwrap());
                assert!(before.distance(after) < 1e-6, "{lens:?} from {distance_m} m: {before} and {after}");
            }
        }
    }
}

/// A pinhole camera moved back along its ray to the pivot P, to k times the distance, sees a point at offset d from P
/// at k·f · ((k·P + d)xy / (k·P + d)z − Pxy / Pz) relative to the pivot's image.
#[test]
fn changing_the_distance_gives_correct_perspective() {
    for lens in [PhotoLens::Estimated, PhotoLens::Given(26.0), PhotoLens::Distance(0.35)] {
        let face = model(lens);
        let (camera, pivot_m) = (face.camera(), middle_m(&face));
        let seen_m = camera.camera_from_model.transform_point3(pivot_m);
        let model_from_camera = camera.camera_from_model.matrix3.transpose();
        let divided = |at: DVec3| DVec2::new(at.x, -at.y) / -at.z;
        for times in [0.6, 2.0, 30.0] {
            let moved = camera.at_distance(times * camera.distance_m, pivot_m);
            for offset in around() {
                let seen_px = moved.project(pivot_m + model_from_camera * offset).unwrap();
                let from_pivot = (divided(times * seen_m + offset) - divided(seen_m)) * times * camera.focal_px;
                let expected = camera.project(pivot_m).unwrap() + from_pivot;
                assert!(seen_px.distance(expected) < 1e-6, "{lens:?}, {times} times: {seen_px}, {expected}");
            }
        }
    }
}

#[test]
fn changing_the_distance_is_reversible() {
    for lens in LENSES {
        let face = model(lens);
        let camera = face.camera();
        let seen_px = |camera: &Camera| {
            face.positions_m().iter().map(|position_m| camera.project(*position_m).unwrap()).collect::<Vec<_>>()
        };
        let own_m = if camera.distance_m.is_finite() { camera.distance_m } else { 1e5 };
        let there = camera.at_distance(1.5, middle_m(&face));
        for same in [face.seen_from(own_m), there.at_distance(own_m, middle_m(&face))] {
            let apart = seen_px(camera).iter().zip(seen_px(&same)).map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
            // At 100 km, parallel rays converge by less than a thousandth of a px.
            let most_px = if camera.distance_m.is_finite() { 1e-6 } else { 1e-3 };
            assert!(apart < most_px, "{lens:?}: {apart} px");
        }
    }
}

/// The nose appears smaller relative to the ears from farther away.
#[test]
fn the_nose_shrinks_with_distance() {
    let face = model(PhotoLens::Distance(0.35));
    let size = |camera: &Camera| {
        let [left, right] = [98, 327].map(|landmark: usize| camera.project(face.positions_m()[landmark]).unwrap());
        left.distance(right)
    };
    let sizes = [0.25, 0.35, 0.6, 1.5, 10.0].map(|distance_m| size(&face.seen_from(distance_m)));
    assert!(sizes.is_sorted_by(|nearer, farther| nearer > farther), "{sizes:?}");
    assert_eq!(face.seen_from(0.35).distance_m, 0.35);
}
