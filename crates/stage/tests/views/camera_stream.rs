//! Properties of a mirrored camera and of camera streams.

use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3, EulerRot};
use rosto_stage::{Camera, Glide, PicturePlane, Pinhole, Sides};

fn camera() -> Camera {
    let mut camera = Camera::default();
    camera.set_glide(Glide::Off);
    camera.resize(1000, 600);
    // The left fifth is covered.
    camera.set_viewport_insets([0.0, 0.0, 0.0, 200.0]);
    camera.frame(DVec3::new(0.0, 0.01, 0.02), 0.12);
    camera
}

fn swapped() -> Camera {
    let mut camera = camera();
    camera.set_sides(Sides::Swapped);
    camera
}

#[test]
fn mirroring_only_swaps_the_sides_of_the_screen() {
    let (plain, mirrored) = (camera(), swapped());
    for point_m in [DVec3::new(0.05, 0.03, 0.01), DVec3::new(-0.02, -0.04, 0.08)] {
        let (seen, swapped) = (plain.project(point_m).unwrap(), mirrored.project(point_m).unwrap());
        assert!(swapped.distance(DVec2::new(1200.0 - seen.x, seen.y)) < 1e-9, "{seen} {swapped}");
        let ray = mirrored.ray(swapped);
        assert!((point_m - ray.origin).cross(ray.direction).length() < 1e-9, "the ray meets the point");
    }
}

#[test]
fn when_mirrored_motion_still_follows_the_pointer() {
    let point_m = DVec3::new(0.02, 0.01, 0.05);
    let motion_px = DVec2::new(30.0, -20.0);
    let mut camera = swapped();
    let from = camera.project(point_m).unwrap();
    let moved = camera.project(point_m + camera.view_plane_offset_m(point_m, motion_px)).unwrap();
    assert!(moved.distance(from + motion_px) < 1e-6, "{moved}");
    let middle_m = camera.centre_m();
    let from = camera.project(middle_m).unwrap();
    camera.pan(motion_px.x, motion_px.y);
    camera.advance(0.0);
    assert!(camera.project(middle_m).unwrap().distance(from + motion_px) < 1e-6);
    let nose_m = middle_m + DVec3::Z * 0.1;
    let from = camera.project(nose_m).unwrap();
    camera.orbit(50.0, 0.0);
    camera.advance(0.0);
    assert!(camera.project(nose_m).unwrap().x > from.x + 10.0, "it turns with the pointer");
}

/// A picture of a rotated head from infinitely far away, and its pinhole.
fn picture(turned: [f64; 3], px_per_m: f64, centre_px: DVec2) -> (PicturePlane, Pinhole) {
    let [yaw, pitch, roll] = turned;
    let turn = DMat3::from_quat(DQuat::from_euler(EulerRot::YXZ, yaw, pitch, roll));
    let (right_m, down_m) = (turn.transpose().x_axis / px_per_m, -turn.transpose().y_axis / px_per_m);
    let origin_m = camera().centre_m() - right_m * centre_px.x - down_m * centre_px.y;
    let plane = PicturePlane { origin_m, right_m, down_m, size_px: DVec2::new(640.0, 480.0) };
    let camera_from_model = DAffine3::from_mat3_translation(turn, DVec3::NEG_Z * 1e6);
    (plane, Pinhole { camera_from_model })
}

#[test]
fn a_camera_stream_stays_fixed_on_the_screen_while_the_head_moves() {
    let (first, pinhole) = picture([0.0; 3], 1500.0, DVec2::new(320.0, 240.0));
    for zoom in [1.0, 1.7] {
        let mut camera = swapped();
        camera.set_pinhole(Some(pinhole));
        camera.frame_picture(Some(first));
        camera.zoom(zoom);
        camera.pan(12.0 * (zoom - 1.0), 5.0 * (zoom - 1.0));
        camera.advance(0.0);
        let corners = [DVec2::ZERO, DVec2::new(640.0, 0.0), DVec2::new(100.0, 480.0)];
        let expected = corners.map(|corner| camera.project(first.at(corner)).unwrap());
        for step in 1..20 {
            let share = f64::from(step) / 20.0;
            let turned = [0.4 * share, -0.2 * share, 0.6 * share];
            let (next, pinhole) = picture(turned, 1500.0 - 600.0 * share, DVec2::new(320.0 + 150.0 * share, 240.0));
            camera.change_picture(next, pinhole);
            for (corner, expected) in corners.iter().zip(expected) {
                let seen = camera.project(next.at(*corner)).unwrap();
                assert!(
                    seen.distance(expected) < 0.05,
                    "{corner} at {seen}; expected {expected}, step {step}, zoom {zoom}"
                );
            }
            assert!(!camera.advance(0.016), "nothing glides");
        }
    }
}

#[test]
fn a_camera_stream_does_not_move_a_view_of_the_mesh() {
    let mut camera = swapped();
    let point_m = DVec3::new(0.02, 0.03, 0.04);
    let before = camera.project(point_m).unwrap();
    let (next, pinhole) = picture([0.3, 0.1, 0.2], 900.0, DVec2::new(100.0, 240.0));
    camera.change_picture(next, pinhole);
    assert_eq!(camera.project(point_m).unwrap(), before);
}

#[test]
fn a_mirrored_camera_stream_is_shown_completely() {
    let (photo, pinhole) = picture([0.0; 3], 600.0, DVec2::new(200.0, 240.0));
    let mut camera = camera();
    camera.set_pinhole(Some(pinhole));
    camera.frame_picture(Some(photo));
    camera.advance(0.0);
    camera.set_sides(Sides::Swapped);
    let (camera_stream, pinhole) = picture([0.1, 0.0, 0.2], 700.0, DVec2::new(400.0, 240.0));
    camera.change_picture(camera_stream, pinhole);
    for (corner, expected) in [(DVec2::ZERO, [1000.0, 0.0]), (DVec2::new(640.0, 480.0), [200.0, 600.0])] {
        let seen = camera.project(camera_stream.at(corner)).unwrap();
        assert!(seen.distance(expected.into()) < 0.05, "{corner} at {seen}");
    }
}
