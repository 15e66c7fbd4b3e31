//! A refused intent leaves the session unchanged, whichever call fails.

use glam::{DVec2, DVec3};
use rosto_face::{PhotoLens, Triangulation};
use rosto_stage::{Axis, Pointer};
use rosto_studio::{Details, Expression, FaceSlider, Mirror, StudioError, Switch};

use super::Session;
use crate::faces::{bits, detected, session};
use crate::{Intent, Pace, Preset, Selection, SelectionMode, SessionError};

/// Upper bound on the fallible calls of an intent.
const MAX_CALLS: u32 = 100;
const NOSE_TIP: u32 = 1;

/// A session with an edit of the mouth, an undone edit, and the nose tip selected.
fn edited_session() -> Session {
    let mut session = session();
    for intent in [
        Intent::Select(Some(Selection::Landmark(61))),
        Intent::Offset(DVec3::new(1.0, 2.0, 3.0)),
        Intent::Commit,
        Intent::Slide(FaceSlider::NoseWidth, 1.0),
        Intent::Commit,
        Intent::Undo,
        Intent::Select(Some(Selection::Landmark(NOSE_TIP))),
    ] {
        session.apply(intent).unwrap();
    }
    session
}

/// States of an edit in progress before the intent.
fn edits_in_progress() -> Vec<Vec<Intent>> {
    let position_px = |landmark: usize| {
        let session = edited_session();
        let position_m = session.face().unwrap().document().positions()[landmark];
        session.stage().camera().project(position_m).unwrap()
    };
    let nose_px = position_px(NOSE_TIP as usize);
    let press = || Intent::Press(nose_px, Pointer::Fine);
    vec![
        vec![],
        vec![Intent::Offset(DVec3::new(0.0, 2.0, 1.0))],
        vec![Intent::Offset(DVec3::new(2.0, 2.0, 1.0))],
        vec![Intent::Details(Details::AsRigidAsPossible), Intent::Offset(DVec3::Y)],
        vec![Intent::Slide(FaceSlider::NoseLength, 1.0)],
        vec![Intent::Express(Expression::JawOpen, 0.5)],
        vec![Intent::Mode(SelectionMode::Region), press()],
        vec![press(), Intent::Drag(nose_px + DVec2::splat(20.0), Pace::Usual)],
    ]
}

fn intents() -> Vec<Intent> {
    let position_px = DVec2::new(420.0, 320.0);
    vec![
        Intent::Preset(Preset::Paper),
        Intent::Preset(Preset::Sculpt),
        Intent::Details(Details::AsRigidAsPossible),
        Intent::Mirror(Mirror::Off),
        Intent::Symmetrise(0.5),
        Intent::Density(0),
        Intent::Density(1),
        Intent::Triangulation(Triangulation::Tessellation),
        Intent::PhotoLens(PhotoLens::Distance(0.4)),
        Intent::AddPhoto(Box::new(detected())),
        Intent::RemovePhoto(1),
        Intent::Offset(DVec3::new(0.0, 1.0, 0.0)),
        Intent::Offset(DVec3::new(1.0, 1.0, 0.0)),
        Intent::Slide(FaceSlider::NoseWidth, 0.5),
        Intent::Slide(FaceSlider::NoseLength, 0.5),
        Intent::Express(Expression::JawOpen, 0.2),
        Intent::Express(Expression::BrowInnerUp, 0.2),
        Intent::Drag(position_px, Pace::Usual),
        Intent::Along(Some(Axis::X)),
        Intent::Release,
        Intent::Mode(SelectionMode::Point),
        Intent::Select(Some(Selection::Landmark(152))),
        Intent::SelectAt(10),
        Intent::Pin(Switch::On),
        Intent::Commit,
        Intent::Cancel,
        Intent::Undo,
        Intent::Redo,
        Intent::Reset,
        Intent::ResetSelected,
        Intent::ResetExpressions,
        Intent::Switch(0, Switch::Off),
    ]
}

/// The externally observable state of a session, and its next seed.
fn observable_state(session: &Session) -> impl PartialEq + use<> {
    let face = session.face().unwrap();
    let shape = (bits(face.document().positions()), bits(face.document().committed()), bits(face.document().rest()));
    let past = (face.document().history().clone(), face.rows().to_vec(), face.photos(), face.model().lens());
    let hand = (session.hovered(), session.gesture.clone(), session.seeds.peek(), face.pins().to_vec());
    let seen = (session.stage.mark_words(), format!("{:?}", session.stage), face.photo().needs_factorisation());
    let fields = (face.influence_fields().map(|field| field.map(<[f64]>::to_vec)), face.influence_offsets_m());
    (session.state(), session.tick(), session.preferences(), shape, past, (hand, seen, fields))
}

/// Makes each fallible call of an intent fail in turn; returns the number of refusals.
fn count_refusals(intent: &Intent, edits_in_progress: &[Intent]) -> usize {
    let mut refusals = 0;
    for calls in 0..MAX_CALLS {
        let mut session = edited_session();
        for intent in edits_in_progress {
            session.apply(intent.clone()).unwrap();
        }
        let before = observable_state(&session);
        session.face.as_mut().unwrap().document_mut().fail_after(calls);
        let done = session.apply(intent.clone());
        let not_reached = session.face.as_mut().unwrap().document_mut().is_to_fail();
        if let Err(reason) = done {
            assert!(
                observable_state(&session) == before,
                "{intent:?} was refused ({reason}) after {edits_in_progress:?}, call {calls}"
            );
            refusals += usize::from(reason == SessionError::Studio(StudioError::Injected));
        }
        if not_reached {
            return refusals;
        }
    }
    panic!("{intent:?} makes more than {MAX_CALLS} fallible calls");
}

#[test]
#[ignore = "slow; runs at night"]
fn refused_intents_leave_the_session_unchanged() {
    let mut refusals = std::collections::BTreeMap::new();
    for edits_in_progress in edits_in_progress() {
        for intent in intents() {
            *refusals.entry(format!("{intent:?}")).or_insert(0) += count_refusals(&intent, &edits_in_progress);
        }
    }
    // Intents with several fallible steps.
    for intent in [
        Intent::Preset(Preset::Paper),
        Intent::Symmetrise(0.5),
        Intent::Density(1),
        Intent::Triangulation(Triangulation::Tessellation),
        Intent::PhotoLens(PhotoLens::Distance(0.4)),
        Intent::Slide(FaceSlider::NoseWidth, 0.5),
        Intent::Express(Expression::JawOpen, 0.2),
        Intent::Offset(DVec3::new(1.0, 1.0, 0.0)),
        Intent::Drag(DVec2::new(420.0, 320.0), Pace::Usual),
    ] {
        assert!(refusals[&format!("{intent:?}")] > 0, "{intent:?} was not refused");
    }
}
