use glam::DVec2;
use rosto_face::{FaceError, ScaleSource};
use rosto_session::{Intent, SessionError};
use rosto_stage::{Pointer, Scene};

use super::photo::photo;
use super::{act, face, positions};
use crate::faces::{bits, session};

const CHIN: usize = 152;
/// Half of a card's sides in px of the photo.
const HALF_PX: DVec2 = DVec2::new(85.6, 53.98);

/// Corners of a card around the chin, in px of the canvas, scaled by `times`.
fn corners_px(session: &rosto_session::Session, times: DVec2) -> [DVec2; 4] {
    let size_px = DVec2::from(face(session).model().photo_size_px().map(f64::from));
    let chin_px = face(session).model().uvs()[CHIN] * size_px;
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(x, y)| session.stage().canvas_px(chin_px + DVec2::new(x, y) * HALF_PX * times).unwrap())
}

#[test]
fn four_marks_measure_the_face_and_forgetting_them_restores_it() {
    let mut session = photo();
    let before = positions(&session);
    act(&mut session, Intent::MarkCard);
    let places = corners_px(&session, DVec2::ONE);
    act(&mut session, Intent::Press(DVec2::new(-5.0, -5.0), Pointer::Fine));
    act(&mut session, Intent::Press(places[1], Pointer::Coarse));
    act(&mut session, Intent::Undo);
    assert!(session.protected_on_canvas().is_empty(), "undo removes a mark");
    for (count, place) in places.into_iter().enumerate() {
        assert_eq!(session.protected_on_canvas().len(), count);
        act(&mut session, Intent::Press(place, Pointer::Coarse));
        act(&mut session, Intent::Release);
    }
    assert_eq!((face(&session).model().scale().source, session.pointer_radius_px()), (ScaleSource::Card, None));
    assert_ne!(bits(&positions(&session)), bits(&before));
    assert!(face(&session).saved_photos().contains("observation"));
    assert!(face(&session).model().photos()[0].card.is_some(), "it is saved with the photo");
    act(&mut session, Intent::ForgetCard);
    assert_eq!(bits(&positions(&session)), bits(&before));
}

#[test]
fn other_shapes_are_refused_and_marked_again() {
    let mut session = photo();
    let before = positions(&session);
    act(&mut session, Intent::MarkCard);
    let [first, second, third, fourth] = corners_px(&session, DVec2::new(0.6, 1.0));
    for place in [first, second, third] {
        act(&mut session, Intent::Press(place, Pointer::Fine));
    }
    let refused = session.apply(Intent::Press(fourth, Pointer::Fine));
    assert_eq!(refused, Err(SessionError::Face(FaceError::NotACard)));
    assert_eq!(bits(&positions(&session)), bits(&before));
    assert!(session.protected_on_canvas().is_empty() && session.pointer_radius_px().is_some(), "marking starts again");
    act(&mut session, Intent::Scene(Scene::Solid));
    assert_eq!(session.pointer_radius_px(), None);
}

#[test]
fn marking_shows_the_photo_and_needs_a_face() {
    let mut session = session();
    act(&mut session, Intent::Brush(Some(20.0)));
    act(&mut session, Intent::MarkCard);
    assert_eq!((session.view().scene, session.brush_px()), (Scene::Picture, None));
    act(&mut session, Intent::Close);
    assert_eq!(session.apply(Intent::MarkCard), Err(SessionError::NoFace));
    assert_eq!(session.apply(Intent::ForgetCard), Err(SessionError::NoFace));
}
