use glam::{DVec2, DVec3};
use rosto::{SavedEdits, SavedFace};
use rosto_face::{Observation, PhotoLens, crowded_landmarks};
use rosto_mesh::vertex_normals;
use rosto_session::{BRUSH_PX, Changed, Intent, Pace, Selection, Session};
use rosto_stage::{Background, NamedView, Pointer, Scene, Srgb, Visibility};
use rosto_studio::FaceSlider;

use super::{act, face, move_by, position_px, positions, select, state};
use crate::faces::{detected, found, open, saved, session};
use crate::invariants::{check, seen, shape};

const NOSE_TIP: u32 = 4;
const MOUTH_CORNER: u32 = 61;
/// Landmarks visible in the photo: nose, brows, mouth, chin.
const VISIBLE: [u32; 6] = [4, 105, 334, 61, 291, 199];

/// The photo on the stage, taken from a distance of 0.5 m.
pub(super) fn photo() -> Session {
    let mut session = session();
    let lens = PhotoLens::Distance(0.5);
    open(&mut session, found(Observation { lens, photo_size_px: [640, 640], ..detected() }));
    act(&mut session, Intent::Scene(Scene::Picture));
    session.stage_mut().advance(0.0);
    session
}

/// Detected position of a landmark, in px of the photo.
fn found_px(session: &Session, landmark: u32) -> DVec2 {
    let [x, y, _] = face(session).model().landmarks()[landmark as usize];
    DVec2::new(f64::from(x), f64::from(y)) * DVec2::from(face(session).model().photo_size_px().map(f64::from))
}

#[test]
fn the_mesh_lies_on_the_detected_landmarks() {
    let session = photo();
    let model = face(&session).model();
    let normals = vertex_normals(model.topology(), model.positions_m());
    let eye_m = model.camera().camera_from_model.inverse().translation;
    // The others leave their rays.
    let faces_camera = |landmark: u32| {
        let position_m = model.positions_m()[landmark as usize];
        normals[landmark as usize].dot((eye_m - position_m).normalize()) > 0.6
    };
    let checked = (0..468).filter(|&landmark| faces_camera(landmark) && !crowded_landmarks().contains(&landmark));
    for landmark in checked {
        let seen_px = session.stage().picture_px(position_px(&session, landmark)).unwrap();
        assert!(seen_px.distance(found_px(&session, landmark)) < 1e-6, "{landmark}: {seen_px}");
    }
}

#[test]
fn dragging_on_the_photo_moves_the_photo_with_the_pointer() {
    let by_px = DVec2::new(6.0, -9.0);
    for landmark in VISIBLE {
        let mut session = photo();
        let from = position_px(&session, landmark);
        act(&mut session, Intent::Hover(Some(from)));
        assert_eq!(session.hovered().vertex, Some(landmark));
        act(&mut session, Intent::Press(from, Pointer::Fine));
        act(&mut session, Intent::Drag(from + by_px, Pace::Usual));
        act(&mut session, Intent::Release);
        assert_eq!(face(&session).selection(), Some(Selection::Landmark(landmark)));
        assert_eq!(session.view().scene, Scene::Picture);
        session.update_photo_warp();
        let (warp_mesh, _) = face(&session).photo().warp_mesh().unwrap();
        let found_px = found_px(&session, landmark);
        let at = warp_mesh.from_px.iter().position(|from| from.distance(found_px) < 1e-6).unwrap();
        let shown = session.stage().canvas_px(warp_mesh.to_px[at]).unwrap();
        let wanted = position_px(&session, landmark);
        assert!(shown.distance(wanted) < 1.0, "{landmark}: the photo shows it at {shown}, the mesh is at {wanted}");
        assert_eq!(state(&session).entry_count, 1);
    }
}

#[test]
fn the_photo_moves_with_edits_and_undo_restores_it() {
    let mut session = photo();
    let moved = |session: &mut Session| {
        session.update_photo_warp();
        let (warp_mesh, _) = face(session).photo().warp_mesh().unwrap();
        warp_mesh.from_px.iter().zip(&warp_mesh.to_px).map(|(from, to)| from.distance(*to)).fold(0.0, f64::max)
    };
    assert_eq!(moved(&mut session), 0.0);
    act(&mut session, Intent::Slide(FaceSlider::JawWidth, -6.0));
    assert!(moved(&mut session) > 0.2, "during the edit");
    act(&mut session, Intent::Commit);
    assert!(moved(&mut session) > 0.2);
    act(&mut session, Intent::Undo);
    assert_eq!(moved(&mut session), 0.0);
    act(&mut session, Intent::SeenFrom(Some(2.0)));
    assert!(moved(&mut session) > 0.2);
    let taken_from_m = face(&session).model().camera().distance_m;
    act(&mut session, Intent::SeenFrom(Some(taken_from_m)));
    assert!(moved(&mut session) < 1e-6, "the original distance gives the original photo");
    act(&mut session, Intent::SeenFrom(None));
    assert_eq!(moved(&mut session), 0.0);
}

#[test]
fn the_stage_uses_the_photos_view_distance() {
    let mut session = photo();
    act(&mut session, Intent::SeenFrom(Some(2.0)));
    session.stage_mut().advance(0.0);
    session.update_photo_warp();
    let (warp_mesh, _) = face(&session).photo().warp_mesh().unwrap();
    for landmark in VISIBLE {
        let found_px = found_px(&session, landmark);
        let at = warp_mesh.from_px.iter().position(|from| from.distance(found_px) < 1e-6).unwrap();
        let off = session.stage().canvas_px(warp_mesh.to_px[at]).unwrap().distance(position_px(&session, landmark));
        assert!(off < 1.0, "{landmark} is {off} px off");
    }
}

#[test]
fn only_named_views_and_turning_tools_leave_the_photo() {
    let leaving =
        [Intent::GoTo(NamedView::Left), Intent::Turntable(rosto_session::Turntable::Turns), Intent::ShowDepth];
    for intent in leaving {
        let mut session = photo();
        assert_eq!(act(&mut session, intent.clone()), Changed::Document);
        assert_eq!(session.view().scene, Scene::Solid, "{intent:?}");
        assert_eq!(session.stage().scene(), Scene::Solid);
    }
    let staying = [
        Intent::GoTo(NamedView::Reset),
        Intent::Zoom(1.5),
        Intent::ZoomAt(1.5, DVec2::splat(40.0)),
        Intent::Pan(DVec2::splat(9.0)),
        Intent::Orbit(DVec2::new(20.0, 0.0)),
    ];
    for intent in staying {
        let mut session = photo();
        act(&mut session, intent.clone());
        assert_eq!(session.view().scene, Scene::Picture, "{intent:?}");
    }
}

#[test]
fn a_drag_next_to_the_face_moves_the_photo() {
    let by_px = DVec2::new(12.0, -7.0);
    let moved = |intent: Intent| {
        let mut session = photo();
        act(&mut session, Intent::ZoomAt(2.0, DVec2::new(100.0, 80.0)));
        session.stage_mut().advance(0.0);
        let before = position_px(&session, NOSE_TIP);
        act(&mut session, intent);
        session.stage_mut().advance(0.0);
        position_px(&session, NOSE_TIP) - before
    };
    assert!(moved(Intent::Orbit(by_px)).distance(by_px) < 0.5);
    assert_eq!(moved(Intent::Orbit(by_px)), moved(Intent::Pan(by_px)));
}

#[test]
fn the_photo_is_behind_the_face_unless_the_background_has_a_colour() {
    let mut session = session();
    session.stage_mut().advance(0.0);
    let in_front = session.stage().picture_opacity();
    assert!(in_front > 0.2 && in_front < 0.8, "{in_front}");
    act(&mut session, Intent::Scene(Scene::Picture));
    session.stage_mut().advance(0.0);
    let in_photo = position_px(&session, NOSE_TIP);
    act(&mut session, Intent::Scene(Scene::Solid));
    session.stage_mut().advance(0.0);
    assert!(position_px(&session, NOSE_TIP).distance(in_photo) < 1e-6, "both scenes share their framing");
    for (hide, show) in [
        (Intent::Background(Background::Plain(Srgb([1, 2, 3]))), Intent::Background(Background::Ground)),
        (Intent::Backdrop(Visibility::Hidden), Intent::Backdrop(Visibility::Shown)),
        (Intent::GoTo(NamedView::Left), Intent::GoTo(NamedView::Reset)),
    ] {
        act(&mut session, hide.clone());
        session.stage_mut().advance(0.0);
        assert_eq!(session.stage().picture_opacity(), 0.0, "{hide:?}");
        act(&mut session, show);
        session.stage_mut().advance(0.0);
        assert_eq!(session.stage().picture_opacity(), in_front);
    }
}

#[test]
fn the_scene_changes_only_the_view_and_persists() {
    let mut session = photo();
    select(&mut session, Selection::Landmark(MOUTH_CORNER));
    move_by(&mut session, DVec3::new(2.0, 1.0, 0.0));
    let before = shape(&session);
    for scene in [Scene::Solid, Scene::Picture] {
        act(&mut session, Intent::Scene(scene));
        assert_eq!(shape(&session), before);
        check(&session).unwrap();
    }
    open(&mut session, found(detected()));
    assert_eq!(session.stage().scene(), Scene::Picture, "the scene persists");
    let preferences = session.preferences();
    let mut next = crate::faces::session();
    act(&mut next, Intent::RestorePreferences(preferences));
    assert_eq!((next.view().scene, next.stage().scene()), (Scene::Picture, Scene::Picture));
}

/// Paints at a position.
fn paint(session: &mut Session, position_px: DVec2) {
    act(session, Intent::Press(position_px, Pointer::Fine));
    assert!(session.has_grabbed());
    act(session, Intent::Drag(position_px + DVec2::new(40.0, 0.0), Pace::Usual));
    act(session, Intent::Release);
}

#[test]
fn strokes_protect_the_photo_and_have_separate_undo() {
    let mut session = photo();
    let corner = position_px(&session, MOUTH_CORNER);
    select(&mut session, Selection::Landmark(MOUTH_CORNER));
    move_by(&mut session, DVec3::new(4.0, 0.0, 0.0));
    let edited = shape(&session);
    act(&mut session, Intent::Brush(Some(20.0)));
    paint(&mut session, corner);
    assert_eq!(shape(&session), edited, "the mesh does not change");
    assert_eq!(face(&session).photo().strokes().count(), 1);
    session.update_photo_warp();
    let found = found_px(&session, MOUTH_CORNER);
    let moved = |session: &Session| {
        let (warp_mesh, _) = face(session).photo().warp_mesh().unwrap();
        let at = warp_mesh.from_px.iter().position(|from| from.distance(found) < 1e-6).unwrap();
        warp_mesh.to_px[at].distance(warp_mesh.from_px[at])
    };
    assert_eq!(moved(&session), 0.0);
    act(&mut session, Intent::Undo);
    assert_eq!((face(&session).photo().strokes().count(), face(&session).photo().strokes().can_redo()), (0, true));
    assert_eq!(shape(&session), edited, "with the brush, undo removes a stroke");
    session.update_photo_warp();
    assert!(moved(&session) > 0.3);
    act(&mut session, Intent::Redo);
    act(&mut session, Intent::Brush(None));
    act(&mut session, Intent::Undo);
    assert_ne!(shape(&session), edited);
    assert_eq!(face(&session).photo().strokes().count(), 1);
    act(&mut session, Intent::ClearStrokes);
    assert_eq!(face(&session).photo().strokes().count(), 0);
}

#[test]
fn the_brush_shows_the_photo_and_ends_with_it() {
    let mut session = session();
    act(&mut session, Intent::Brush(Some(BRUSH_PX.max)));
    assert_eq!(session.view().scene, Scene::Picture);
    session.stage_mut().advance(0.0);
    let place = position_px(&session, NOSE_TIP);
    act(&mut session, Intent::Hover(Some(place)));
    assert_eq!(session.hovered().vertex, None);
    let before = positions(&session);
    paint(&mut session, place);
    assert_eq!((face(&session).selection(), positions(&session)), (None, before));
    act(&mut session, Intent::Scene(Scene::Solid));
    assert_eq!(session.brush_px(), None);
    for wrong in [0.0, 1e9, f64::NAN] {
        let as_it_was = seen(&session);
        assert!(session.apply(Intent::Brush(Some(wrong))).is_err());
        assert!(session.apply(Intent::FalloffBand(wrong)).is_err());
        assert!(session.apply(Intent::SeenFrom(Some(wrong))).is_err());
        assert_eq!(seen(&session), as_it_was);
    }
}

#[test]
fn the_brush_paints_only_within_the_photo() {
    let mut session = photo();
    act(&mut session, Intent::Brush(Some(40.0)));
    for (count, corner_px) in
        [DVec2::new(1.0, 1.0), DVec2::new(639.0, 300.0), DVec2::new(639.0, 639.0)].into_iter().enumerate()
    {
        let place = session.stage().canvas_px(corner_px).unwrap();
        act(&mut session, Intent::Press(place, Pointer::Fine));
        assert!(session.has_grabbed(), "{corner_px}");
        act(&mut session, Intent::Release);
        assert_eq!(face(&session).photo().strokes().count(), count + 1);
    }
    let radii: Vec<f64> = face(&session).photo().strokes().dabs().map(|dab| dab.radius_px).collect();
    assert!(radii.iter().all(|radius| (radius - radii[0]).abs() < 1e-9), "{radii:?}");
    let beyond = session.stage().canvas_px(DVec2::new(660.0, 300.0)).unwrap();
    act(&mut session, Intent::Press(beyond, Pointer::Coarse));
    assert!(!session.has_grabbed());
    act(&mut session, Intent::Release);
    assert_eq!((face(&session).photo().strokes().count(), face(&session).selection()), (3, None));
}

#[test]
fn photo_edits_are_restored_with_the_work() {
    let mut session = photo();
    act(&mut session, Intent::SeenFrom(Some(1.5)));
    act(&mut session, Intent::Brush(Some(20.0)));
    session.stage_mut().advance(0.0);
    let place = position_px(&session, NOSE_TIP);
    paint(&mut session, place);
    let kept = face(&session).photo().strokes().clone();
    let saved = saved(&session);
    let mut next = crate::faces::session();
    open(&mut next, saved.clone());
    assert_eq!(face(&next).photo().strokes(), &kept);
    assert_eq!(face(&next).photo().seen_from_m(), Some(1.5));
    let with = |photo_edit: &str| {
        let edits = saved.edits.clone().map(|edits| SavedEdits { photo_edit: Some(photo_edit.to_owned()), ..edits });
        Intent::Open(Box::new(SavedFace { edits, ..saved.clone() }))
    };
    let far = r#"{"seen_from_m":-1,"protected_px":[]}"#;
    for wrong in ["", "{}", far, r#"{"protected_px":[[[1,2]]]}"#, r#"{"protected_px":[[[1,2,0]]]}"#] {
        let as_it_was = seen(&next);
        assert!(next.apply(with(wrong)).is_err(), "{wrong}");
        assert_eq!(seen(&next), as_it_was);
    }
}

#[test]
fn edits_along_the_view_direction_are_reported() {
    let mut session = session();
    select(&mut session, Selection::Landmark(NOSE_TIP));
    for (offset_mm, is_along) in
        [(DVec3::new(0.0, 0.0, 8.0), true), (DVec3::new(0.0, 5.0, 0.0), false), (DVec3::ZERO, false)]
    {
        act(&mut session, Intent::Offset(offset_mm));
        assert_eq!(session.tick().is_along_view, is_along, "{offset_mm}");
    }
    act(&mut session, Intent::Offset(DVec3::new(0.0, 0.0, 8.0)));
    act(&mut session, Intent::Commit);
    assert!(session.tick().is_along_view);
    act(&mut session, Intent::ShowDepth);
    session.stage_mut().advance(0.0);
    assert!(!session.tick().is_along_view, "it is visible from the side");
}
