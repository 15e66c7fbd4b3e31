//! Panels describe all that they show, and a widget shows the value that was set.

use std::collections::BTreeSet;

use glam::DVec3;
use proptest::prelude::*;
use rosto_session::{
    Catalogue, Changed, Control, Intent, MAX_LISTED, Selection, SelectionMode, Session, Value, Widget,
};
use rosto_studio::FaceSlider;

use crate::faces::session;
use crate::rendering::{LANGUAGES, all, rendered, words};

const NOSE_TIP: u32 = 1;

/// A session with an edit and a selection.
fn edited() -> Session {
    let mut session = session();
    for intent in [
        Intent::Slide(FaceSlider::NoseWidth, 2.0),
        Intent::Commit,
        Intent::Select(Some(Selection::Landmark(NOSE_TIP))),
        Intent::Offset(DVec3::Z),
        Intent::Commit,
    ] {
        session.apply(intent).unwrap();
    }
    session
}

#[test]
fn every_panel_renders_to_text_in_every_language() {
    for language in LANGUAGES {
        let words = words(language);
        let mut session = edited();
        for mode in SelectionMode::ALL {
            session.apply(Intent::Mode(mode)).unwrap();
            session.apply(Intent::Expert(mode == SelectionMode::Point)).unwrap();
            let text = rendered(&words, &session.panel(), 0);
            assert!(text.lines().count() > 100, "{text}");
        }
        assert!(rendered(&words, &Session::new(1).panel(), 0).lines().count() > 80);
    }
}

#[test]
fn the_text_of_the_panel_shows_edits_and_values() {
    let text = rendered(&words("en"), &edited().panel(), 0);
    for line in ["Nose width: 2.0 mm", "forward: 1.0 mm", "[x] nose tip (1.0 mm)", "[x] Nose width (2.0 mm)", "<Undo>"]
    {
        assert!(text.contains(line), "no {line:?} in\n{text}");
    }
}

#[test]
fn ids_are_unique() {
    let panel = edited().panel();
    let ids: BTreeSet<&str> = all(&panel).into_iter().map(|widget| widget.id.as_ref()).collect();
    assert_eq!(ids.len(), all(&panel).len());
}

#[test]
fn the_history_lists_the_latest_entries() {
    let mut session = session();
    let count = MAX_LISTED + 2;
    for mm in 1..=count {
        session.apply(Intent::Slide(FaceSlider::NoseWidth, 0.1 * (mm % 2) as f64)).unwrap();
        session.apply(Intent::Commit).unwrap();
    }
    let panel = session.panel();
    let history = all(&panel).into_iter().find(|widget| widget.id == "history").unwrap();
    let ids: Vec<&str> = history.children().iter().map(|widget| widget.id.as_ref()).collect();
    assert_eq!((ids.len(), ids[0]), (MAX_LISTED, format!("entry.{}", count - 1).as_str()));
    assert!(rendered(&words("en"), &panel, 0).contains("and 2 earlier edits"));
}

/// The value that a widget shows.
fn value_of(widget: &Widget) -> Option<Value> {
    match &widget.control {
        Control::Slider { value, .. } => Some(Value::Number(*value)),
        Control::Check { on, .. } => Some(Value::Flag(*on)),
        Control::Choice { chosen, .. } => chosen.clone().map(Value::Text),
        Control::Colour { rgb } => Some(Value::Colour(*rgb)),
        _ => None,
    }
}

/// Another value of a widget; `share` chooses it.
fn another_value(widget: &Widget, share: f64) -> Option<Value> {
    match &widget.control {
        Control::Slider { range, .. } => Some(Value::Number(range.min + share * (range.max - range.min))),
        Control::Check { on, .. } => Some(Value::Flag(!on)),
        Control::Choice { options, .. } => Some(Value::Text(options[(share * options.len() as f64) as usize].clone())),
        Control::Colour { .. } => Some(Value::Colour([(255.0 * share) as u8, 3, 4])),
        _ => None,
    }
}

fn is_close(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::Number(one), Value::Number(other)) => (one - other).abs() < 1e-6 * other.abs().max(1.0),
        _ => one == other,
    }
}

#[test]
fn a_widget_shows_the_value_that_was_set() {
    let ids: Vec<String> = all(&edited().panel()).iter().map(|widget| widget.id.to_string()).collect();
    let mut set = 0;
    for id in ids {
        let mut session = edited();
        let find = |session: &Session| all(&session.panel()).into_iter().find(|widget| widget.id == id).cloned();
        let Some(value) =
            find(&session).filter(|widget| widget.is_enabled).and_then(|widget| another_value(&widget, 0.75))
        else {
            continue;
        };
        session.apply(Intent::Set(id.clone(), value.clone())).unwrap_or_else(|error| panic!("{id}: {error}"));
        let shown = find(&session).and_then(|widget| value_of(&widget)).unwrap();
        assert!(is_close(&shown, &value), "{id} shows {shown:?} instead of {value:?}");
        set += 1;
    }
    assert!(set > 60, "{set} widgets were set");
}

#[test]
fn unknown_widgets_and_values_of_another_type_are_refused() {
    let mut session = edited();
    let before = session.panel();
    for (id, value) in [
        ("ears", Value::Number(1.0)),
        ("edit.mirror", Value::Number(1.0)),
        ("slider.nose-width", Value::Text("wide".into())),
        ("slider.nose-width", Value::Number(f64::NAN)),
        ("shading", Value::Text("mauve".into())),
        ("section.face", Value::Flag(true)),
    ] {
        assert!(session.apply(Intent::Set(id.into(), value)).is_err(), "{id}");
    }
    assert!(session.apply(Intent::Push("ears".into())).is_err());
    assert_eq!(session.panel(), before);
}

/// Replaces widgets by those of a diff, as a front end does.
fn update(shown: &mut Vec<Widget>, diff: &[Widget]) {
    for widget in diff {
        if !shown.iter_mut().any(|old| replace(old, widget)) {
            shown.push(widget.clone());
        }
    }
}

fn replace(old: &mut Widget, new: &Widget) -> bool {
    if old.id == new.id {
        *old = new.clone();
        return true;
    }
    match &mut old.control {
        Control::Group { widgets, .. } => widgets.iter_mut().any(|child| replace(child, new)),
        _ => false,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// After any actions of the user, the changes add up to the panel.
    #[test]
    fn diffs_add_up_to_the_panel(actions in prop::collection::vec((any::<prop::sample::Index>(), 0.0..1.0), 1..12)) {
        let mut session = edited();
        let (mut known, mut shown) = (Vec::new(), Vec::new());
        update(&mut shown, &session.panel_diff(&mut known, Changed::Mesh).widgets);
        for (index, share) in actions {
            let panel = session.panel();
            let widgets = all(&panel);
            let widget = index.get(&widgets);
            let intent = match another_value(widget, share) {
                Some(value) => Intent::Set(widget.id.to_string(), value),
                None => Intent::Push(widget.id.to_string()),
            };
            let changed = session.apply(intent).unwrap_or(Changed::Nothing);
            let extent = if changed == Changed::Tick { Changed::Tick } else { Changed::Document };
            update(&mut shown, &session.panel_diff(&mut known, extent).widgets);
            // Sections that no tick changes are shown at the end of an edit.
            session.apply(Intent::Commit).unwrap();
            update(&mut shown, &session.panel_diff(&mut known, Changed::Document).widgets);
            prop_assert_eq!(&shown, &session.panel());
        }
    }
}

/// Keys on the page and on the canvas, as the page matches them.
#[test]
fn each_key_has_one_meaning_and_acts() {
    let keys = Catalogue::default().keys;
    let ids: BTreeSet<_> = keys.iter().map(|key| key.id).collect();
    let meanings: BTreeSet<_> = keys.iter().map(|key| format!("{} {:?} {:?}", key.key, key.with, key.place)).collect();
    assert_eq!([ids.len(), meanings.len()], [keys.len(); 2]);
    for key in keys {
        let mut session = edited();
        session.stage_mut().camera_mut().resize(640, 480);
        session.apply(Intent::Push(key.id.to_owned())).unwrap_or_else(|error| panic!("{}: {error}", key.id));
    }
    let mut session = edited();
    let redone = ["key.undo", "key.redo"].map(|id| {
        session.apply(Intent::Push(id.to_owned())).unwrap();
        session.state().offset_mm
    });
    assert_ne!(redone[0], redone[1]);
}
