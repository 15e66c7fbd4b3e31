//! Intents arrive as plain objects with absolute values, and the state and the ticks carry what panels show.

use glam::{DVec2, DVec3};
use rosto_face::{PhotoLens, Region};
use rosto_session::{Catalogue, Choice, Intent, Motion, Pace, Selection, Session, Turntable};
use rosto_stage::{Axis, Background, Light, NamedView, Pointer, Srgb, Theme};
use rosto_studio::{ConstraintKind, Expression, FaceSlider, Mirror, Switch};
use serde_json::{Value, json};

use crate::faces::session;
use crate::invariants::seen;

const NOSE_TIP: u32 = 1;

fn intent(message: Value) -> serde_json::Result<Intent> {
    serde_json::from_value(message)
}

#[test]
fn intents_are_read_from_plain_objects() {
    let light = Light { azimuth_deg: 1.0, elevation_deg: 2.0, strength: 0.5, ambient: 0.25, colour: Srgb([1, 2, 3]) };
    for (message, wanted) in [
        (json!("undo"), Intent::Undo),
        (json!({ "zoom": 1.2 }), Intent::Zoom(1.2)),
        (json!({ "slide": ["nose-width", 3] }), Intent::Slide(FaceSlider::NoseWidth, 3.0)),
        (json!({ "express": ["jawOpen", 0.5] }), Intent::Express(Expression::JawOpen, 0.5)),
        (json!({ "offset": [1, 2, 3] }), Intent::Offset(DVec3::new(1.0, 2.0, 3.0))),
        (json!({ "select": null }), Intent::Select(None)),
        (json!({ "select": { "region": "nose" } }), Intent::Select(Some(Selection::Region(Region::Nose)))),
        (json!({ "select": { "landmark": 4 } }), Intent::Select(Some(Selection::Landmark(4)))),
        (
            json!({ "select": { "point": { "level": 1, "vertex": 900 } } }),
            Intent::Select(Some(Selection::Point { level: 1, vertex: 900 })),
        ),
        (json!({ "mirror": true }), Intent::Mirror(Mirror::On)),
        (json!({ "turntable": false }), Intent::Turntable(Turntable::Still)),
        (json!({ "reduced-motion": true }), Intent::Motion(Motion::Reduced)),
        (json!({ "switch": [2, false] }), Intent::Switch(2, Switch::Off)),
        (json!({ "press": [[3, 4], true] }), Intent::Press(DVec2::new(3.0, 4.0), Pointer::Coarse)),
        (json!({ "drag": [[3, 4], false] }), Intent::Drag(DVec2::new(3.0, 4.0), Pace::Usual)),
        (json!({ "hover": null }), Intent::Hover(None)),
        (json!({ "along": "x" }), Intent::Along(Some(Axis::X))),
        (json!({ "along": null }), Intent::Along(None)),
        (json!({ "constraint": "soft" }), Intent::Constraint(ConstraintKind::Soft { weight: 1.0 })),
        (json!({ "density": "2" }), Intent::Density(2)),
        (json!({ "photo-lens": "distance:0.5" }), Intent::PhotoLens(PhotoLens::Distance(0.5))),
        (json!({ "background": [1, 2, 3] }), Intent::Background(Background::Plain(Srgb([1, 2, 3])))),
        (json!({ "background": null }), Intent::Background(Background::Ground)),
        (
            json!({ "light": {
                "azimuthDeg": 1, "elevationDeg": 2, "strength": 0.5, "ambient": 0.25, "colour": [1, 2, 3],
            } }),
            Intent::Light(light),
        ),
        (json!({ "theme": "dark" }), Intent::Theme(Theme::Dark)),
        (json!({ "go-to": "front" }), Intent::GoTo(NamedView::Front)),
        (json!({ "resize": [[800, 600], 2] }), Intent::Resize([800, 600], 2.0)),
    ] {
        assert_eq!(intent(message.clone()).unwrap(), wanted, "{message}");
    }
}

#[test]
fn other_messages_are_refused() {
    for message in [
        json!(7),
        json!(null),
        json!({}),
        json!([]),
        json!("dance"),
        json!("zoom"),
        json!({ "zoom": "1.2" }),
        json!({ "undo": 1 }),
        json!({ "undo": null, "redo": null }),
        json!({ "slide": ["ear-size", 1] }),
        json!({ "slide": ["nose-width"] }),
        json!({ "offset": [1, 2] }),
        json!({ "select-at": -1 }),
        json!({ "select-at": 1.5 }),
        json!({ "mirror": "on" }),
        json!({ "density": "4" }),
        json!({ "density": 2 }),
        json!({ "photo-lens": "fisheye" }),
        json!({ "background": [1, 2, 300] }),
        json!({ "open": {} }),
        json!({ "add-photo": {} }),
    ] {
        assert!(intent(message.clone()).is_err(), "{message}");
    }
}

/// A session with the nose tip selected.
fn selected() -> Session {
    let mut session = session();
    session.apply(Intent::Select(Some(Selection::Landmark(NOSE_TIP)))).unwrap();
    session
}

fn edit(session: &mut Session, intent: Intent) {
    session.apply(intent).unwrap();
    session.apply(Intent::Commit).unwrap();
}

#[test]
fn repeated_values_change_nothing() {
    let mut session = selected();
    session.apply(Intent::Mirror(Mirror::Off)).unwrap();
    for values in [
        [Intent::Offset(DVec3::new(0.7, 0.0, 0.1)), Intent::Offset(DVec3::new(1.2, 0.3, 0.1))],
        [Intent::Slide(FaceSlider::NoseWidth, 0.1), Intent::Slide(FaceSlider::NoseWidth, 0.3)],
        [Intent::Express(Expression::JawOpen, 0.1), Intent::Express(Expression::JawOpen, 0.7)],
    ] {
        let [_, last] = &values;
        values.iter().for_each(|value| edit(&mut session, value.clone()));
        let before = seen(&session);
        edit(&mut session, last.clone());
        assert!(seen(&session) == before, "{last:?} was repeated");
    }
    for setting in [
        json!({ "radius": 33 }),
        json!({ "mirror": true }),
        json!({ "pin": true }),
        json!({ "seen-from": 1.5 }),
        json!({ "wipe": 0.5 }),
        json!({ "select": { "region": "chin" } }),
    ] {
        session.apply(intent(setting.clone()).unwrap()).unwrap();
        let before = seen(&session);
        session.apply(intent(setting.clone()).unwrap()).unwrap();
        assert!(seen(&session) == before, "{setting} was repeated");
    }
}

#[test]
fn an_offset_includes_earlier_entries() {
    let mut session = selected();
    edit(&mut session, Intent::Offset(DVec3::new(0.0, 1.0, 2.0)));
    session.apply(Intent::Offset(DVec3::new(0.0, 1.0, 5.0))).unwrap();
    assert_eq!((session.tick().offset_mm, session.state().offset_mm), (Some([0.0, 1.0, 5.0]), [0.0, 1.0, 5.0]));
    session.apply(Intent::Commit).unwrap();
    let state = session.state();
    let amount = session.face().unwrap().rows()[1].amount;
    assert_eq!((state.tick.offset_mm, state.offset_mm, amount), (None, [0.0, 1.0, 5.0], 3.0));
}

#[test]
fn a_tick_carries_only_what_moves() {
    let mut session = selected();
    let moved = |session: &Session| {
        let tick = session.tick();
        (tick.offset_mm, tick.slider, tick.expressions)
    };
    assert_eq!(moved(&session), (None, None, vec![]));
    session.apply(Intent::Offset(DVec3::Z)).unwrap();
    assert_eq!(moved(&session), (Some([0.0, 0.0, 1.0]), None, vec![]));
    session.apply(Intent::Slide(FaceSlider::NoseWidth, 2.0)).unwrap();
    assert_eq!(moved(&session), (None, Some(("nose-width", 2.0)), vec![]));
    session.apply(Intent::Express(Expression::EyeBlinkLeft, 0.5)).unwrap();
    assert_eq!(moved(&session), (None, None, vec![("eyeBlinkLeft", 0.5), ("eyeBlinkRight", 0.5)]));
    session.apply(Intent::Cancel).unwrap();
    assert_eq!(moved(&session), (None, None, vec![]));
    let state = session.state();
    assert_eq!((state.sliders_mm["nose-width"], state.weights["eyeBlinkLeft"]), (2.0, 0.0));
}

#[test]
fn the_answer_names_the_vertex_under_the_pointer() {
    let mut session = selected();
    let nose_m = session.face().unwrap().document().positions()[NOSE_TIP as usize];
    let nose_px = session.stage().camera().project(nose_m).unwrap();
    let hovered = session.answer(Intent::Hover(Some(nose_px))).unwrap();
    assert_eq!((hovered.hovered, hovered.has_grabbed), (Some(NOSE_TIP), false));
    assert_eq!(hovered.hovered_name.unwrap().key, "landmark.nose-tip");
    assert!(session.answer(Intent::Press(nose_px, Pointer::Fine)).unwrap().has_grabbed);
    assert!(!session.answer(Intent::Release).unwrap().has_grabbed);
    assert_eq!(session.answer(Intent::Hover(None)).unwrap().hovered_name, None);
}

#[test]
fn messages_name_their_fields_in_camel_case() {
    let session = selected();
    let state = serde_json::to_value(session.state()).unwrap();
    assert_eq!((&state["vertexCount"], &state["chosen"]["density"]), (&json!(7_257), &json!("2")));
    assert_eq!((&state["name"]["key"], &state["photos"][0]["leads"]), (&json!("landmark.nose-tip"), &json!(true)));
    let catalogue = serde_json::to_value(Catalogue::default()).unwrap();
    assert_eq!((&catalogue["landmarks"][1], &catalogue["radius"]["neutral"]), (&json!("nose-tip"), &json!(25.0)));
    for choice in Choice::ALL {
        let chosen = &state["chosen"][choice.id()];
        assert!(chosen.is_null() || choice.values().iter().any(|id| chosen == id), "{choice:?}: {chosen}");
    }
}
