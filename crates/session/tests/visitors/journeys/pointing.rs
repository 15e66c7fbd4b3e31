use glam::{DVec2, DVec3};
use rosto_session::{Changed, Intent, Pace, Selection, Session};
use rosto_stage::{Pointer, ShadingMode};
use rosto_studio::FaceSlider;

use super::{act, face, place_px, positions, select, state};
use crate::faces::{found, session};
use crate::invariants::{hold, shape};
use rosto_session::Motion;

const MOUTH_CORNER: u32 = 61;
const BY_PX: DVec2 = DVec2::new(30.0, -20.0);

fn drag(session: &mut Session, to_px: DVec2) -> Changed {
    act(session, Intent::Drag(to_px, Pace::Usual))
}

#[test]
fn what_is_dragged_is_under_the_pointer_and_is_one_entry() {
    let mut session = session();
    let rest = shape(&session);
    for (count, vertex) in [(1, MOUTH_CORNER), (2, 205), (3, 334)] {
        let before = shape(&session);
        let from = place_px(&session, vertex);
        assert_eq!(act(&mut session, Intent::Hover(Some(from))), Changed::View);
        assert!(session.under().is_movable && session.under().vertex == Some(vertex), "{:?}", session.under());
        act(&mut session, Intent::Press(from, Pointer::Fine));
        assert!(session.has_grabbed() && !session.is_dragging());
        assert_ne!(face(&session).selected(), Some(vertex), "a press alone selects nothing");
        assert_eq!(drag(&mut session, from + BY_PX * 0.5), Changed::Document);
        assert_eq!(drag(&mut session, from + BY_PX), Changed::Tick);
        assert!(session.is_dragging() && session.tick().is_editing);
        assert_eq!(face(&session).selection(), Some(Selection::Landmark(vertex)));
        let now = place_px(&session, vertex);
        assert!(now.distance(from + BY_PX) < 1e-6, "{vertex} is at {now}");
        assert_eq!(shape(&session), before, "nothing is kept before the pointer is let go");
        assert_eq!(act(&mut session, Intent::Release), Changed::Document);
        assert!(!session.has_grabbed() && !session.tick().is_editing);
        assert_eq!(state(&session).entry_count, count);
        assert!(place_px(&session, vertex).distance(from + BY_PX) < 1e-6);
        assert_eq!(drag(&mut session, from), Changed::Nothing);
        hold(&session).unwrap();
    }
    for _ in 0..3 {
        act(&mut session, Intent::Undo);
    }
    assert_eq!(shape(&session), rest);
}

#[test]
fn what_is_put_back_in_a_drag_stays_for_the_rest_of_the_press() {
    let mut session = session();
    let (before, from) = (positions(&session), place_px(&session, MOUTH_CORNER));
    act(&mut session, Intent::Press(from, Pointer::Fine));
    drag(&mut session, from + BY_PX);
    assert_ne!(positions(&session), before);
    assert_eq!(act(&mut session, Intent::Cancel), Changed::Document);
    assert_eq!(positions(&session), before);
    assert!(session.has_grabbed() && !session.is_dragging(), "nor does the rest of the press turn the face");
    assert_eq!(drag(&mut session, from + 2.0 * BY_PX), Changed::Nothing);
    assert_eq!(act(&mut session, Intent::Release), Changed::Nothing);
    assert_eq!((positions(&session), state(&session).entry_count), (before, 0));
    assert!(!session.has_grabbed());
    act(&mut session, Intent::Press(from, Pointer::Fine));
    drag(&mut session, from + BY_PX);
    act(&mut session, Intent::Release);
    assert_eq!(state(&session).entry_count, 1);
}

#[test]
fn a_finger_only_takes_what_is_selected() {
    let mut session = session();
    let (before, from) = (positions(&session), place_px(&session, MOUTH_CORNER));
    let touch = |session: &mut Session, from: DVec2| {
        act(session, Intent::Press(from, Pointer::Coarse));
        let has_grabbed = session.has_grabbed();
        drag(session, from + BY_PX);
        act(session, Intent::Release);
        has_grabbed
    };
    assert!(!touch(&mut session, from));
    let far = place_px(&session, 334);
    select(&mut session, Selection::Landmark(MOUTH_CORNER));
    assert!(!touch(&mut session, far));
    assert_eq!((positions(&session), face(&session).selected()), (before, Some(MOUTH_CORNER)));
    assert!(touch(&mut session, from));
    assert!(place_px(&session, MOUTH_CORNER).distance(from + BY_PX) < 1e-6);
    assert_eq!(state(&session).entry_count, 1);
}

#[test]
fn what_has_changed_is_told_no_further_than_it_has() {
    let mut session = Session::new(1);
    act(&mut session, Intent::Motion(Motion::Reduced));
    for nothing in [Intent::Preview(DVec3::Z), Intent::Commit, Intent::Undo, Intent::Release] {
        assert_eq!(act(&mut session, nothing), Changed::Nothing);
    }
    for (intent, changed) in [
        (Intent::Open(Box::new(found())), Changed::Mesh),
        (Intent::Select(Some(Selection::Landmark(MOUTH_CORNER))), Changed::Document),
        (Intent::Preview(DVec3::Z), Changed::Tick),
        (Intent::Commit, Changed::Document),
        (Intent::Slide(FaceSlider::NoseWidth, 1.0), Changed::Document),
        (Intent::Slide(FaceSlider::NoseWidth, 2.0), Changed::Tick),
        (Intent::Orbit(BY_PX), Changed::View),
        (Intent::Hover(Some(BY_PX)), Changed::View),
        (Intent::Shading(ShadingMode::Distortion), Changed::Tick),
        (Intent::Undo, Changed::Document),
        (Intent::Redo, Changed::Document),
        (Intent::Density(1), Changed::Mesh),
        (Intent::Triangulation(rosto_face::Triangulation::Tessellation), Changed::Mesh),
        (Intent::Drag(BY_PX, Pace::Usual), Changed::Nothing),
        (Intent::Close, Changed::Mesh),
    ] {
        assert_eq!(act(&mut session, intent.clone()), changed, "{intent:?}");
    }
    let order = [Changed::Nothing, Changed::View, Changed::Tick, Changed::Document, Changed::Mesh];
    assert!(order.is_sorted());
}
