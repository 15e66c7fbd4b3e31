//! Properties of camera motion for any lens.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use rosto_stage::{Camera, Glide, NamedView};

fn camera() -> Camera {
    let mut camera = Camera::default();
    camera.resize(800, 600);
    camera.frame(DVec3::new(0.0, 0.01, 0.02), 0.12);
    camera
}

#[test]
fn panning_follows_the_pointer() {
    let mut camera = camera();
    camera.set_glide(Glide::Off);
    camera.pan(30.0, -20.0);
    camera.advance(0.0);
    let centre = camera.project(DVec3::new(0.0, 0.01, 0.02)).unwrap();
    assert!(centre.distance(DVec2::new(430.0, 280.0)) < 1e-9, "{centre}");
}

#[test]
fn dragging_to_the_right_turns_the_face_to_the_right() {
    let mut camera = camera();
    let nose = DVec3::new(0.0, 0.01, 0.12);
    camera.orbit(50.0, 0.0);
    while camera.advance(0.016) {}
    assert!(camera.project(nose).unwrap().x > 400.0);
}

#[test]
fn the_glide_ends_and_is_independent_of_the_frame_rate() {
    let after = |frames: u32| {
        let mut camera = camera();
        camera.orbit(100.0, 30.0);
        (0..frames).for_each(|_| {
            camera.advance(0.1 / f64::from(frames));
        });
        camera.back()
    };
    assert!(after(2).distance(after(24)) < 1e-9);
    let mut camera = camera();
    camera.look(NamedView::Left);
    let frames = std::iter::repeat_with(|| camera.advance(0.016)).take_while(|&moving| moving).count();
    assert!(frames < 120, "{frames}");
}

#[test]
fn named_views_look_along_the_axes() {
    let mut camera = camera();
    camera.set_glide(Glide::Off);
    camera.turn(3.0 * TAU + 0.4);
    camera.look(NamedView::Left);
    camera.advance(0.0);
    assert!(camera.back().distance(DVec3::X) < 1e-12);
    camera.look(NamedView::Top);
    camera.advance(0.0);
    assert!(camera.back().distance(DVec3::Y) < 2e-3);
    camera.look(NamedView::Reset);
    camera.advance(0.0);
    assert!(camera.back().distance(DVec3::Z) < 1e-12);
}

#[test]
fn the_framed_sphere_fits_the_visible_area() {
    for insets_px in [[0.0; 4], [40.0, 0.0, 80.0, 0.0], [10.0, 300.0, 20.0, 0.0], [0.0, 0.0, 420.0, 500.0]] {
        let mut camera = camera();
        camera.set_viewport_insets(insets_px);
        while camera.advance(0.016) {}
        let [top, right, bottom, left] = insets_px;
        let (from, to) = (DVec2::new(left, top), DVec2::new(800.0 - right, 600.0 - bottom));
        let centre = camera.project(camera.centre_m()).unwrap();
        assert!(centre.distance(0.5 * (from + to)) < 1e-9, "{insets_px:?}: {centre}");
        for side in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z] {
            let seen = camera.project(camera.centre_m() + side * camera.radius_m()).unwrap();
            assert!(seen.cmpge(from - 1e-9).all() && seen.cmple(to + 1e-9).all(), "{insets_px:?}: {seen}");
            let ray = camera.ray(seen);
            let miss = (camera.centre_m() + side * camera.radius_m() - ray.origin).cross(ray.direction).length();
            assert!(miss < 1e-12, "{miss}");
        }
    }
}

#[test]
fn extreme_inputs_keep_the_projection_finite() {
    let mut camera = camera();
    camera.set_glide(Glide::Off);
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9, 1e9] {
        camera.zoom(factor);
        camera.orbit(1e6, 1e6);
        camera.pan(1e6, -1e6);
        camera.set_viewport_insets([factor, 1e9, -factor, f64::NAN]);
        camera.advance(1.0);
        assert!(camera.clip_from_model().is_finite());
    }
}

#[test]
fn the_projection_has_the_documented_axes() {
    let camera = camera();
    let centre = camera.project(DVec3::new(0.0, 0.01, 0.02)).unwrap();
    assert!(centre.distance(DVec2::new(400.0, 300.0)) < 1e-9, "{centre}");
    assert!(camera.project(DVec3::new(0.05, 0.01, 0.02)).unwrap().x > 400.0);
    assert!(camera.project(DVec3::new(0.0, 0.05, 0.02)).unwrap().y < 300.0);
    let eye_m = camera.eye().truncate() / camera.eye().w;
    assert_eq!(camera.project(eye_m + camera.back()), None);
}

#[test]
fn the_sphere_fits_pictures_of_any_aspect_ratio() {
    for (width, height) in [(1200, 500), (500, 1200), (700, 700)] {
        let mut camera = camera();
        camera.resize(width, height);
        let centre = DVec3::new(0.0, 0.01, 0.02);
        for side in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z] {
            let seen = camera.project(centre + side * 0.12).unwrap();
            assert!(seen.cmpge(DVec2::ZERO).all() && seen.cmple(camera.size_px()).all(), "{seen}");
        }
    }
}
