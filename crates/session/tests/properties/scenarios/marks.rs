use glam::{DVec2, DVec3};
use rosto_face::Region;
use rosto_session::{Intent, Selection, Session};
use rosto_stage::Visibility;
use rosto_studio::{FaceSlider, Switch};

use super::pointing::session;
use super::{act, displacement_mm, face, select};
use crate::faces::{detected, found};

const MOUTH_CORNER: u32 = 61;
const NOSE_TIP: u32 = 1;

#[test]
fn marks_are_shown_while_the_pointer_moves_and_fade_at_rest() {
    let mut session = session();
    select(&mut session, Selection::Landmark(NOSE_TIP));
    let rest = |session: &mut Session, from_ms: f64| {
        session.stage_mut().advance(from_ms);
        session.stage_mut().advance(from_ms + 1001.0);
        session.stage().tools_opacity()
    };
    assert_eq!((session.stage().tools_opacity(), rest(&mut session, 0.0)), (1.0, 0.0));
    let place_px = DVec2::new(300.0, 200.0);
    act(&mut session, Intent::Hover(Some(place_px)));
    assert_eq!((session.stage().tools_opacity(), rest(&mut session, 2e3)), (1.0, 0.0));
    act(&mut session, Intent::Hover(Some(place_px)));
    assert_eq!(session.stage().tools_opacity(), 0.0, "the pointer rests");
    act(&mut session, Intent::Offset(DVec3::Z));
    assert_eq!(rest(&mut session, 4e3), 1.0, "an edit is in progress");
    act(&mut session, Intent::Commit);
    assert_eq!(rest(&mut session, 6e3), 0.0);
}

#[test]
fn each_landmark_of_a_region_is_marked() {
    let mut session = session();
    select(&mut session, Selection::Region(Region::Nose));
    let marks = session.stage().mark_words();
    let is_marked = |vertex: &u32| marks.iter().any(|[marked, _]| marked == vertex);
    assert!(Region::Nose.vertices().iter().all(is_marked), "{marks:?}");
}

#[test]
fn pictures_and_comparisons_have_no_marks() {
    let mut session = session();
    select(&mut session, Selection::Landmark(MOUTH_CORNER));
    act(&mut session, Intent::Pin(Switch::On));
    act(&mut session, Intent::MarkAnchors(Switch::On));
    let marks = |session: &Session| session.stage().mark_words().len();
    let all = marks(&session);
    assert!(all > 30, "ring, pin, letters and outline: {all}");
    let clean = session.stage().without_tools();
    assert!(clean.mark_words().is_empty() && clean.gizmo().is_none());
    act(&mut session, Intent::MarkAnchors(Switch::Off));
    assert!((1..all).contains(&marks(&session)));
    for (begin, end) in [(Intent::Before(1.0), Intent::Before(0.0)), (Intent::Wipe(Some(0.4)), Intent::Wipe(None))] {
        act(&mut session, begin);
        assert_eq!((marks(&session), session.stage().gizmo()), (0, None));
        act(&mut session, end);
        assert!(marks(&session) > 0);
    }
    act(&mut session, Intent::Wipe(Some(0.4)));
    act(&mut session, Intent::Open(Box::new(found(detected()))));
    let settings = session.stage().render_settings();
    assert_eq!((settings.before, settings.wipe, face(&session).selection()), (0.0, None, None));
}

#[test]
fn the_rim_and_the_mirror_plane_are_drawn_during_an_edit() {
    let mut session = session();
    let drawn = |session: &Session| {
        let settings = session.stage().render_settings();
        (settings.rim == Visibility::Shown, settings.mirror_plane == Visibility::Shown)
    };
    select(&mut session, Selection::Landmark(NOSE_TIP));
    assert_eq!(drawn(&session), (false, false));
    act(&mut session, Intent::Offset(DVec3::Z));
    assert_eq!(drawn(&session), (true, true));
    let distances = face(&session).document().influence_distances().unwrap();
    let displacement_mm: Vec<f64> =
        (0..468).map(|v| displacement_mm(&session, face(&session).document().committed(), v).length()).collect();
    assert!(
        distances[NOSE_TIP as usize] == 0.0
            && distances
                .iter()
                .zip(&displacement_mm)
                .all(|(distance, displacement)| *distance < 1.0 || *displacement < 1e-6)
    );
    act(&mut session, Intent::Offset(DVec3::X));
    assert_eq!(drawn(&session), (true, false), "sideways the mirror is off");
    act(&mut session, Intent::Nearby(Switch::Off));
    assert_eq!(drawn(&session), (false, false));
    act(&mut session, Intent::Commit);
    act(&mut session, Intent::Slide(FaceSlider::NoseWidth, 1.0));
    assert!(!drawn(&session).0);
    act(&mut session, Intent::Commit);
    assert_eq!(drawn(&session), (false, false));
}
