use super::picture::BACKDROP_OPACITY;
use super::*;
use crate::{Glide, MarkKind, NamedView, PicturePlane, Pinhole, Scene};

fn settled() -> Stage {
    let mut stage = Stage::default();
    assert!(stage.advance(0.0).draw);
    stage
}

#[test]
fn frames_are_drawn_only_after_changes() {
    let mut stage = settled();
    assert_eq!(stage.advance(16.0), Step { draw: false, again: false });
    stage.set_hovered(None);
    stage.set_offsets_m([DVec3::ZERO; 2]);
    assert!(!stage.advance(32.0).draw);
    stage.set_hovered(Some(4));
    assert_eq!(stage.advance(48.0), Step { draw: true, again: false });
    stage.set_marks(vec![Mark { vertex: 4, kind: MarkKind::Ring }]);
    assert!(stage.advance(64.0).draw);
    assert!(!stage.advance(80.0).draw);
}

#[test]
fn a_glide_requests_frames_until_it_ends() {
    let mut stage = settled();
    stage.camera_mut().look(NamedView::Left);
    let frames = (1..500).take_while(|&frame| stage.advance(f64::from(frame) * 16.0).again).count();
    assert!((10..200).contains(&frames), "{frames}");
    assert!(stage.camera().back().distance(DVec3::X) < 1e-9);
}

#[test]
fn without_glide_the_camera_arrives_in_one_frame() {
    let mut stage = settled();
    stage.camera_mut().set_glide(Glide::Off);
    stage.camera_mut().look(NamedView::Left);
    assert!(stage.advance(5.0).draw);
    assert!(stage.camera().back().distance(DVec3::X) < 1e-9);
    assert!(!stage.advance(21.0).again);
}

/// A stage with a picture 200 px wide of a cube from −1 to 1, taken from a distance of 10 m.
fn with_picture() -> Stage {
    let mut stage = settled();
    stage.camera_mut().resize(600, 400);
    let camera_from_model = glam::DAffine3::from_translation(DVec3::new(0.0, 0.0, -10.0));
    stage.camera_mut().set_pinhole(Some(Pinhole { camera_from_model }));
    stage.frame(&[DVec3::NEG_ONE, DVec3::ONE]);
    stage.set_picture(Some(PicturePlane {
        origin_m: DVec3::new(-2.0, 2.0, 0.0),
        right_m: DVec3::new(0.02, 0.0, 0.0),
        down_m: DVec3::new(0.0, -0.02, 0.0),
        size_px: DVec2::new(200.0, 200.0),
    }));
    stage
}

fn run(stage: &mut Stage, frames: std::ops::Range<u32>) -> Vec<Step> {
    frames.map(|frame| stage.advance(1000.0 + f64::from(frame) * 16.0)).collect()
}

#[test]
fn the_arrival_fades_from_picture_to_mesh() {
    let mut stage = with_picture();
    stage.start_arrival();
    run(&mut stage, 0..15);
    assert_eq!(stage.picture_share(), 1.0, "the picture is shown first");
    run(&mut stage, 15..32);
    assert!((0.2..0.8).contains(&stage.picture_share()), "{}", stage.picture_share());
    run(&mut stage, 32..50);
    assert_eq!(stage.picture_share(), 0.0);
}

#[test]
fn the_picture_fills_the_stage() {
    let mut stage = with_picture();
    stage.show(Scene::Picture);
    run(&mut stage, 0..200);
    assert_eq!((stage.scene(), stage.picture_share()), (Scene::Picture, 1.0));
    let corner = |x: f64, y: f64| stage.camera().project(DVec3::new(x, y, 0.0)).unwrap();
    assert!(corner(-2.0, 2.0).distance(DVec2::new(100.0, 0.0)) < 1e-2, "{}", corner(-2.0, 2.0));
    assert!(corner(2.0, -2.0).distance(DVec2::new(500.0, 400.0)) < 1e-2, "{}", corner(2.0, -2.0));
}

#[test]
fn the_picture_fits_the_visible_area() {
    let mut stage = with_picture();
    stage.show(Scene::Picture);
    stage.camera_mut().resize(300, 500);
    stage.set_viewport_insets([0.0, 0.0, 100.0, 0.0]);
    run(&mut stage, 0..200);
    let corner = stage.camera().project(DVec3::new(-2.0, 2.0, 0.0)).unwrap();
    assert!(corner.distance(DVec2::new(0.0, 50.0)) < 1e-2, "{corner}");
}

#[test]
fn a_mesh_that_is_small_in_its_picture_fills_much_of_the_view() {
    let mut stage = with_picture();
    let large = PicturePlane {
        origin_m: DVec3::new(-3.0, 19.0, 0.0),
        right_m: DVec3::new(0.1, 0.0, 0.0),
        down_m: DVec3::new(0.0, -0.1, 0.0),
        size_px: DVec2::splat(200.0),
    };
    stage.set_picture(Some(large));
    stage.show(Scene::Picture);
    run(&mut stage, 0..300);
    let at = |x: f64, y: f64| stage.camera().project(DVec3::new(x, y, 0.0)).unwrap();
    let height_px = at(0.0, -1.0).y - at(0.0, 1.0).y;
    assert!((100.0..160.0).contains(&height_px), "{height_px} of 400 px");
    let corners = (large.at(DVec2::ZERO), large.at(large.size_px));
    let (low, high) = (at(corners.0.x, corners.0.y), at(corners.1.x, corners.1.y));
    assert!(low.x <= 0.1 && low.y <= 0.1 && high.x >= 599.9 && high.y >= 399.9, "{low} to {high}");
}

#[test]
fn the_picture_is_seen_behind_the_mesh_until_it_turns() {
    let mut stage = with_picture();
    stage.set_backdrop(Visibility::Shown);
    run(&mut stage, 0..200);
    let (place, home) = (stage.camera().project(DVec3::ZERO).unwrap(), stage.picture_opacity());
    assert_eq!((stage.scene(), stage.picture_share(), home), (Scene::Solid, 0.0, BACKDROP_OPACITY));
    let opacity_after = |stage: &mut Stage, by_px: f64, frames| {
        stage.camera_mut().orbit(by_px, 0.0);
        run(stage, frames);
        stage.picture_opacity()
    };
    let turned = opacity_after(&mut stage, 30.0, 200..400);
    assert!(turned > 0.0 && turned < home, "{turned}");
    assert_eq!(opacity_after(&mut stage, 100.0, 400..600), 0.0);
    let moved_px = stage.camera().project(DVec3::ZERO).unwrap().distance(place);
    assert!(moved_px < 1e-6, "the mesh turns in its place: {moved_px} px");
    stage.show(Scene::Picture);
    run(&mut stage, 600..800);
    assert_eq!(stage.picture_opacity(), 1.0);
    assert!(stage.camera().back().distance(DVec3::Z) < 1e-4, "the picture has one direction");
    stage.set_picture(None);
    run(&mut stage, 800..900);
    assert_eq!((stage.scene(), stage.picture_opacity()), (Scene::Solid, 0.0), "without a picture");
}

#[test]
fn mesh_and_picture_share_their_framing() {
    let mut stage = with_picture();
    stage.set_backdrop(Visibility::Shown);
    run(&mut stage, 0..200);
    let in_front = stage.camera().clip_from_model();
    stage.show(Scene::Picture);
    run(&mut stage, 200..400);
    assert_eq!(stage.camera().clip_from_model(), in_front);
}

#[test]
fn the_picture_zooms_about_the_pointer() {
    let mut stage = with_picture();
    stage.show(Scene::Picture);
    run(&mut stage, 0..200);
    let (point_m, factor) = (DVec3::new(0.5, 0.25, 0.0), 1.7);
    let at_px = stage.camera().project(point_m).unwrap();
    stage.camera_mut().zoom_at(factor, at_px);
    run(&mut stage, 200..400);
    let now_px = stage.camera().project(point_m).unwrap();
    assert!(now_px.distance(at_px) < 1e-2, "{now_px} instead of {at_px}");
}

#[test]
fn tools_fade_one_second_after_their_last_use() {
    for (glide, fade_ms) in [(Glide::Smooth, 200.0), (Glide::Off, 0.0)] {
        let mut stage = settled();
        stage.camera_mut().set_glide(glide);
        assert_eq!(stage.tools_opacity(), 0.0);
        stage.use_tools(true);
        stage.advance(0.0);
        assert_eq!((stage.advance(5000.0).again, stage.tools_opacity()), (false, 1.0), "held");
        stage.use_tools(false);
        stage.advance(6000.0);
        let Step { draw, again } = stage.advance(6990.0);
        assert_eq!((draw, again, stage.tools_opacity()), (false, true, 1.0), "waits without drawing");
        while stage.advance(stage.last_ms.unwrap_or(7000.0) + 16.0).again {}
        let after_ms = 6990.0 + 16.0 + fade_ms + 32.0;
        assert_eq!((stage.advance(after_ms).again, stage.tools_opacity()), (false, 0.0), "{after_ms} ms");
    }
}

#[test]
fn without_tools_removes_marks_and_overlays() {
    let mut stage = settled();
    stage.set_marks(vec![Mark { vertex: 4, kind: MarkKind::Ring }]);
    stage.set_gizmo(Some(4));
    stage.set_hovered(Some(5));
    let settings = stage.render_settings_mut();
    (settings.mirror_plane, settings.rim, settings.glow, settings.wipe) =
        (Visibility::Shown, Visibility::Shown, 0.5, Some(0.5));
    let bare = stage.without_tools();
    assert_eq!((bare.mark_words(), bare.gizmo()), (Vec::new(), None));
    let RenderSettings { mirror_plane, rim, glow, wipe, .. } = *bare.render_settings();
    assert_eq!((mirror_plane, rim, glow, wipe), (Visibility::Hidden, Visibility::Hidden, 0.0, None));
}

#[test]
fn the_gizmo_is_picked_at_its_vertex() {
    let mut stage = settled();
    let positions_m = [DVec3::splat(-1.0), DVec3::ZERO];
    stage.frame(&[DVec3::NEG_ONE, DVec3::ONE]);
    stage.camera_mut().resize(600, 600);
    let right_of_middle = DVec2::new(340.0, 302.0);
    let pick = |stage: &Stage| stage.pick_axis(right_of_middle, &positions_m, Pointer::Fine);
    assert_eq!(pick(&stage), None, "no gizmo");
    stage.set_gizmo(Some(1));
    assert_eq!(pick(&stage), None, "faded");
    stage.use_tools(true);
    assert_eq!(pick(&stage), Some(Axis::X));
    stage.set_gizmo(Some(2));
    assert_eq!(pick(&stage), None, "vertex out of range");
}

#[test]
fn the_turntable_keeps_its_speed() {
    let mut stage = settled();
    stage.set_turntable(90.0);
    for frame in 0..=100 {
        assert!(stage.advance(f64::from(frame) * 10.0).again);
    }
    assert!(stage.camera().back().distance(DVec3::NEG_X) < 1e-9, "{}", stage.camera().back());
    stage.set_turntable(0.0);
    stage.advance(1010.0);
    assert!(!stage.advance(90_000.0).again);
}
