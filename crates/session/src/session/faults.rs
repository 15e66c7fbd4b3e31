//! Whatever fails while an intent is carried out, a refusal leaves the session as it was.

use glam::{DVec2, DVec3};
use rosto_face::{PhotoLens, Triangulation};
use rosto_stage::{Axis, Pointer};
use rosto_studio::{Details, Expression, FaceSlider, Mirror, StudioError, Switch};

use super::Session;
use crate::faces::{bits, found, session};
use crate::{FurtherPhoto, Incoming, Intent, Pace, Preset, Selection, SelectionMode, SessionError};

/// More fallible calls than any intent makes.
const MOST_CALLS: u32 = 100;
const NOSE_TIP: u32 = 1;

/// A session with an edit of the mouth in its history, one that was undone, and the nose tip selected.
fn worked_on() -> Session {
    let mut session = session();
    for intent in [
        Intent::Select(Some(Selection::Landmark(61))),
        Intent::Preview(DVec3::new(1.0, 2.0, 3.0)),
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

/// The same face in a further photo.
fn further() -> FurtherPhoto {
    let Incoming { landmarks, photo_size_px, colours_srgb, picture, lens, .. } = found();
    FurtherPhoto { landmarks, photo_size_px, colours_srgb, picture, lens }
}

/// What may be in hand when an intent comes.
fn in_hand() -> Vec<Vec<Intent>> {
    let place_px = |landmark: usize| {
        let session = worked_on();
        let position_m = session.face().unwrap().document().positions()[landmark];
        session.stage().camera().project(position_m).unwrap()
    };
    let nose_px = place_px(NOSE_TIP as usize);
    let press = || Intent::Press(nose_px, Pointer::Fine);
    vec![
        vec![],
        vec![Intent::Preview(DVec3::new(0.0, 2.0, 1.0))],
        vec![Intent::Preview(DVec3::new(2.0, 2.0, 1.0))],
        vec![Intent::Details(Details::AsRigidAsPossible), Intent::Preview(DVec3::Y)],
        vec![Intent::Slide(FaceSlider::NoseLength, 1.0)],
        vec![Intent::Express(Expression::JawOpen, 0.5)],
        vec![Intent::Mode(SelectionMode::Region), press()],
        vec![press(), Intent::Drag(nose_px + DVec2::splat(20.0), Pace::Usual)],
    ]
}

fn intents() -> Vec<Intent> {
    let place_px = DVec2::new(420.0, 320.0);
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
        Intent::AddPhoto(Box::new(further())),
        Intent::RemovePhoto(1),
        Intent::Preview(DVec3::new(0.0, 1.0, 0.0)),
        Intent::Preview(DVec3::new(1.0, 1.0, 0.0)),
        Intent::Slide(FaceSlider::NoseWidth, 0.5),
        Intent::Slide(FaceSlider::NoseLength, 0.5),
        Intent::Express(Expression::JawOpen, 0.2),
        Intent::Express(Expression::BrowInnerUp, 0.2),
        Intent::Drag(place_px, Pace::Usual),
        Intent::Along(Axis::X),
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
        Intent::ComeToRest,
        Intent::Switch(0, Switch::Off),
    ]
}

/// All that can be told of a session from outside, and what comes next.
fn told(session: &Session) -> impl PartialEq + use<> {
    let face = session.face().unwrap();
    let shape = (bits(face.document().positions()), bits(face.document().committed()), bits(face.document().rest()));
    let past = (face.document().history().clone(), face.rows().to_vec(), face.photos(), face.model().lens());
    let hand = (session.under(), session.gesture.clone(), session.seeds.peek(), face.pins().to_vec());
    let seen = (session.stage.mark_words(), format!("{:?}", session.stage), face.photo().waits());
    let fields = (face.influence_fields().map(|field| field.map(<[f64]>::to_vec)), face.influence_offsets_m());
    (session.state(), session.tick(), session.preferences(), shape, past, (hand, seen, fields))
}

/// Has each fallible call that an intent makes fail, one after the other; returns how many of them refused it.
fn refusals_of(intent: &Intent, in_hand: &[Intent]) -> usize {
    let mut refusals = 0;
    for calls in 0..MOST_CALLS {
        let mut session = worked_on();
        for intent in in_hand {
            session.apply(intent.clone()).unwrap();
        }
        let before = told(&session);
        session.face.as_mut().unwrap().document_mut().fail_after(calls);
        let done = session.apply(intent.clone());
        let is_past = session.face.as_mut().unwrap().document_mut().is_to_fail();
        if let Err(reason) = done {
            assert!(told(&session) == before, "{intent:?} was refused ({reason}) after {in_hand:?}, call {calls}");
            refusals += usize::from(reason == SessionError::Studio(StudioError::Injected));
        }
        if is_past {
            return refusals;
        }
    }
    panic!("{intent:?} makes more than {MOST_CALLS} fallible calls");
}

#[test]
fn whatever_fails_a_refusal_leaves_everything_as_it_was() {
    let mut refusals = std::collections::BTreeMap::new();
    for in_hand in in_hand() {
        for intent in intents() {
            *refusals.entry(format!("{intent:?}")).or_insert(0) += refusals_of(&intent, &in_hand);
        }
    }
    // Each of these takes steps that can fail after others.
    for intent in [
        Intent::Preset(Preset::Paper),
        Intent::Symmetrise(0.5),
        Intent::Density(1),
        Intent::Triangulation(Triangulation::Tessellation),
        Intent::PhotoLens(PhotoLens::Distance(0.4)),
        Intent::Slide(FaceSlider::NoseWidth, 0.5),
        Intent::Express(Expression::JawOpen, 0.2),
        Intent::Preview(DVec3::new(1.0, 1.0, 0.0)),
        Intent::Drag(DVec2::new(420.0, 320.0), Pace::Usual),
    ] {
        assert!(refusals[&format!("{intent:?}")] > 0, "{intent:?} was not refused once");
    }
}
