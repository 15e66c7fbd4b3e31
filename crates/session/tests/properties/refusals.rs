//! Invalid files and intents are refused with a reason and leave the session unchanged.

use glam::{DVec2, DVec3};
use rosto::SavedFace;
use rosto_face::{FaceError, MAX_DENSITY, Observation, Triangulation};
use rosto_laplacian::LaplacianError;
use rosto_session::{Intent, MAX_OFFSET_M, MAX_SHOWN_DENSITY, RADIUS_MM, Selection, Session, SessionError};
use rosto_stage::Light;
use rosto_studio::project::ProjectError;
use rosto_studio::{FaceSlider, MAX_ENTRIES, StudioError, Switch};

use crate::faces::{detected, found, session, with_history};
use crate::invariants::{check, check_thoroughly, seen};

/// A session with a history and an edit in progress.
fn edited_session() -> Session {
    let mut session = session();
    for intent in [
        Intent::Select(Some(Selection::Landmark(61))),
        Intent::Offset(DVec3::new(1.0, 2.0, 3.0)),
        Intent::Commit,
        Intent::Slide(FaceSlider::NoseWidth, 1.0),
        Intent::Commit,
        Intent::Undo,
        Intent::Offset(DVec3::Y),
    ] {
        session.apply(intent).unwrap();
    }
    session
}

/// Reason for the refusal of an intent, after checking that the session is unchanged and usable.
fn refusal(intent: Intent) -> SessionError {
    let mut session = edited_session();
    let before = (seen(&session), session.preferences(), session.hovered(), session.has_grabbed());
    let refusal = session.apply(intent).unwrap_err();
    assert!((seen(&session), session.preferences(), session.hovered(), session.has_grabbed()) == before, "{refusal}");
    check(&session).unwrap();
    session.apply(Intent::Commit).unwrap();
    assert_eq!(session.state().entry_count, 2);
    check_thoroughly(&session).unwrap();
    refusal
}

fn refusal_to_open(face: SavedFace) -> SessionError {
    refusal(Intent::Open(Box::new(face)))
}

/// Reason for the refusal of a photo.
fn refusal_of_photo(photo: Observation) -> FaceError {
    match refusal_to_open(found(photo)) {
        SessionError::Face(FaceError::InPhoto { photo: 0, reason }) => *reason,
        other => panic!("{other}"),
    }
}

/// Reason for the refusal of a history.
fn refusal_of(history: &str) -> SessionError {
    refusal_to_open(with_history(history, Triangulation::Canonical, 0))
}

/// A history of a valid entry and the given ones.
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
fn the_valid_history_is_opened() {
    let mut session = edited_session();
    let fine = with_history(&history(&[moved(0, 152, "[0, 0, 0.5]")]), Triangulation::Canonical, 0);
    session.apply(Intent::Open(Box::new(fine))).unwrap();
    assert_eq!(session.state().entry_count, 2);
}

#[test]
fn a_history_of_another_version_is_refused() {
    let other = ProjectError::Version { found: 2, known: 1 };
    assert_eq!(refusal_of(&history(&[]).replace(r#""version": 1"#, r#""version": 2"#)), other.into());
}

#[test]
fn invalid_offsets_are_refused() {
    for offset in ["null", "[null, null, null]", "[0, 0]", "[0, 0, \"far\"]", "[]"] {
        let missing = ProjectError::Field { entry: 1, field: "offsets" };
        assert_eq!(refusal_of(&history(&[moved(0, 152, offset)])), missing.into(), "{offset}");
    }
}

#[test]
fn offsets_beyond_the_maximum_are_refused() {
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
fn offsets_of_each_handle_are_checked_on_or_off() {
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
fn entries_for_nonexistent_meshes_are_refused() {
    let unknown = |level, vertex| match refusal_of(&history(&[moved(level, vertex, "[0, 0, 0.001]")])) {
        SessionError::Studio(StudioError::Entry { index: 1, reason }) => *reason,
        other => panic!("level {level}, vertex {vertex}: {other}"),
    };
    assert_eq!(unknown(5, 4), StudioError::TooDense { level: 5, max: MAX_DENSITY });
    for vertex in [468, 9_999] {
        assert_eq!(unknown(0, vertex), LaplacianError::NoSuchVertex { vertex, vertex_count: 468 }.into());
    }
}

#[test]
fn degenerate_landmarks_are_refused() {
    let nowhere = Observation { landmarks: vec![[0.5; 3]; 468], ..detected() };
    assert_eq!(refusal_of_photo(nowhere.clone()), FaceError::Degenerate);
    let with_history = with_history(&history(&[]), Triangulation::Canonical, 0);
    let refusal = refusal_to_open(SavedFace { photos: vec![nowhere], ..with_history });
    assert_eq!(refusal, FaceError::InPhoto { photo: 0, reason: Box::new(FaceError::Degenerate) }.into());
    let mut infinite = detected();
    infinite.landmarks[7][1] = f32::NAN;
    assert_eq!(refusal_of_photo(infinite), FaceError::NotFinite { landmark: 7 });
}

#[test]
fn missing_landmarks_or_colours_are_refused() {
    let mut few = detected();
    few.landmarks.pop();
    let counted = |what| FaceError::WrongCount { what, expected: 468, found: 467 };
    assert_eq!(refusal_of_photo(few), counted("landmarks"));
    let mut pale = detected();
    pale.colours_srgb.pop();
    assert_eq!(refusal_of_photo(pale), counted("colours"));
}

#[test]
fn a_photo_without_area_is_refused() {
    for photo_size_px in [[0, 64], [64, 0], [0, 0]] {
        let [width, height] = photo_size_px;
        let empty = FaceError::EmptyPicture { width, height };
        assert_eq!(refusal_of_photo(Observation { photo_size_px, ..detected() }), empty);
    }
}

#[test]
fn a_density_beyond_the_maximum_is_refused() {
    for density in [5, 9, u32::MAX] {
        let refusal = refusal_to_open(with_history(&history(&[]), Triangulation::Canonical, density));
        let (min, max) = (0.0, MAX_DENSITY.into());
        assert_eq!(refusal, SessionError::OutOfRange { what: "the density", value: density.into(), min, max });
    }
}

#[test]
fn a_history_that_is_too_long_is_refused() {
    let mirrored = r#"{"label": "a", "switch": "off", "symmetrise": {"share": 0.5}}"#.to_owned();
    let long = history(&vec![mirrored; MAX_ENTRIES]);
    let refused = ProjectError::TooManyEntries { found: MAX_ENTRIES + 1, max: MAX_ENTRIES };
    assert_eq!(refusal_of(&long), refused.into());
}

/// The refused number and its range.
fn out_of_range(intent: Intent) -> (f64, [f64; 2]) {
    let asked = format!("{intent:?}");
    match refusal(intent) {
        SessionError::OutOfRange { value, min, max, .. } => (value, [min, max]),
        other => panic!("{asked}: {other}"),
    }
}

/// Equal, or both NaN.
fn is_same(one: f64, other: f64) -> bool {
    one == other || (one.is_nan() && other.is_nan())
}

#[test]
fn previews_beyond_the_maximum_offset_are_refused() {
    for value in [501.0, -501.0, 1e308, f64::INFINITY, f64::NAN] {
        for axis in DVec3::AXES {
            let offset_mm = DVec3::select(axis.cmpgt(DVec3::ZERO), DVec3::splat(value), DVec3::ONE);
            let (refused, range) = out_of_range(Intent::Offset(offset_mm));
            assert!(is_same(refused, value) && range == [-500.0, 500.0], "{offset_mm}");
        }
    }
}

#[test]
fn a_radius_out_of_its_range_is_refused() {
    for value in [4.0, 121.0, -40.0, f64::NAN, f64::INFINITY] {
        let (refused, range) = out_of_range(Intent::Radius(value));
        assert!(is_same(refused, value) && range == [RADIUS_MM.min, RADIUS_MM.max], "{value}");
    }
}

#[test]
fn slider_values_outside_the_range_are_refused() {
    for slider in FaceSlider::ALL {
        let max_mm = slider.range_m() * 1000.0;
        for value in [max_mm + 0.1, -max_mm - 0.1, f64::NAN, f64::INFINITY] {
            let (refused, [min, max]) = out_of_range(Intent::Slide(slider, value));
            assert!(is_same(refused, value) && (max - max_mm).abs() < 1e-6 && min == -max, "{slider:?}");
        }
    }
}

#[test]
fn shares_outside_0_to_1_are_refused() {
    for value in [1.5, -0.1, f64::NAN] {
        for intent in [Intent::Symmetrise(value), Intent::Before(value)] {
            let (refused, range) = out_of_range(intent);
            assert!(is_same(refused, value) && range == [0.0, 1.0], "{value}");
        }
    }
}

#[test]
fn densities_beyond_the_screens_maximum_are_refused() {
    for density in [4, u32::MAX] {
        assert_eq!(out_of_range(Intent::Density(density)), (density.into(), [0.0, MAX_SHOWN_DENSITY.into()]));
    }
}

#[test]
fn invalid_view_parameters_are_refused() {
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
fn nonexistent_vertices_are_refused() {
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
fn nonexistent_entries_are_refused() {
    let missing = StudioError::NoSuchEntry { index: 1, count: 1 };
    assert_eq!(refusal(Intent::Switch(1, Switch::Off)), missing.into());
}

#[test]
fn edits_need_a_face_and_pins_need_a_selection() {
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
    assert_eq!((session.hovered().vertex, session.state()), (None, Session::new(2).state()));
    let mut session = crate::faces::session();
    for intent in [Intent::Pin(Switch::On), Intent::ResetSelected] {
        assert_eq!(session.apply(intent), Err(SessionError::NothingSelected));
    }
}
