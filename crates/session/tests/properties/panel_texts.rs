//! The text of the panels after actions of a user.

use glam::DVec3;
use rosto_face::Triangulation;
use rosto_session::{Choice, Control, GroupLook, Intent, Outcome, Report, Selection, SelectionMode, Session, Value};
use rosto_stage::Scene;
use rosto_studio::FaceSlider;

use crate::faces::{bits, session};
use crate::rendering::{label, shown, technical, text, widget, words};

const NOSE_TIP: u32 = 1;
const CHIN: u32 = 152;
/// Outer ends of the nose's wings.
const WINGS: [usize; 2] = [64, 294];

fn act(session: &mut Session, intent: Intent) {
    session.apply(intent).unwrap();
}

fn set(session: &mut Session, id: &str, value: Value) {
    act(session, Intent::Set(id.to_owned(), value));
}

fn push(session: &mut Session, id: &str) {
    act(session, Intent::Push(id.to_owned()));
}

fn select(session: &mut Session, landmark: u32) {
    act(session, Intent::Select(Some(Selection::Landmark(landmark))));
}

fn slide(session: &mut Session, slider: FaceSlider, to_mm: f64) {
    act(session, Intent::Slide(slider, to_mm));
    act(session, Intent::Commit);
}

/// Moves the selection to an offset, as one entry.
fn offset(session: &mut Session, offset_mm: DVec3) {
    act(session, Intent::Offset(offset_mm));
    act(session, Intent::Commit);
}

fn positions(session: &Session) -> Vec<DVec3> {
    session.face().unwrap().document().positions().to_vec()
}

fn is_hidden(session: &Session, id: &str) -> bool {
    widget(session, id).is_hidden
}

/// The texts of the listed edits, latest first.
fn history(session: &Session) -> Vec<String> {
    shown(session, "history").lines().skip(1).map(|line| line.trim().to_owned()).collect()
}

#[test]
fn the_shape_tab_leads_from_editing_by_hand_to_expert_settings() {
    let panel = session().panel();
    let headings = |language| -> Vec<String> {
        let is_heading =
            |control: &Control| matches!(control, Control::Group { look: GroupLook::Section, tab: Some("shape"), .. });
        panel
            .iter()
            .filter(|widget| is_heading(&widget.control))
            .map(|widget| label(&words(language), widget))
            .collect()
    };
    assert_eq!(headings("en"), ["Move by hand", "Expressions", "In the photo", "History", "Expert settings"]);
    assert_eq!(headings("pt"), ["Mover à mão", "Expressões", "Na foto", "Histórico", "Ajustes avançados"]);
    let settings = shown(&session(), "section.advanced");
    for line in ["Smoothing method", "Point and fixed points", "Direction of details", "Research paper"] {
        assert!(settings.contains(line), "no {line:?} in\n{settings}");
    }
}

#[test]
fn technical_controls_are_for_experts() {
    let technical = technical(&session());
    for id in
        ["preset", "section.advanced", "density", "export.density", "export.morphs", "export.units", "download-json"]
    {
        assert!(technical.iter().any(|one| one == id), "{id} is for everyone");
    }
    for id in ["shape", "slider.nose-width", "landmark.offset", "landmark.more", "looks", "triangulation", "check-glb"]
    {
        assert!(!technical.iter().any(|one| one == id), "{id} is only for experts");
    }
    let Control::Choice { expert, .. } = widget(&session(), "shading").control else { panic!("no choice") };
    assert_eq!(expert, ["normals", "response", "distortion"]);
}

#[test]
fn experts_see_the_numbers_of_points() {
    let mut session = session();
    select(&mut session, NOSE_TIP);
    offset(&mut session, DVec3::Z * 4.0);
    for (is_expert, name) in [(false, "nose tip"), (true, "nose tip · 1"), (false, "nose tip")] {
        act(&mut session, Intent::Expert(is_expert));
        assert_eq!(history(&session), [format!("[x] {name} (4.0 mm)")]);
        assert_eq!(text(&words("en"), &session.state().name.unwrap()), name);
    }
}

#[test]
fn technical_choices_stay_in_effect_for_other_users() {
    let mut session = session();
    act(&mut session, Intent::Expert(true));
    for (id, value) in [("preset", "paper"), ("shading", "response")] {
        set(&mut session, id, Value::Text(value.into()));
    }
    act(&mut session, Intent::Expert(false));
    select(&mut session, NOSE_TIP);
    assert_eq!(session.state().anchors.len(), 2);
    assert_eq!(session.chosen(Choice::Shading).as_deref(), Some("response"));
}

#[test]
fn other_edit_settings_match_no_preset() {
    let mut session = session();
    assert!(shown(&session, "preset").contains(": Sculpt of Sculpt, Research paper"));
    set(&mut session, "preset", Value::Text("paper".into()));
    set(&mut session, "edit.mirror", Value::Flag(true));
    assert!(shown(&session, "preset").contains(":  of Sculpt, Research paper"));
    set(&mut session, "preset", Value::Text("sculpt".into()));
    assert!(shown(&session, "preset").contains(": Sculpt of"));
}

#[test]
fn an_offset_along_one_axis_does_not_round_the_others() {
    let mut session = session();
    select(&mut session, 61);
    offset(&mut session, DVec3::new(1.234_567, 0.0, -0.987_654));
    set(&mut session, "landmark.y", Value::Number(5.0));
    let off_mm = DVec3::from(session.state().offset_mm).distance(DVec3::new(1.234_567, 5.0, -0.987_654));
    assert!(off_mm < 1e-9, "{off_mm}");
}

#[test]
fn the_selection_is_reset_in_one_step_that_can_be_undone() {
    let mut session = session();
    select(&mut session, CHIN);
    offset(&mut session, DVec3::Y * -6.0);
    let chin = positions(&session);
    set(&mut session, "selection", Value::Text("region".into()));
    set(&mut session, "region", Value::Text("nose".into()));
    assert!(!widget(&session, "reset.one").is_enabled);
    offset(&mut session, DVec3::Z * 4.0);
    offset(&mut session, DVec3::new(0.0, 2.0, 4.0));
    let both = positions(&session);
    let said = session.answer(Intent::Push("reset.one".into())).unwrap().said.unwrap();
    assert_eq!(text(&words("en"), &said), "Edits of nose undone");
    assert_eq!(bits(&positions(&session)), bits(&chin));
    assert!(shown(&session, "landmark.z").ends_with(": 0.0 mm\n") && !widget(&session, "reset.one").is_enabled);
    push(&mut session, "undo");
    assert_eq!(bits(&positions(&session)), bits(&both));
    assert!(shown(&session, "landmark.z").ends_with(": 4.0 mm\n"));
}

#[test]
fn making_a_face_symmetric_is_listed_with_its_share_and_undone_like_an_edit() {
    let mut session = session();
    let before = positions(&session);
    set(&mut session, "symmetrise", Value::Number(100.0));
    push(&mut session, "symmetrise.apply");
    assert_eq!(history(&session), ["[x] Make symmetric (100 %)"]);
    let [right, left] = WINGS.map(|wing| positions(&session)[wing]);
    assert!((right * DVec3::new(-1.0, 1.0, 1.0)).distance(left) < 1e-12, "{right} and {left}");
    push(&mut session, "undo");
    assert_eq!(bits(&positions(&session)), bits(&before));
}

#[test]
fn one_slider_shows_both_sides_of_an_expression_unless_they_are_apart() {
    let mut session = session();
    set(&mut session, "expressions.both", Value::Flag(true));
    set(&mut session, "expression.mouthSmileLeft", Value::Number(50.0));
    act(&mut session, Intent::Commit);
    assert_eq!(history(&session), ["[x] Smile, right (50 %)", "[x] Smile, left (50 %)"]);
    assert_eq!(shown(&session, "expression.mouthSmileLeft"), "Smile: 50.0 %\n");
    assert!(is_hidden(&session, "expression.mouthSmileRight"));
    set(&mut session, "expressions.both", Value::Flag(false));
    set(&mut session, "expression.mouthSmileRight", Value::Number(20.0));
    act(&mut session, Intent::Commit);
    assert_eq!(shown(&session, "expression.mouthSmileLeft"), "Smile, left: 50.0 %\n");
    assert_eq!(shown(&session, "expression.mouthSmileRight"), "Smile, right: 20.0 %\n");
}

#[test]
fn an_edit_that_waits_names_its_density() {
    let mut session = session();
    act(&mut session, Intent::Expert(true));
    act(&mut session, Intent::Mode(SelectionMode::Point));
    act(&mut session, Intent::Density(1));
    act(&mut session, Intent::SelectAt(1_500));
    offset(&mut session, DVec3::Z * 3.0);
    let moved = positions(&session);
    let [name] = &history(&session)[..] else { panic!("more than an edit") };
    assert!(name.starts_with("[x] point 1500 near the ") && name.ends_with(" (3.0 mm)"), "{name}");
    set(&mut session, "point.density", Value::Text("0".into()));
    assert_eq!(history(&session), [format!("{name} (needs the mesh density “Medium, 1,833 points”)")]);
    set(&mut session, "point.density", Value::Text("1".into()));
    assert_eq!((&history(&session)[0], bits(&positions(&session))), (name, bits(&moved)));
    set(&mut session, "entry.0", Value::Flag(false));
    let document = session.face().unwrap().document();
    assert_eq!(bits(document.positions()), bits(document.rest()));
}

#[test]
fn points_without_a_partner_disable_the_mirror_and_say_why() {
    let mut session = session();
    act(&mut session, Intent::Mode(SelectionMode::Point));
    act(&mut session, Intent::SelectAt(5_000));
    assert!(widget(&session, "edit.mirror").is_enabled && is_hidden(&session, "edit.mirror.none"));
    act(&mut session, Intent::Triangulation(Triangulation::Tessellation));
    assert!(!widget(&session, "edit.mirror").is_enabled && !is_hidden(&session, "edit.mirror.none"));
}

#[test]
fn the_main_button_saves_the_displayed_scene() {
    let mut session = session();
    let main = |session: &Session| label(&words("en"), &widget(session, "save.main"));
    assert_eq!((main(&session).as_str(), shown(&session, "save.note").trim()), ("Download GLB", "No edits yet"));
    act(&mut session, Intent::Scene(Scene::Picture));
    assert_eq!(main(&session), "Save photo");
    slide(&mut session, FaceSlider::NoseWidth, 2.0);
    assert_eq!(shown(&session, "save.note").trim(), "");
}

#[test]
fn an_edit_along_the_view_offers_a_better_view() {
    let mut session = session();
    act(&mut session, Intent::Scene(Scene::Picture));
    select(&mut session, NOSE_TIP);
    assert!(is_hidden(&session, "depth"));
    offset(&mut session, DVec3::Y * 3.0);
    assert!(is_hidden(&session, "depth"), "the edit is visible");
    offset(&mut session, DVec3::Z * 9.0);
    assert!(!is_hidden(&session, "depth"));
    push(&mut session, "depth.show");
    session.stage_mut().advance(0.0);
    assert!(is_hidden(&session, "depth") && session.view().scene == Scene::Solid);
}

#[test]
fn the_tape_names_its_ends_and_its_error() {
    let mut session = session();
    select(&mut session, 61);
    push(&mut session, "tape.start");
    assert!(shown(&session, "tape.result").starts_with("From right mouth corner"));
    select(&mut session, 291);
    let result = shown(&session, "tape.result");
    let [straight, along] = session.face().unwrap().measured_mm(61, 291).unwrap();
    for part in
        ["right mouth corner – left mouth corner", &format!("{straight:.0} mm ± "), &format!("{along:.0} mm ± ")]
    {
        assert!(result.contains(part), "no {part:?} in {result}");
    }
}

#[test]
fn a_mesh_without_the_start_of_the_tape_removes_it() {
    let mut session = session();
    act(&mut session, Intent::Mode(SelectionMode::Point));
    act(&mut session, Intent::Density(1));
    act(&mut session, Intent::SelectAt(1_200));
    push(&mut session, "tape.start");
    assert!(shown(&session, "tape.result").starts_with("From point 1200:"));
    act(&mut session, Intent::Density(0));
    select(&mut session, NOSE_TIP);
    assert!(shown(&session, "tape.result").starts_with("Select a point"));
}

#[test]
fn the_panel_names_the_glb_with_its_content_and_verdict_until_the_face_changes() {
    let mut session = session();
    let facts = |session: &Session| -> Vec<String> {
        shown(session, "export.facts").lines().skip(1).map(|line| line.trim().to_owned()).collect()
    };
    act(&mut session, Intent::Report(Report::Face { stem: "portrait".into(), saved_px: None }));
    session.set_texture_side_px(Some(1024));
    let usual = "GLB: 7257 points, 14368 triangles, a texture of 1024 × 1024 px.";
    assert_eq!(facts(&session), ["portrait.glb = ;", usual]);
    set(&mut session, "export.density", Value::Text("1".into()));
    set(&mut session, "base-colour", Value::Text("colours".into()));
    let coarser = "GLB: 1833 points, 3592 triangles, point colours, no texture.";
    assert_eq!(facts(&session), ["portrait-1833.glb = ;", coarser]);

    let verdict = Some(Outcome::Validated { errors: 0, warnings: 0, remarks: 0 });
    for report in [Report::GlbStarted { is_validated: true }, Report::GlbMade { bytes: 812_400.0, verdict }] {
        act(&mut session, Intent::Report(report));
    }
    assert_eq!(facts(&session), ["portrait-1833.glb = 812 KB;", coarser]);
    let valid = "portrait-1833.glb, 812 KB: valid glTF 2.0, 0 errors, 0 warnings, 0 notes";
    assert_eq!(shown(&session, "verdict").trim(), valid);
    slide(&mut session, FaceSlider::NoseWidth, 2.0);
    assert_eq!((facts(&session)[0].as_str(), shown(&session, "verdict").trim()), ("portrait-1833.glb = ;", ""));
}
