//! The live preview: edits on a camera stream.

use glam::{DMat3, DQuat, DVec2, DVec3, EulerRot};
use rosto_face::{LANDMARK_COUNT, canonical_positions_m};
use rosto_session::{Intent, Session, SessionError};
use rosto_stage::{Scene, Sides};
use rosto_studio::{FaceSlider, StreamWarp};

use crate::faces::{detected, found, open, session};

const FRAME_PX: [u32; 2] = [640, 480];

/// Pose of a head in front of the camera.
#[derive(Debug, Clone, Copy)]
struct Pose {
    /// Yaw, pitch and roll in degrees.
    turned_deg: [f64; 3],
    px_per_m: f64,
    middle_px: [f64; 2],
}

const POSES: [Pose; 4] = [
    Pose { turned_deg: [0.0; 3], px_per_m: 1200.0, middle_px: [320.0, 240.0] },
    Pose { turned_deg: [12.0, -8.0, 5.0], px_per_m: 1200.0, middle_px: [280.0, 260.0] },
    Pose { turned_deg: [-20.0, 10.0, -30.0], px_per_m: 700.0, middle_px: [400.0, 200.0] },
    Pose { turned_deg: [3.0, 2.0, 80.0], px_per_m: 1500.0, middle_px: [330.0, 250.0] },
];

/// Landmarks of a head in a frame, in MediaPipe's convention.
fn seen(head_m: &[DVec3], pose: Pose) -> Vec<[f32; 3]> {
    let [yaw, pitch, roll] = pose.turned_deg.map(f64::to_radians);
    let turn = DMat3::from_quat(DQuat::from_euler(EulerRot::YXZ, yaw, pitch, roll));
    let [width, height] = FRAME_PX.map(f64::from);
    let point = |&position_m: &DVec3| {
        let p = turn * position_m * pose.px_per_m;
        let at = DVec2::from(pose.middle_px) + DVec2::new(p.x, -p.y);
        [at.x / width, at.y / height, -p.z / width].map(|coordinate| coordinate as f32)
    };
    head_m.iter().map(point).collect()
}

/// The head of the open face.
fn head_m(session: &Session) -> Vec<DVec3> {
    session.face().unwrap().model().positions_m().to_vec()
}

fn edited() -> Session {
    let mut session = session();
    session.apply(Intent::Slide(FaceSlider::NoseWidth, 5.0)).unwrap();
    session.apply(Intent::Commit).unwrap();
    session
}

fn displacements_m(session: &Session) -> Vec<DVec3> {
    let live_preview = session.live_preview().unwrap();
    live_preview.edited_m().iter().zip(live_preview.seen_m()).map(|(edited, seen)| *edited - *seen).collect()
}

fn furthest(displacements: impl Iterator<Item = DVec3>) -> f64 {
    displacements.map(DVec3::length).fold(0.0, f64::max)
}

#[test]
fn frames_without_edits_do_not_move() {
    let mut session = session();
    for pose in POSES {
        session.preview_frame(Some(&seen(&head_m(&session), pose)), FRAME_PX).unwrap();
        assert_eq!(furthest(displacements_m(&session).into_iter()), 0.0);
        let (warp_mesh, _) = session.live_preview().unwrap().warp_mesh();
        let moved = warp_mesh.from_px.iter().zip(&warp_mesh.to_px).map(|(from, to)| from.distance(*to));
        assert!(moved.fold(0.0, f64::max) < 1e-9, "{pose:?}");
    }
}

#[test]
fn edits_are_independent_of_the_pose() {
    for density in [0, 1] {
        let mut session = edited();
        session.apply(Intent::Density(density)).unwrap();
        let face = session.face().unwrap().document();
        let wanted: Vec<DVec3> = face.positions().iter().zip(face.rest()).map(|(now, rest)| *now - *rest).collect();
        assert!(furthest(wanted.iter().copied()) > 2e-3, "the edit moves the face");
        for pose in POSES {
            session.preview_frame(Some(&seen(&head_m(&session), pose)), FRAME_PX).unwrap();
            let off = furthest(
                displacements_m(&session).iter().zip(&wanted).map(|(displacement, wanted)| *displacement - *wanted),
            );
            assert!(off < 1e-9, "{off} m at {pose:?}");
        }
    }
}

#[test]
fn edits_fade_only_around_an_opening_mouth() {
    let mut session = session();
    session.apply(Intent::Slide(FaceSlider::LipFullness, 3.0)).unwrap();
    session.apply(Intent::Slide(FaceSlider::NoseWidth, 5.0)).unwrap();
    session.apply(Intent::Commit).unwrap();
    // The lower lip and the face below it.
    let lip_m = canonical_positions_m()[13];
    let opened = |by_m: f64| -> Vec<DVec3> {
        let below =
            |(known, place): (DVec3, &DVec3)| *place - DVec3::Y * if known.y < lip_m.y - 1e-4 { by_m } else { 0.0 };
        canonical_positions_m().into_iter().zip(&head_m(&session)).map(below).collect()
    };
    let heads = [0.0, 0.008, 0.02, 0.06].map(opened);
    let [nose, lip] = [129, 17];
    let mut left = Vec::new();
    for head in heads {
        session.preview_frame(Some(&seen(&head, POSES[0])), FRAME_PX).unwrap();
        let displacements = displacements_m(&session);
        left.push([nose, lip].map(|vertex: usize| displacements[vertex].length()));
    }
    let [nose_m, lip_m] = [0, 1].map(|which| left.iter().map(|left| left[which]).collect::<Vec<f64>>());
    assert!(lip_m[0] > 1e-4 && lip_m.windows(2).all(|pair| pair[1] <= pair[0] + 1e-12), "{lip_m:?}");
    assert!(lip_m[1] == lip_m[0] && lip_m[3] < 0.5 * lip_m[0], "{lip_m:?}");
    assert!(nose_m[..3].iter().all(|nose| (nose - nose_m[0]).abs() < 1e-9), "{nose_m:?}");
}

#[test]
fn mesh_and_camera_stream_coincide_on_the_stage_with_their_sides_swapped() {
    let mut session = edited();
    session.apply(Intent::Scene(Scene::Picture)).unwrap();
    session.stage_mut().advance(0.0);
    for pose in POSES {
        session.preview_frame(Some(&seen(&head_m(&session), pose)), FRAME_PX).unwrap();
        session.stage_mut().advance(16.0);
        let (stage, live_preview) = (session.stage(), session.live_preview().unwrap());
        let [left, right] = [[0.0, 0.0], [640.0, 0.0]].map(|px| stage.canvas_px(px.into()).unwrap());
        assert!(left.x > right.x + 400.0 && (left.y - right.y).abs() < 1e-6, "{left} {right}");
        for vertex in [1, 33, 263, 61, 152] {
            let px = stage.camera().project(live_preview.edited_m()[vertex]).unwrap();
            let uv = live_preview.uvs()[vertex] * DVec2::from(FRAME_PX.map(f64::from));
            let seen = stage.camera().project(live_preview.seen_m()[vertex]).unwrap();
            assert!(stage.canvas_px(uv).unwrap().distance(seen) < 0.05, "landmark {vertex} at {pose:?}");
            let ray = stage.camera().ray(px);
            let aside = (live_preview.edited_m()[vertex] - ray.origin).cross(ray.direction).length();
            assert!(aside < 1e-6, "the ray misses it by {aside} m");
        }
    }
}

#[test]
fn frames_without_a_face_are_unchanged_and_edits_return_with_it() {
    let mut session = edited();
    session.preview_frame(None, FRAME_PX).unwrap();
    assert!(!session.live_preview().unwrap().is_seen());
    let landmarks = seen(&head_m(&session), POSES[0]);
    let moved = |session: &Session| {
        let (warp_mesh, _) = session.live_preview().unwrap().warp_mesh();
        warp_mesh.from_px.iter().zip(&warp_mesh.to_px).map(|(from, to)| from.distance(*to)).fold(0.0, f64::max)
    };
    session.preview_frame(Some(&landmarks), FRAME_PX).unwrap();
    assert!(moved(&session) > 2.0, "{}", moved(&session));
    session.preview_frame(None, FRAME_PX).unwrap();
    assert_eq!(moved(&session), 0.0);
    session.preview_frame(Some(&landmarks), FRAME_PX).unwrap();
    assert!(moved(&session) > 2.0);
}

#[test]
fn ending_the_live_preview_restores_the_photo() {
    let mut session = edited();
    session.apply(Intent::Scene(Scene::Picture)).unwrap();
    session.stage_mut().advance(0.0);
    let corners =
        |session: &Session| [[0.0, 0.0], [64.0, 30.0]].map(|px| session.stage().canvas_px(px.into()).unwrap());
    let before = corners(&session);
    session.preview_frame(Some(&seen(&head_m(&session), POSES[2])), FRAME_PX).unwrap();
    session.stage_mut().advance(16.0);
    session.end_live_preview();
    session.stage_mut().advance(32.0);
    assert_eq!(session.stage().camera().sides(), Sides::True);
    for (now, before) in corners(&session).into_iter().zip(before) {
        assert!(now.distance(before) < 1e-6, "{now} {before}");
    }
    assert!(session.live_preview().is_none());
}

#[test]
fn invalid_frames_are_refused_and_the_live_preview_continues() {
    let mut empty = Session::new(1);
    assert_eq!(empty.preview_frame(None, FRAME_PX), Err(SessionError::NoFace));
    let mut session = edited();
    let landmarks = seen(&head_m(&session), POSES[0]);
    session.preview_frame(Some(&landmarks), FRAME_PX).unwrap();
    let before = displacements_m(&session);
    assert!(matches!(session.preview_frame(Some(&landmarks[..7]), FRAME_PX), Err(SessionError::Face(_))));
    assert_eq!(displacements_m(&session), before);
    // Open another face during the live preview.
    open(&mut session, found(detected()));
    session.preview_frame(Some(&landmarks), FRAME_PX).unwrap();
    assert_eq!(furthest(displacements_m(&session).into_iter()), 0.0);
}

#[test]
fn a_moving_face_needs_one_layout_and_stays_within_the_frame() {
    let session = edited();
    let triangles = session.face().unwrap().model().topology().triangles().to_vec();
    let mut stream_warp = StreamWarp::default();
    for step in 0..30 {
        let pose = Pose {
            px_per_m: 1200.0 + 20.0 * f64::from(step),
            turned_deg: [0.2 * f64::from(step), 0.0, f64::from(step)],
            middle_px: [320.0 + 5.0 * f64::from(step), 240.0],
        };
        let places: Vec<DVec3> = seen(&head_m(&session), pose)
            .iter()
            .map(|p| {
                DVec3::new(f64::from(p[0]) * 640.0, f64::from(p[1]) * 480.0, -f64::from(p[2]) * 640.0 / pose.px_per_m)
            })
            .collect();
        let targets: Vec<DVec2> = places.iter().map(|place| place.truncate() + DVec2::new(2.0, 1.0)).collect();
        stream_warp.follow(|| triangles.clone(), &places, &targets, FRAME_PX, 0.35).unwrap();
        let (warp_mesh, version) = stream_warp.warp_mesh();
        assert_eq!(version, 1, "step {step}");
        for (from, to) in warp_mesh.from_px.iter().zip(&warp_mesh.to_px) {
            assert!(from.cmpge(DVec2::ZERO).all() && to.cmpge(DVec2::ZERO).all() && from.x <= 640.0 && to.x <= 640.0);
            let on_edge = from.x == 0.0 || from.x == 640.0 || from.y == 0.0 || from.y == 480.0;
            assert!(!on_edge || from == to, "the edge does not move");
        }
        let near = |place: DVec2| warp_mesh.from_px.iter().position(|from| from.distance(place) < 1e-6);
        let led = (0..LANDMARK_COUNT).filter_map(|vertex| near(places[vertex].truncate()));
        let led: Vec<usize> = led
            .filter(|&at| warp_mesh.from_px[at].x < 540.0 && warp_mesh.from_px[at].cmpgt(DVec2::splat(100.0)).all())
            .collect();
        let off = led.iter().map(|&at| (warp_mesh.to_px[at] - warp_mesh.from_px[at]).distance(DVec2::new(2.0, 1.0)));
        assert!(
            off.fold(0.0, f64::max) < 1e-6 && led.len() > 100,
            "{} landmarks drive the warp in step {step}",
            led.len()
        );
    }
}
