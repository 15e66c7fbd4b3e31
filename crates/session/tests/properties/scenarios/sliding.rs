use rosto_session::{Intent, Selection, Session};
use rosto_studio::{Document, EditTarget, FaceSlider, Rest, Switch};

use super::{act, face, positions, select, state};
use crate::faces::{bits, session};
use glam::DVec3;

/// Drags a slider to a value.
fn slide(session: &mut Session, slider: FaceSlider, to_mm: f64) {
    for tick in 1..=8 {
        act(session, Intent::Slide(slider, to_mm * f64::from(tick) / 8.0));
    }
    act(session, Intent::Commit);
}

fn value_of(session: &Session, slider: FaceSlider) -> f64 {
    state(session).sliders_mm[slider.id()]
}

#[test]
fn a_sliders_value_is_the_sum_of_its_entries_in_force() {
    let mut session = session();
    let slider = FaceSlider::NoseWidth;
    slide(&mut session, slider, 2.0);
    slide(&mut session, FaceSlider::ChinLength, -3.0);
    slide(&mut session, slider, 1.5);
    assert_eq!(state(&session).entry_count, 3);
    assert!((value_of(&session, slider) - 1.5).abs() < 1e-9);
    act(&mut session, Intent::Switch(0, Switch::Off));
    assert!((value_of(&session, slider) + 0.5).abs() < 1e-9);
    act(&mut session, Intent::Undo);
    act(&mut session, Intent::Undo);
    assert!((value_of(&session, slider) - 2.0).abs() < 1e-9);
    act(&mut session, Intent::Redo);
    assert!((value_of(&session, slider) - 1.5).abs() < 1e-9);
    assert!((value_of(&session, FaceSlider::ChinLength) + 3.0).abs() < 1e-9);
}

#[test]
fn a_slider_drag_equals_its_command() {
    let mut session = session();
    slide(&mut session, FaceSlider::JawWidth, 4.0);
    let entries = face(&session).document().history().entries();
    assert_eq!((entries.len(), entries[0].label.as_str()), (1, "jaw-width"));
    let mut applied = Document::new(Rest::of_face(face(&session).model())).unwrap();
    applied.set_density(face(&session).document().density()).unwrap();
    applied.apply("", FaceSlider::JawWidth.command(0.004)).unwrap();
    let dragged = positions(&session);
    assert!(dragged.iter().zip(applied.positions()).all(|(a, b)| a.distance(*b) < 1e-15));
    assert_ne!(bits(&dragged), bits(applied.rest()));
}

#[test]
fn cancelled_slider_drags_add_no_entry() {
    let mut session = session();
    let slider = FaceSlider::LipFullness;
    let rest = positions(&session);
    act(&mut session, Intent::Slide(slider, 2.0));
    assert!(session.tick().is_editing && (value_of(&session, slider) - 2.0).abs() < 1e-12);
    assert_ne!(positions(&session), rest);
    act(&mut session, Intent::Cancel);
    assert_eq!((positions(&session), value_of(&session, slider)), (rest.clone(), 0.0));
    act(&mut session, Intent::Slide(slider, 2.0));
    act(&mut session, Intent::Slide(slider, 0.0));
    act(&mut session, Intent::Commit);
    assert_eq!((state(&session).entry_count, positions(&session)), (0, rest));
}

#[test]
fn the_selection_is_prepared_again_after_a_slider() {
    let mut session = session();
    select(&mut session, Selection::Landmark(61));
    let document = face(&session).document();
    let (spec, influence) = (document.spec().cloned(), document.influence().cloned().unwrap());
    act(&mut session, Intent::Offset(DVec3::Y));
    slide(&mut session, FaceSlider::EyeSize, 1.0);
    let targets: Vec<EditTarget> = face(&session).rows().iter().map(|row| row.target).collect();
    assert_eq!(targets, [EditTarget::Landmark(61), EditTarget::Slider(FaceSlider::EyeSize)]);
    assert!(spec.is_some());
    assert_eq!(face(&session).document().spec().cloned(), spec);
    let fields = face(&session).influence_fields()[0].unwrap();
    assert_eq!(fields.len(), influence.direct.len());
    assert!(fields.iter().zip(influence.direct).all(|(now, before)| (now - before).abs() < 1e-12));
    assert_eq!(face(&session).committed_mm().y, 1.0);
}
