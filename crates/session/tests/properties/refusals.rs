//! What cannot be opened or done is refused with its reason, and leaves everything as it was.

use glam::{DVec2, DVec3};
use rosto_face::{FaceError, MAX_DENSITY, Triangulation};
use rosto_laplacian::LaplacianError;
use rosto_session::{
    DENSEST_SHOWN, Incoming, Intent, MAX_OFFSET_M, MOST_ENTRIES, RADIUS_MM, Selection, Session, SessionError, Work,
};
use rosto_stage::Light;
use rosto_studio::project::ProjectError;
use rosto_studio::{FaceSlider, StudioError, Switch};

use crate::faces::{found, session, worked_on};
use crate::invariants::{hold, hold_deeply, seen};

/// A session in which something was done, and something is being done.
fn busy() -> Session {
    let mut session = session();
    for intent in [
        Intent::Select(Some(Selection::Landmark(61))),
        Intent::Preview(DVec3::new(1.0, 2.0, 3.0)),
        Intent::Commit,
        Intent::Slide(FaceSlider::NoseWidth, 1.0),
        Intent::Commit,
        Intent::Undo,
        Intent::Preview(DVec3::Y),
    ] {
        session.apply(intent).unwrap();
    }
    session
}

/// Why an intent is refused, after making sure that nothing else came of it and that all goes on.
fn refusal(intent: Intent) -> SessionError {
    let mut session = busy();
    let before = (seen(&session), session.preferences(), session.under(), session.has_grabbed());
    let refusal = session.apply(intent).unwrap_err();
    assert!((seen(&session), session.preferences(), session.under(), session.has_grabbed()) == before, "{refusal}");
    hold(&session).unwrap();
    session.apply(Intent::Commit).unwrap();
    assert_eq!(session.state().face.unwrap().entry_count, 2);
    hold_deeply(&session).unwrap();
    refusal
}

fn refusal_to_open(incoming: Incoming) -> SessionError {
    refusal(Intent::Open(Box::new(incoming)))
}

/// Why work with that history is not opened.
fn refusal_of(history: &str) -> SessionError {
    refusal_to_open(worked_on(history, Triangulation::Canonical, 0))
}

/// A history of entries; the first is fine.
fn history(entries: &[String]) -> String {
    let fine = moved(0, 4, "[0, 0, 0.001]");
    let entries: Vec<&str> = [fine.as_str()].into_iter().chain(entries.iter().map(String::as_str)).collect();
    format!(r#"{{"rosto": "history", "version": 1, "entries": [{}]}}"#, entries.join(","))
}

fn moved(level: u32, vertex: u32, offset_m: &str) -> String {
    format!(
        r#"{{"label": "a", "switch": "on", "move": {{"level": {level}, "handles": [{vertex}], "offsets": [{offset_m}],
        "operator": "L_s", "constraint": {{"soft": 1}}, "anchors": {{"kind": "oval", "pins": []}}, "influence": "whole",
        "mirror": "off", "details": "kept"}}}}"#
    )
}

#[test]
fn the_history_that_the_refused_ones_differ_from_is_opened() {
    let mut session = busy();
    let fine = worked_on(&history(&[moved(0, 152, "[0, 0, 0.5]")]), Triangulation::Canonical, 0);
    session.apply(Intent::Open(Box::new(fine))).unwrap();
    assert_eq!(session.state().face.unwrap().entry_count, 2);
}

#[test]
fn a_history_of_another_version_is_refused() {
    let other = ProjectError::Version { found: 2, known: 1 };
    assert_eq!(refusal_of(&history(&[]).replace(r#""version": 1"#, r#""version": 2"#)), other.into());
}

#[test]
fn offsets_that_are_no_numbers_are_refused() {
    for offset in ["null", "[null, null, null]", "[0, 0]", "[0, 0, \"far\"]", "[]"] {
        let missing = ProjectError::Field { entry: 1, field: "offsets" };
        assert_eq!(refusal_of(&history(&[moved(0, 152, offset)])), missing.into(), "{offset}");
    }
}

#[test]
fn offsets_beyond_every_face_are_refused() {
    for offset in ["[0, 1e30, 0]", "[1e308, 1e308, 1e308]", "[0, 0, -0.5001]"] {
        match refusal_of(&history(&[moved(0, 152, offset)])) {
            SessionError::BadHistory { entry: 1, distance_m, most_m } => {
                assert!(distance_m > most_m && most_m == MAX_OFFSET_M, "{distance_m}");
            }
            other => panic!("{offset}: {other}"),
        }
    }
}

#[test]
fn an_offset_beyond_every_face_is_refused_of_each_handle_and_while_switched_off() {
    let far = moved(0, 152, "[0, 0, 0], [0, 1e30, 0]").replace("[152]", "[152, 61]");
    for entry in [far.clone(), far.replace(r#""on""#, r#""off""#)] {
        assert!(matches!(refusal_of(&history(&[entry])), SessionError::BadHistory { entry: 1, .. }));
    }
}

#[test]
fn a_history_without_entries_is_refused() {
    let entries = [
        "",
        "{}",
        "null",
        "edits",
        r#"{"rosto": "history"}"#,
        r#"{"rosto": "history", "version": 1}"#,
        r#"{"rosto": "history", "version": 1, "entries": {}}"#,
        r#"{"rosto": "history", "version": "1", "entries": []}"#,
        r#"{"version": 1, "entries": []}"#,
    ];
    for text in entries {
        assert_eq!(refusal_of(text), ProjectError::NotAHistory.into(), "{text}");
    }
}

#[test]
fn entries_for_meshes_that_there_are_not_are_refused() {
    let unknown = |level, vertex| match refusal_of(&history(&[moved(level, vertex, "[0, 0, 0.001]")])) {
        SessionError::Studio(StudioError::Entry { index: 1, reason }) => *reason,
        other => panic!("level {level}, vertex {vertex}: {other}"),
    };
    assert_eq!(unknown(5, 4), StudioError::TooDense { level: 5, most: MAX_DENSITY });
    for vertex in [468, 9_999] {
        assert_eq!(unknown(0, vertex), LaplacianError::NoSuchVertex { vertex, vertex_count: 468 }.into());
    }
}

#[test]
fn landmarks_without_size_are_no_face() {
    let nowhere = Incoming { landmarks: vec![[0.5; 3]; 468], ..found() };
    assert_eq!(refusal_to_open(nowhere.clone()), FaceError::Degenerate.into());
    let worked_on = worked_on(&history(&[]), Triangulation::Canonical, 0);
    assert_eq!(refusal_to_open(Incoming { work: worked_on.work, ..nowhere }), FaceError::Degenerate.into());
    let mut infinite = found();
    infinite.landmarks[7][1] = f32::NAN;
    assert_eq!(refusal_to_open(infinite), FaceError::NotFinite { landmark: 7 }.into());
}

#[test]
fn too_few_landmarks_or_colours_are_no_face() {
    let mut few = found();
    few.landmarks.pop();
    let counted = |what| FaceError::WrongCount { what, expected: 468, found: 467 };
    assert_eq!(refusal_to_open(few), counted("landmarks").into());
    let mut pale = found();
    pale.colours_srgb.pop();
    assert_eq!(refusal_to_open(pale), counted("colours").into());
}

#[test]
fn a_photo_without_area_is_refused() {
    for photo_size_px in [[0, 64], [64, 0], [0, 0]] {
        let [width, height] = photo_size_px;
        let empty = FaceError::EmptyPicture { width, height };
        assert_eq!(refusal_to_open(Incoming { photo_size_px, ..found() }), empty.into());
    }
}

#[test]
fn a_density_that_there_is_not_is_refused() {
    for density in [5, 9, u32::MAX] {
        let work = Work { triangulation: Triangulation::Canonical, density, history: history(&[]), photo: None };
        let refusal = refusal_to_open(Incoming { work: Some(work), ..found() });
        let (least, most) = (0.0, MAX_DENSITY.into());
        assert_eq!(refusal, SessionError::OutOfRange { what: "the density", value: density.into(), least, most });
    }
}

#[test]
fn a_history_that_is_too_long_is_refused() {
    let mirrored = r#"{"label": "a", "switch": "off", "symmetrise": {"share": 0.5}}"#.to_owned();
    let long = history(&vec![mirrored; MOST_ENTRIES]);
    let refused = SessionError::TooManyEntries { found: MOST_ENTRIES + 1, most: MOST_ENTRIES };
    assert_eq!(refusal_of(&long), refused);
}

/// The number that is refused, and between which it must lie.
fn out_of_range(intent: Intent) -> (f64, [f64; 2]) {
    let asked = format!("{intent:?}");
    match refusal(intent) {
        SessionError::OutOfRange { value, least, most, .. } => (value, [least, most]),
        other => panic!("{asked}: {other}"),
    }
}

/// Equal, or both no number.
fn is_same(one: f64, other: f64) -> bool {
    one == other || (one.is_nan() && other.is_nan())
}

#[test]
fn an_offset_further_than_any_hand_goes_is_refused() {
    for value in [501.0, -501.0, 1e308, f64::INFINITY, f64::NAN] {
        for axis in DVec3::AXES {
            let offset_mm = DVec3::select(axis.cmpgt(DVec3::ZERO), DVec3::splat(value), DVec3::ONE);
            let (refused, range) = out_of_range(Intent::Preview(offset_mm));
            assert!(is_same(refused, value) && range == [-500.0, 500.0], "{offset_mm}");
        }
    }
}

#[test]
fn a_radius_out_of_its_range_is_refused() {
    for value in [4.0, 121.0, -40.0, f64::NAN, f64::INFINITY] {
        let (refused, range) = out_of_range(Intent::Radius(value));
        assert!(is_same(refused, value) && range == [RADIUS_MM.least, RADIUS_MM.most], "{value}");
    }
    assert!(out_of_range(Intent::Widen(f64::NAN)).0.is_nan());
}

#[test]
fn a_slider_goes_no_further_than_its_range() {
    for slider in FaceSlider::ALL {
        let most_mm = slider.range_m() * 1000.0;
        for value in [most_mm + 0.1, -most_mm - 0.1, f64::NAN, f64::INFINITY] {
            let (refused, [least, most]) = out_of_range(Intent::Slide(slider, value));
            assert!(is_same(refused, value) && (most - most_mm).abs() < 1e-6 && least == -most, "{slider:?}");
        }
    }
}

#[test]
fn shares_beyond_the_whole_are_refused() {
    for value in [1.5, -0.1, f64::NAN] {
        for intent in [Intent::Symmetrise(value), Intent::Before(value)] {
            let (refused, range) = out_of_range(intent);
            assert!(is_same(refused, value) && range == [0.0, 1.0], "{value}");
        }
    }
}

#[test]
fn a_mesh_denser_than_any_on_the_screen_is_refused() {
    for density in [4, u32::MAX] {
        assert_eq!(out_of_range(Intent::Density(density)), (density.into(), [0.0, DENSEST_SHOWN.into()]));
    }
}

#[test]
fn numbers_that_show_nothing_are_refused() {
    for intent in [
        Intent::Zoom(f64::NAN),
        Intent::Resize([800, 600], f64::NAN),
        Intent::Resize([800, 600], 0.0),
        Intent::Wipe(Some(1.5)),
        Intent::Wipe(Some(f64::NAN)),
        Intent::Light(Light { strength: f64::NAN, ..Light::default() }),
        Intent::Light(Light { elevation_deg: 91.0, ..Light::default() }),
    ] {
        out_of_range(intent);
    }
}

#[test]
fn vertices_that_there_are_not_are_refused() {
    let point = |level, vertex| Intent::Select(Some(Selection::Point { level, vertex }));
    for (intent, vertex, count) in [
        (Intent::Select(Some(Selection::Landmark(468))), 468, 468),
        (Intent::SelectAt(9_999), 9_999, 468),
        (Intent::SelectAt(u32::MAX), u32::MAX, 468),
        (Intent::PointAt(Some(468)), 468, 468),
        (point(0, 4), 4, 0),
        (point(1, 4), 4, 0),
    ] {
        assert_eq!(refusal(intent.clone()), SessionError::NoSuchVertex { vertex, count }, "{intent:?}");
    }
}

#[test]
fn entries_that_there_are_not_are_refused() {
    let missing = StudioError::NoSuchEntry { index: 1, count: 1 };
    assert_eq!(refusal(Intent::Switch(1, Switch::Off)), missing.into());
}

#[test]
fn without_a_face_nothing_is_edited_and_without_a_selection_nothing_is_pinned() {
    let mut session = Session::new(1);
    for intent in [
        Intent::Select(Some(Selection::Landmark(1))),
        Intent::Pin(Switch::On),
        Intent::Slide(FaceSlider::NoseWidth, 1.0),
        Intent::Symmetrise(0.5),
        Intent::ResetSelected,
        Intent::Switch(0, Switch::Off),
    ] {
        assert_eq!(session.apply(intent), Err(SessionError::NoFace));
    }
    session.apply(Intent::Hover(Some(DVec2::splat(160.0)))).unwrap();
    assert_eq!((session.under().vertex, session.state()), (None, Session::new(2).state()));
    let mut session = crate::faces::session();
    for intent in [Intent::Pin(Switch::On), Intent::ResetSelected] {
        assert_eq!(session.apply(intent), Err(SessionError::NothingSelected));
    }
}
