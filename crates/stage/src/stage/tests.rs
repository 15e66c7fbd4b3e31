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
fn a_mesh_that_is_small_in_its_picture_fills_half_the_view() {
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
    assert!((80.0..140.0).contains(&height_px), "{height_px} of 400 px");
    let corners = (large.at(DVec2::ZERO), large.at(large.size_px));
    let (low, high) = (at(corners.0.x, corners.0.y), at(corners.1.x, corners.1.y));
    assert!(low.x <= 0.1 && low.y <= 0.1 && high.x >= 599.9 && high.y >= 399.9, "{low} to {high}");
}

#[test]
fn turning_out_of_the_picture_keeps_the_direction() {
    let mut stage = with_picture();
    stage.show(Scene::Picture);
    run(&mut stage, 0..200);
    stage.turn_out_of_picture();
    stage.camera_mut().orbit(100.0, 0.0);
    let steps = run(&mut stage, 200..400);
    assert!(steps[0].draw && !steps[199].again);
    assert_eq!(stage.picture_share(), 0.0);
    let facing = stage.camera().back();
    assert!(facing.x < -0.5, "{facing}");
    stage.show(Scene::Picture);
    stage.set_picture(None);
    assert_eq!(stage.scene(), Scene::Solid, "without a picture");
}

#[test]
fn the_swing_returns_and_can_be_ended() {
    let arrive = |frames: std::ops::Range<u32>, stage: &mut Stage| {
        frames.map(|frame| (stage.advance(1000.0 + f64::from(frame) * 16.0).again, stage.camera().back().x)).last()
    };
    let mut undisturbed = with_picture();
    undisturbed.start_arrival();
    let (_, turned) = arrive(0..96, &mut undisturbed).unwrap();
    assert!(turned.abs() > 0.2, "{turned}");
    let (again, turned) = arrive(96..170, &mut undisturbed).unwrap();
    assert!(!again && turned.abs() < 1e-9, "{turned}");
    let mut ended = with_picture();
    ended.start_arrival();
    arrive(0..96, &mut ended);
    ended.end_swing();
    let (again, turned) = arrive(96..128, &mut ended).unwrap();
    assert!(turned.abs() < 1e-2 && again, "it glides back: {turned}");
}

#[test]
fn slow_frames_do_not_skip_the_swing() {
    let mut stage = with_picture();
    stage.start_arrival();
    let mut turned = 0.0_f64;
    let mut time_ms = 1000.0;
    while stage.advance(time_ms).again {
        turned = turned.max(stage.camera().back().x.abs());
        time_ms += 1000.0;
    }
    assert!(turned > 0.2, "{turned}");
    assert!(stage.camera().back().x.abs() < 1e-9 && time_ms < 30e3, "{} after {time_ms} ms", stage.camera().back());
}

#[test]
fn a_named_view_is_reached_from_within_the_swing() {
    let mut stage = with_picture();
    stage.start_arrival();
    for frame in 0..96 {
        stage.advance(1000.0 + f64::from(frame) * 16.0);
    }
    stage.camera_mut().look(NamedView::Left);
    stage.end_swing();
    while stage.advance(stage.last_ms.unwrap_or_default() + 16.0).again {}
    assert!(stage.camera().back().distance(DVec3::X) < 1e-9, "{}", stage.camera().back());
}

#[test]
fn the_framing_follows_growth_but_not_shrinking() {
    let mut stage = settled();
    let square = |side: f64| [DVec3::splat(-side), DVec3::splat(side)];
    stage.frame(&square(1.0));
    let initial_m = stage.camera().radius_m();
    stage.reframe(&square(1.3));
    assert!((stage.camera().radius_m() / initial_m - 1.3).abs() < 1e-12);
    for side in [1.0, 0.5] {
        stage.reframe(&square(side));
        assert!((stage.camera().radius_m() / initial_m - 1.0).abs() < 1e-12);
    }
    stage.reframe(&[DVec3::NAN]);
    assert!(stage.camera().radius_m().is_finite());
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
