//! Properties of all lenses, and of each.

use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use rosto_stage::{Camera, Glide, Lens, NamedView, PicturePlane, Pinhole};

const CENTRE_M: DVec3 = DVec3::new(0.004, -0.01, 0.02);
const RADIUS_M: f64 = 0.12;
const SIZE_PX: [u32; 2] = [800, 600];

/// A phone's pose to the side of the face, above it and tilted.
fn pinhole() -> Pinhole {
    let turned = DQuat::from_euler(glam::EulerRot::YXZ, -0.35, 0.2, 0.15);
    let position = DVec3::new(0.06, -0.04, -0.36) - turned * CENTRE_M;
    Pinhole { camera_from_model: DAffine3::from_rotation_translation(turned, position) }
}

/// A camera at rest that frames a sphere.
fn camera(lens: Lens) -> Camera {
    let mut camera = Camera::default();
    camera.resize(SIZE_PX[0], SIZE_PX[1]);
    camera.set_glide(Glide::Off);
    camera.set_pinhole(Some(pinhole()));
    camera.set_lens(lens);
    camera.frame(CENTRE_M, RADIUS_M);
    camera
}

/// The same camera orbited, panned, zoomed and with insets.
fn steered(lens: Lens) -> Camera {
    let mut camera = camera(lens);
    camera.orbit(130.0, -70.0);
    camera.pan(12.0, 35.0);
    camera.zoom(1.7);
    camera.set_viewport_insets([20.0, 0.0, 90.0, 140.0]);
    camera.advance(0.0);
    camera
}

/// Points on the sphere and inside it.
fn points_m() -> impl Iterator<Item = DVec3> {
    (0..60).map(|point| {
        let (turn, height) = (f64::from(point) * 2.4, 1.0 - f64::from(point) / 29.5);
        let around = (1.0 - height * height).max(0.0).sqrt();
        let share = 1.0 - 0.5 * f64::from(point % 3) / 2.0;
        CENTRE_M + DVec3::new(turn.cos() * around, height, turn.sin() * around) * RADIUS_M * share
    })
}

/// Bounding box of the sphere on the screen in px, found by rays that hit it.
fn silhouette_px(camera: &Camera) -> [f64; 4] {
    let hits = |position_px: DVec2| {
        let ray = camera.ray(position_px);
        (CENTRE_M - ray.origin).cross(ray.direction).length() < RADIUS_M
    };
    let size_px = camera.size_px();
    let lines = |count: f64| (0..=400).map(move |line| f64::from(line) / 400.0 * count);
    let column = |x: f64| lines(size_px.y).any(|y| hits(DVec2::new(x, y)));
    let row = |y: f64| lines(size_px.x).any(|x| hits(DVec2::new(x, y)));
    let ends = |count: f64, any: &dyn Fn(f64) -> bool| {
        let met: Vec<f64> = lines(count).filter(|&at| any(at)).collect();
        [met[0], *met.last().unwrap()]
    };
    let ([left, right], [top, bottom]) = (ends(size_px.x, &column), ends(size_px.y, &row));
    [left, top, right, bottom]
}

#[test]
fn ray_inverts_project() {
    for lens in Lens::ALL {
        let camera = steered(lens);
        for point_m in points_m() {
            let position_px = camera.project(point_m).unwrap();
            let ray = camera.ray(position_px);
            let to_point_m = point_m - ray.origin;
            assert!(
                to_point_m.cross(ray.direction).length() < 1e-12 && to_point_m.dot(ray.direction) > 0.0,
                "{lens:?}"
            );
            assert!((ray.direction.length() - 1.0).abs() < 1e-12);
            assert!(ray.direction.distance(-camera.to_eye(point_m)) < 1e-9, "{lens:?}");
            let along = camera.project(ray.origin + ray.direction * 0.1).unwrap();
            assert!(along.distance(position_px) < 1e-6, "{lens:?}: {along}");
        }
    }
}

#[test]
fn view_plane_offsets_follow_the_pointer() {
    let motion_px = DVec2::new(25.0, -14.0);
    for lens in Lens::ALL {
        let camera = steered(lens);
        for point_m in points_m() {
            let moved_m = point_m + camera.view_plane_offset_m(point_m, motion_px);
            let seen_px = camera.project(moved_m).unwrap() - camera.project(point_m).unwrap();
            assert!(seen_px.distance(motion_px) < 1e-8, "{lens:?}: {seen_px}");
        }
    }
}

#[test]
fn panning_and_zooming_only_shift_and_scale_the_picture() {
    for lens in Lens::ALL {
        let mut camera = steered(lens);
        let before: Vec<DVec2> = points_m().map(|point_m| camera.project(point_m).unwrap()).collect();
        camera.pan(31.0, -17.0);
        camera.advance(0.0);
        for (point_m, was_px) in points_m().zip(&before) {
            let motion_px = camera.project(point_m).unwrap() - was_px;
            assert!(motion_px.distance(DVec2::new(31.0, -17.0)) < 1e-8, "{lens:?}: {motion_px}");
        }
        camera.zoom(2.5);
        camera.advance(0.0);
        let seen: Vec<DVec2> = points_m().map(|point_m| camera.project(point_m).unwrap()).collect();
        assert_affine(&before, &seen, Some(2.5), 1e-8);
    }
}

#[test]
fn the_framed_sphere_has_the_same_size_with_each_lens() {
    for (insets_px, filled_px) in [([0.0; 4], [0.0, 600.0]), ([30.0, 0.0, 170.0, 0.0], [30.0, 430.0])] {
        for lens in Lens::ALL {
            let mut camera = camera(lens);
            camera.set_viewport_insets(insets_px);
            camera.advance(0.0);
            let [left, top, right, bottom] = silhouette_px(&camera);
            let height_px = filled_px[1] - filled_px[0];
            assert!((bottom - top - height_px).abs() < 4.0, "{lens:?}: {} px", bottom - top);
            // A sphere off the optical axis projects to an ellipse.
            assert!((right - left) / height_px < 1.05, "{lens:?}: {} px", right - left);
            let centre = DVec2::new(left + right, top + bottom) * 0.5;
            assert!(
                centre.distance(DVec2::new(400.0, 0.5 * (filled_px[0] + filled_px[1]))) < 3.0,
                "{lens:?}: {centre}"
            );
        }
    }
}

#[test]
fn with_parallel_rays_size_does_not_depend_on_depth() {
    let camera = steered(Lens::Parallel);
    let size_px = |depth_m: f64| {
        let from_m = CENTRE_M + camera.back() * depth_m;
        camera.project(from_m).unwrap().distance(camera.project(from_m + camera.right() * 0.02).unwrap())
    };
    for depth_m in [-3.0, -0.1, 0.1, 0.4] {
        assert!((size_px(depth_m) / size_px(0.0) - 1.0).abs() < 1e-12);
    }
    assert_eq!(camera.ray(DVec2::ZERO).direction, camera.ray(DVec2::new(799.0, 3.0)).direction);
    assert_eq!(camera.eye().w, 0.0);
}

#[test]
fn apparent_sizes_match_the_distance_of_the_lens() {
    for (lens, distance_m) in [(Lens::Portrait, 1.5), (Lens::Near, 0.5)] {
        for zoom in [1.0, 0.5, 8.0] {
            let mut camera = camera(lens);
            camera.zoom(zoom);
            camera.advance(0.0);
            let size_px = |depth_m: f64| {
                let from_m = CENTRE_M + camera.back() * depth_m;
                camera.project(from_m).unwrap().distance(camera.project(from_m + camera.right() * 0.02).unwrap())
            };
            let ratio = size_px(0.1) / size_px(-0.1);
            assert!((ratio - (distance_m + 0.1) / (distance_m - 0.1)).abs() < 1e-9, "{lens:?}, {zoom}: {ratio}");
            let eye = camera.eye();
            let eye_m = eye.truncate() / eye.w;
            assert!(eye_m.distance(CENTRE_M + DVec3::Z * distance_m) < 1e-9, "{lens:?}: {eye_m}");
        }
    }
}

#[test]
fn as_taken_matches_the_pinholes_picture_up_to_scale_and_shift() {
    let (focal_px, principal_px) = (2_900.0, DVec2::new(1_480.0, 2_030.0));
    let taken = |pinhole: Pinhole, point_m: DVec3| {
        let p = pinhole.camera_from_model.transform_point3(point_m);
        principal_px + DVec2::new(p.x, -p.y) * (focal_px / -p.z)
    };
    for (from, insets_px) in [(NamedView::Front, [0.0; 4]), (NamedView::Left, [12.0, 300.0, 80.0, 0.0])] {
        let mut camera = camera(Lens::Portrait);
        camera.set_glide(Glide::Smooth);
        camera.look(from);
        camera.zoom(3.0);
        camera.set_viewport_insets(insets_px);
        while camera.advance(0.016) {}
        camera.set_lens(Lens::AsTaken);
        while camera.advance(0.016) {}
        let picture: Vec<DVec2> = points_m().map(|point_m| taken(pinhole(), point_m)).collect();
        let seen: Vec<DVec2> = points_m().map(|point_m| camera.project(point_m).unwrap()).collect();
        assert_affine(&picture, &seen, None, 1e-6);
        camera.look(NamedView::Left);
        while camera.advance(0.016) {}
        assert!(camera.up().distance(DVec3::Y) < 1e-9);
        camera.look(NamedView::Reset);
        while camera.advance(0.016) {}
        for (point_m, seen_px) in points_m().zip(&seen) {
            assert!(camera.project(point_m).unwrap().distance(*seen_px) < 1e-6, "after another lens");
        }
    }
}

#[test]
fn orbiting_as_taken_rotates_the_model_about_its_centre() {
    let mut camera = camera(Lens::AsTaken);
    let axes = |camera: &Camera| DMat3::from_cols(camera.right(), camera.up(), camera.back());
    let (before, places_px) = (axes(&camera), points_m().map(|point_m| camera.project(point_m).unwrap()));
    let places_px: Vec<DVec2> = places_px.collect();
    camera.orbit(90.0, 40.0);
    camera.advance(0.0);
    let turn = axes(&camera) * before.transpose();
    for (point_m, position_px) in points_m().zip(places_px) {
        let seen_px = camera.project(CENTRE_M + turn * (point_m - CENTRE_M)).unwrap();
        assert!(seen_px.distance(position_px) < 1e-8, "{seen_px}");
    }
}

#[test]
fn in_front_of_a_picture_a_lens_applies_to_turned_views_and_keeps_their_direction() {
    let mut camera = camera(Lens::Portrait);
    let [right_m, down_m] = [DVec3::X, DVec3::NEG_Y].map(|axis| axis * 1e-3);
    let size_px = DVec2::new(640.0, 480.0);
    let origin_m = CENTRE_M - right_m * 320.0 - down_m * 240.0;
    camera.frame_picture(Some(PicturePlane { origin_m, right_m, down_m, size_px }));
    let mut seen_px = |lens: Lens, view: NamedView| {
        camera.look(view);
        camera.set_lens(lens);
        camera.advance(0.0);
        let places_px: Vec<DVec2> = points_m().map(|point_m| camera.project(point_m).unwrap()).collect();
        (places_px, camera.back())
    };
    let home = seen_px(Lens::Portrait, NamedView::Reset);
    let [portrait, near, parallel] =
        [Lens::Portrait, Lens::Near, Lens::Parallel].map(|lens| seen_px(lens, NamedView::Left));
    for (one, other) in [(&portrait, &near), (&portrait, &parallel), (&near, &parallel)] {
        assert_eq!(one.1, other.1, "the direction changed");
        let furthest_px = one.0.iter().zip(&other.0).map(|(one, other)| one.distance(*other)).fold(0.0, f64::max);
        assert!(furthest_px > 1.0, "{furthest_px} px");
    }
    assert_eq!(seen_px(Lens::Near, NamedView::Reset), home, "the photo's own lens");
}

#[test]
fn without_a_usable_pinhole_as_taken_equals_portrait() {
    let portrait = camera(Lens::Portrait);
    let turned = DAffine3::from_rotation_y(3.0) * pinhole().camera_from_model;
    let inside = DAffine3::from_translation(-CENTRE_M - DVec3::Z * 0.05);
    let nowhere = DAffine3::from_translation(DVec3::NAN);
    for useless in [None, Some(turned), Some(inside), Some(nowhere)] {
        let mut camera = camera(Lens::AsTaken);
        camera.set_pinhole(useless.map(|camera_from_model| Pinhole { camera_from_model }));
        camera.look(NamedView::Reset);
        camera.advance(0.0);
        assert_eq!(camera.clip_from_model(), portrait.clip_from_model());
        assert_eq!(camera.lens(), Lens::AsTaken, "the choice is kept for the next mesh");
    }
}

#[test]
fn changing_the_lens_glides_and_keeps_the_size() {
    for from in Lens::ALL {
        for to in Lens::ALL.into_iter().filter(|to| *to != from) {
            let mut camera = camera(from);
            camera.set_glide(Glide::Smooth);
            camera.set_lens(to);
            let mut before = camera.project(CENTRE_M).unwrap();
            while camera.advance(0.016) {
                let now = camera.project(CENTRE_M).unwrap();
                assert!(now.distance(before) < 20.0, "{from:?} to {to:?}: a jump from {before} to {now}");
                before = now;
                assert!(camera.clip_from_model().is_finite());
            }
            let [_, top, _, bottom] = silhouette_px(&camera);
            assert!((bottom - top - 600.0).abs() < 4.0, "{from:?} to {to:?}: {} px", bottom - top);
        }
    }
}

/// Asserts that `to` is `from` uniformly scaled and shifted; by `scale`, if given.
fn assert_affine(from: &[DVec2], to: &[DVec2], scale: Option<f64>, within_px: f64) {
    let mean = |positions: &[DVec2]| positions.iter().sum::<DVec2>() / positions.len() as f64;
    let (from_mean, to_mean) = (mean(from), mean(to));
    let pairs = || from.iter().zip(to).map(|(a, b)| (*a - from_mean, *b - to_mean));
    let fitted = pairs().map(|(a, b)| a.dot(b)).sum::<f64>() / pairs().map(|(a, _)| a.length_squared()).sum::<f64>();
    for (a, b) in pairs() {
        assert!((a * scale.unwrap_or(fitted)).distance(b) < within_px, "{} px off", (a * fitted).distance(b));
    }
}
