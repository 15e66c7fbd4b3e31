use glam::DVec3;
use rosto::{BaseColour, EditsAs, FaceMesh, FileOptions, Format, Print, SolidFacts};
use rosto_face::{Photo, Triangulation};
use rosto_session::{Intent, Motion, Preset, Selection, SelectionMode, Session, SessionError, Turntable};
use rosto_stage::{Background, Dots, Lens, Light, PictureLight, ShadingMode, Srgb, Visibility};
use rosto_studio::{
    Anchors, Command, Details, EditSpec, Entry, EntryStatus, FaceSlider, Mirror, SMOOTH_DENSITY, Settings, Switch,
    project,
};
use serde_json::Value;

use super::{act, face, move_by, position_px, positions, select, state};
use crate::faces::{detected, found, open, saved, session, with_history};
use crate::invariants::{check, check_thoroughly, seen};

fn file_options() -> FileOptions {
    FileOptions { base_colour: BaseColour::Photo, edits: EditsAs::MorphTargets, ..FileOptions::default() }
}

/// The face as the worker writes it.
fn mesh(session: &Session) -> FaceMesh {
    let mut saved = saved(session);
    saved.photos[0].picture = Photo::from_rgb(1, 1, vec![180, 120, 90]).ok();
    FaceMesh::reopen(saved).unwrap()
}

/// Sets each setting to another value than the default.
fn change_settings(session: &mut Session) {
    let light = Light { azimuth_deg: -30.0, strength: 0.75, colour: Srgb([200, 190, 180]), ..Light::default() };
    for intent in [
        Intent::Mode(SelectionMode::Region),
        Intent::Preset(Preset::Paper),
        Intent::Details(Details::AsRigidAsPossible),
        Intent::Mirror(Mirror::On),
        Intent::Radius(33.0),
        Intent::Shading(ShadingMode::Clay),
        Intent::Lens(Lens::Near),
        Intent::Wireframe(Visibility::Hidden),
        Intent::Background(Background::Plain(Srgb([1, 2, 3]))),
        Intent::Turntable(Turntable::Turns),
        Intent::Dots(Dots::All),
        Intent::Light(light),
        Intent::PictureLight(PictureLight::Lamp),
        Intent::MarkAnchors(Switch::On),
        Intent::Triangulation(Triangulation::Tessellation),
        Intent::Density(1),
    ] {
        act(session, intent);
    }
}

#[test]
fn settings_and_view_are_restored_in_another_session() {
    let mut one = Session::new(1);
    change_settings(&mut one);
    let mut other = Session::new(2);
    assert_ne!(other.state(), one.state());
    act(&mut other, Intent::RestorePreferences(one.preferences()));
    assert_eq!(other.state(), one.state());
    assert_eq!(other.preferences(), one.preferences());
    open(&mut other, found(detected()));
    let shown = (face(&other).triangulation(), face(&other).document().density());
    assert_eq!(shown, (Triangulation::Tessellation, 1), "preferences apply to the next face");
    let mut usual = Session::new(3);
    act(&mut usual, Intent::RestorePreferences(Session::new(4).preferences()));
    assert_eq!(usual.state(), Session::new(5).state());
}

#[test]
fn an_open_face_keeps_its_mesh_under_restored_preferences() {
    let mut one = Session::new(1);
    act(&mut one, Intent::Motion(Motion::Reduced));
    change_settings(&mut one);
    let mut other = session();
    select(&mut other, Selection::Landmark(4));
    act(&mut other, Intent::Offset(DVec3::Z));
    act(&mut other, Intent::RestorePreferences(one.preferences()));
    let (wanted, now) = (one.state(), other.state());
    assert_eq!((other.mode(), other.edit_options()), (one.mode(), one.edit_options()));
    let [settings, wanted_settings] = [&other, &one].map(|session| session.stage().render_settings());
    assert_eq!((now.light, settings.dots), (wanted.light, wanted_settings.dots));
    assert_eq!(settings.shading, ShadingMode::Clay);
    assert_eq!((face(&other).triangulation(), other.density()), (Triangulation::Canonical, SMOOTH_DENSITY));
    assert!(matches!(face(&other).selection(), Some(Selection::Region(_))), "the selection follows the mode");
    assert_eq!((now.vertex_count, now.entry_count), (7_257, 1), "the edit in progress is committed");
    check_thoroughly(&other).unwrap();
}

#[test]
fn damaged_preferences_are_refused() {
    let mut session = session();
    select(&mut session, Selection::Landmark(4));
    act(&mut session, Intent::Offset(DVec3::Z));
    let (before, usual) = (seen(&session), session.preferences());
    let mut otherwise = Session::new(1);
    change_settings(&mut otherwise);
    let text = otherwise.preferences();
    let mut refused = |damaged: String| {
        let refusal = session.apply(Intent::RestorePreferences(damaged.clone()));
        let is_known = matches!(refusal, Err(SessionError::Preferences { .. } | SessionError::OutOfRange { .. }));
        assert!(is_known, "{damaged}: {refusal:?}");
        assert_eq!((seen(&session), session.preferences()), (before.clone(), usual.clone()), "{damaged}");
    };
    for damaged in ["", "{}", "[]", "null", "7", &text[..text.len() / 2], &text.replace("33", "1e9")] {
        refused(damaged.to_owned());
    }
    let Ok(Value::Object(whole)) = serde_json::from_str(&text) else { panic!("an object") };
    for field in whole.keys() {
        let mut without = whole.clone();
        without.remove(field);
        refused(Value::Object(without.clone()).to_string());
        for damaged in [Value::Null, Value::from("mud"), Value::from(-1e300), Value::from(vec![1e300; 4])] {
            without.insert(field.clone(), damaged);
            refused(Value::Object(without.clone()).to_string());
        }
    }
}

/// An edit of a mesh denser than the screen's maximum, as the command line can write.
fn dense_history() -> String {
    let settings = Settings { anchors: Anchors::default(), ..Settings::default() };
    let spec = EditSpec { level: 4, handles: vec![20_000], settings };
    let command = Command::Move { spec, offsets: vec![DVec3::new(0.0, 0.0, 0.004)] };
    project::to_json(&[Entry { label: "dense".to_owned(), command, switch: Switch::On }])
}

#[test]
fn edits_of_a_denser_mesh_open_as_waiting_entries() {
    let mut session = session();
    open(&mut session, with_history(&dense_history(), Triangulation::Canonical, 4));
    assert_eq!((session.density(), face(&session).document().density()), (3, 3));
    assert_eq!(face(&session).rows()[0].status, EntryStatus::Waits { level: 4 });
    assert_eq!(positions(&session), face(&session).document().rest());
    assert_eq!(face(&session).rows()[0].target.to_string(), "point-20000@4");
    exercise(&mut session);
    assert_eq!(face(&session).rows()[0].status, EntryStatus::Waits { level: 4 });
    check_thoroughly(&session).unwrap();
    let saved = face(&session).history_json();
    open(&mut session, with_history(&saved, Triangulation::Canonical, 4));
    assert_eq!(face(&session).history_json(), saved);
}

/// Exercises selecting, moving, undo, switching, pointing, saving and densities.
fn exercise(session: &mut Session) {
    select(session, Selection::Landmark(4));
    move_by(session, DVec3::Z * 2.0);
    act(session, Intent::Slide(FaceSlider::NoseWidth, 1.0));
    act(session, Intent::Commit);
    assert_eq!(state(session).entry_count, 3);
    let edited = positions(session);
    for (intent, same) in [
        (Intent::Undo, false),
        (Intent::Redo, true),
        (Intent::Switch(0, Switch::Off), true),
        (Intent::Switch(0, Switch::On), true),
        (Intent::Switch(1, Switch::Off), false),
        (Intent::Switch(1, Switch::On), true),
    ] {
        act(session, intent.clone());
        assert_eq!(positions(session) == edited, same, "{intent:?}");
        check(session).unwrap();
    }
    let nose = position_px(session, 4);
    act(session, Intent::Hover(Some(nose)));
    assert_eq!(session.hovered().vertex, Some(4));
    act(session, Intent::Density(1));
    let mut mesh = mesh(session);
    assert_eq!(mesh.positions(), positions(session), "to the last bit");
    for format in Format::ALL {
        let written = mesh.write(format, &file_options(), "face").unwrap();
        let bundled = written.clone().bundled("face", format);
        // The PNG is only as large as the part of the photo that shows the face.
        let min_bytes = if format == Format::Png { 100 } else { 20_000 };
        assert!(bundled.len() > min_bytes, "{format:?}");
        assert_eq!(written.sidecars.is_empty(), format.bundle_extension(BaseColour::Photo) == format.id());
        assert_eq!(written.sidecars.is_empty(), bundled == written.bytes);
        let print = Print::default();
        let facts = mesh.printed(print).unwrap().map(|printed| SolidFacts::of(&printed.body, print.solid));
        assert!(written.solid.is_none() || written.solid == facts);
    }
    for density in [0, 1, 3] {
        act(session, Intent::Density(density));
        check(session).unwrap();
    }
    assert_eq!(positions(session), edited);
}
