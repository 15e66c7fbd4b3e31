//! The print panel, and the printed body on the stage.

use glam::DVec2;
use rosto_face::Triangulation;
use rosto_session::{BodyFacts, Control, Intent, Phrase, Report, Selection, Session, Tone, Value};
use rosto_stage::{Pointer, Scene, ShadingMode, Surface, Visibility};

use crate::faces::{SIZE_PX, detected, found, open, session};

const FACTS: BodyFacts = BodyFacts {
    volume_cm3: 20.0,
    size_mm: [60.0, 80.0, 50.0],
    asked_mm: 2.0,
    thinnest_mm: 2.0,
    thin_share: 0.0,
    moved_mm: 0.0,
    pla_grams: 18.0,
    is_upright: false,
    overhang_cm2: 0.0,
};

/// The text of a widget on the print panel, with its tone.
fn text(session: &Session, id: &str) -> (Option<Phrase>, Tone) {
    let panel = session.panel();
    let mut widgets: Vec<_> = panel.iter().collect();
    while let Some(widget) = widgets.pop() {
        if let (true, Control::Text { phrase, tone }) = (widget.id == id, &widget.control) {
            return (phrase.clone(), *tone);
        }
        widgets.extend(widget.children());
    }
    panic!("no text {id}");
}

fn measured(facts: BodyFacts) -> Session {
    let mut session = session();
    session.apply(Intent::Report(Report::BodyMeasured(Some(facts)))).unwrap();
    session
}

fn key(session: &Session, id: &str) -> Option<String> {
    text(session, id).0.map(|phrase| phrase.key.into_owned())
}

#[test]
fn a_wall_thinner_than_asked_does_not_pass_without_a_word() {
    assert_eq!(text(&measured(FACTS), "print.thin"), (None, Tone::Warning));
    for (thinnest_mm, thin) in [(1.7, "print.thin"), (0.6, "print.thin.fragile")] {
        let session = measured(BodyFacts { thinnest_mm, thin_share: 0.001, ..FACTS });
        assert_eq!(key(&session, "print.thin").unwrap(), thin);
    }
}

#[test]
fn the_panel_says_how_to_lay_the_print_and_whether_it_needs_supports() {
    for (is_upright, overhang_cm2, said) in [
        (false, 0.0, "print.lying"),
        (false, 12.0, "print.lying.supports"),
        (true, 0.0, "print.upright"),
        (true, 12.0, "print.upright.supports"),
    ] {
        let session = measured(BodyFacts { is_upright, overhang_cm2, ..FACTS });
        assert_eq!(key(&session, "print.supports").unwrap(), said);
    }
}

#[test]
fn a_height_is_that_of_a_button_or_of_the_slider() {
    let mut session = session();
    let height = |session: &Session| session.file_options().into_iter().find(|(id, _)| *id == "height-mm").unwrap().1;
    assert_eq!(height(&session), "80");
    for (id, value, now) in [
        ("print.height", Value::Text("life".into()), "life"),
        ("print.height", Value::Text("40".into()), "40"),
        ("print.height.mm", Value::Number(123.0), "123"),
    ] {
        session.apply(Intent::Set(id.into(), value)).unwrap();
        assert_eq!(height(&session), now);
    }
    assert!(session.apply(Intent::Set("print.height.mm".into(), Value::Number(5.0))).is_err());
    assert_eq!(height(&session), "123");
}

#[test]
fn a_displayed_print_has_no_marks_and_cannot_be_grabbed() {
    let mut session = session();
    session.apply(Intent::Shading(ShadingMode::Clay)).unwrap();
    session.apply(Intent::Select(Some(Selection::Landmark(1)))).unwrap();
    let before = session.stage().mark_words();
    let middle = DVec2::new(f64::from(SIZE_PX[0]), f64::from(SIZE_PX[1])) / 2.0;
    session.show_print(Visibility::Shown);
    assert_eq!(session.stage().render_settings().surface, Surface::Coloured);
    assert!(session.stage().mark_words().is_empty() && !before.is_empty());
    session.apply(Intent::Press(middle, Pointer::Fine)).unwrap();
    assert!(!session.has_grabbed(), "it turns the view");
    session.show_print(Visibility::Hidden);
    assert_eq!(session.stage().mark_words(), before);
    let settings = session.stage().render_settings();
    assert_eq!((settings.surface, settings.shading), (Surface::Shaded, ShadingMode::Clay));
}

#[test]
fn the_photo_and_another_face_end_the_display_of_a_print() {
    let mut session = session();
    for end in [Intent::Scene(Scene::Picture), Intent::Open(Box::new(found(detected()))), Intent::Close] {
        session.apply(Intent::Scene(Scene::Solid)).unwrap();
        session.show_print(Visibility::Shown);
        assert_eq!(session.view().print, Visibility::Shown, "{end:?}");
        session.apply(end.clone()).unwrap();
        assert_eq!(session.view().print, Visibility::Hidden, "{end:?}");
    }
    session.show_print(Visibility::Shown);
    assert_eq!(session.view().print, Visibility::Hidden, "no face is open");
    open(&mut session, found(detected()));
    session.apply(Intent::Triangulation(Triangulation::Tessellation)).unwrap();
    session.apply(Intent::Scene(Scene::Picture)).unwrap();
    session.show_print(Visibility::Shown);
    assert_eq!(session.view().print, Visibility::Hidden, "the photo is displayed");
}
