use glam::DVec3;
use rosto::{BaseColour, ExpressionsAs, Eyes, FaceMesh, FileOptions, Format, reopen};
use rosto_face::Triangulation;
use rosto_session::{Intent, Look, Selection, Session};
use rosto_studio::{Expression, Mirror, Switch, project};
use serde_json::Value;

use super::{act, face, positions, state};
use crate::faces::{bits, saved, session};

/// Drags an expression's slider to a weight.
fn express(session: &mut Session, expression: Expression, to: f64) {
    for tick in 1..=8 {
        act(session, Intent::Express(expression, to * f64::from(tick) / 8.0));
    }
    act(session, Intent::Commit);
}

fn value_of(session: &Session, expression: Expression) -> f64 {
    state(session).weights[expression.id()]
}

fn is_near(session: &Session, expression: Expression, weight: f64) -> bool {
    (value_of(session, expression) - weight).abs() < 1e-9
}

#[test]
fn an_expressions_weight_is_the_sum_of_its_entries_in_force() {
    let mut session = session();
    express(&mut session, Expression::JawOpen, 0.5);
    express(&mut session, Expression::MouthPucker, 0.25);
    express(&mut session, Expression::JawOpen, 0.2);
    assert_eq!(state(&session).entry_count, 3);
    assert!(is_near(&session, Expression::JawOpen, 0.2));
    act(&mut session, Intent::Switch(0, Switch::Off));
    assert!(is_near(&session, Expression::JawOpen, -0.3));
    act(&mut session, Intent::Undo);
    act(&mut session, Intent::Undo);
    assert!(is_near(&session, Expression::JawOpen, 0.5));
    assert!(is_near(&session, Expression::MouthPucker, 0.25));
}

#[test]
fn the_mirror_applies_expressions_to_both_sides_as_one_change() {
    let mut session = session();
    let (left, right) = (Expression::MouthSmileLeft, Expression::MouthSmileRight);
    act(&mut session, Intent::Mirror(Mirror::Off));
    express(&mut session, right, 0.75);
    assert!(is_near(&session, right, 0.75) && is_near(&session, left, 0.0));
    act(&mut session, Intent::Mirror(Mirror::On));
    express(&mut session, left, 0.5);
    assert!(is_near(&session, right, 0.5) && is_near(&session, left, 0.5));
    assert_eq!(state(&session).entry_count, 3);
    act(&mut session, Intent::Undo);
    assert!(is_near(&session, right, 0.75) && is_near(&session, left, 0.0));
}

#[test]
fn a_look_replaces_all_expressions_as_one_change() {
    let mut session = session();
    express(&mut session, Expression::JawForward, 0.5);
    let count = state(&session).entry_count;
    for look in Look::ALL {
        act(&mut session, Intent::Look(Some(look)));
        let weights = face(&session).weights();
        assert!(weights.iter().zip(look.weights()).all(|(now, of_look)| (now - of_look).abs() < 1e-9), "{}", look.id());
        act(&mut session, Intent::Undo);
        assert_eq!(state(&session).entry_count, count);
        assert!(is_near(&session, Expression::JawForward, 0.5));
    }
    act(&mut session, Intent::Look(Some(Look::Smile)));
    let before = state(&session).entry_count;
    act(&mut session, Intent::Look(Some(Look::Smile)));
    assert_eq!(state(&session).entry_count, before, "the same look again changes nothing");
    act(&mut session, Intent::Look(None));
    assert!(face(&session).weights().iter().all(|weight| weight.abs() < 1e-9));
}

#[test]
fn resetting_expressions_is_one_change() {
    let mut session = session();
    let rest = bits(&positions(&session));
    express(&mut session, Expression::EyeBlinkLeft, 1.0);
    express(&mut session, Expression::CheekPuff, 0.5);
    let shown = bits(&positions(&session));
    act(&mut session, Intent::ResetExpressions);
    assert_eq!(bits(&positions(&session)), rest);
    assert!(state(&session).weights.values().all(|weight| *weight == 0.0));
    act(&mut session, Intent::Undo);
    assert_eq!(bits(&positions(&session)), shown);
}

#[test]
fn cancelled_expressions_add_no_entry_and_the_edit_stays_prepared() {
    let mut session = session();
    act(&mut session, Intent::Select(Some(Selection::Landmark(4))));
    let rest = positions(&session);
    act(&mut session, Intent::Express(Expression::BrowInnerUp, 0.8));
    assert!(session.tick().is_editing && state(&session).is_sliding);
    assert_ne!(positions(&session), rest);
    act(&mut session, Intent::Cancel);
    assert_eq!(positions(&session), rest);
    act(&mut session, Intent::Express(Expression::BrowInnerUp, 0.8));
    act(&mut session, Intent::Express(Expression::BrowInnerUp, 0.0));
    act(&mut session, Intent::Commit);
    assert_eq!(state(&session).entry_count, 0);
    assert_eq!(face(&session).document().spec().map(|spec| spec.handles.clone()), Some(vec![4]));
}

fn rigged() -> FileOptions {
    FileOptions {
        base_colour: BaseColour::VertexColours,
        expressions: ExpressionsAs::MorphTargets,
        ..FileOptions::default()
    }
}

/// JSON and binary chunk of a GLB.
struct Glb {
    json: Value,
    binary: Vec<u8>,
}

impl Glb {
    fn read(file: &[u8]) -> Self {
        let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
        let json = serde_json::from_slice(&file[20..20 + length]).unwrap();
        Self { json, binary: file[20 + length + 8..].to_vec() }
    }

    fn floats(&self, view: &Value, count: usize) -> Vec<f32> {
        let start = self.json["bufferViews"][view.as_u64().unwrap() as usize]["byteOffset"].as_u64().unwrap() as usize;
        self.binary[start..].chunks(4).take(count).map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap())).collect()
    }

    /// Vectors of a dense or sparse accessor.
    fn vectors(&self, accessor: &Value) -> Vec<DVec3> {
        let accessor = &self.json["accessors"][accessor.as_u64().unwrap() as usize];
        let count = accessor["count"].as_u64().unwrap() as usize;
        let vector = |values: &[f32]| DVec3::new(values[0].into(), values[1].into(), values[2].into());
        let sparse = &accessor["sparse"];
        if sparse.is_null() {
            return self.floats(&accessor["bufferView"], 3 * count).chunks(3).map(vector).collect();
        }
        let moved = sparse["count"].as_u64().unwrap() as usize;
        let view = &self.json["bufferViews"][sparse["indices"]["bufferView"].as_u64().unwrap() as usize];
        let start = view["byteOffset"].as_u64().unwrap() as usize;
        let indices = self.binary[start..].chunks(2).take(moved);
        let indices = indices.map(|bytes| u16::from_le_bytes(bytes.try_into().unwrap()));
        let values = self.floats(&sparse["values"]["bufferView"], 3 * moved);
        let mut vectors = vec![DVec3::ZERO; count];
        indices.zip(values.chunks(3)).for_each(|(at, value)| vectors[usize::from(at)] = vector(value));
        vectors
    }
}

#[test]
fn a_glb_with_expressions_adds_up_to_the_displayed_shape_and_reopens() {
    let mut session = session();
    act(&mut session, Intent::Triangulation(Triangulation::Canonical));
    act(&mut session, Intent::Select(Some(Selection::Landmark(4))));
    super::move_by(&mut session, DVec3::new(0.0, 0.0, 6.0));
    express(&mut session, Expression::JawOpen, 0.6);
    act(&mut session, Intent::Mirror(Mirror::Off));
    express(&mut session, Expression::EyeBlinkLeft, 1.0);
    for density in [0, 2] {
        act(&mut session, Intent::Density(density));
        let mut written = FaceMesh::reopen(saved(&session)).unwrap();
        let file = written.write(Format::Glb, &rigged(), "face").unwrap().bytes;
        assert!(file.len() < [1_000_000, 3_000_000][usize::from(density > 0)], "{} bytes at {density}", file.len());
        let glb = Glb::read(&file);
        let mesh = &glb.json["meshes"][0];
        let names: Vec<&str> = Expression::ALL.iter().map(|expression| expression.id()).collect();
        assert_eq!(mesh["extras"]["targetNames"], Value::from(names));
        let mut reached = glb.vectors(&mesh["primitives"][0]["attributes"]["POSITION"]);
        let targets = mesh["primitives"][0]["targets"].as_array().unwrap();
        for (target, weight) in targets.iter().zip(mesh["weights"].as_array().unwrap()) {
            let displacements = glb.vectors(&target["POSITION"]);
            reached
                .iter_mut()
                .zip(displacements)
                .for_each(|(at, displacement)| *at += weight.as_f64().unwrap() * displacement);
        }
        let shown = positions(&session);
        assert!(reached.len() > shown.len(), "eyes and mouth are separate pieces");
        let [points, triangles] = face(&session).mesh_counts(true);
        let indices = &glb.json["accessors"][mesh["primitives"][0]["indices"].as_u64().unwrap() as usize];
        assert_eq!((points, Some(3 * triangles as u64)), (reached.len(), indices["count"].as_u64()));
        assert_eq!(face(&session).mesh_counts(false)[0], shown.len());
        let still = FileOptions { eyes: Eyes::Pieces, ..FileOptions::default() };
        let ply = written.write(Format::Ply, &still, "face").unwrap().bytes;
        let header = format!("element vertex {}\n", reached.len());
        assert!(String::from_utf8_lossy(&ply).contains(&header), "a rig without expressions has the same pieces");
        let apart = shown.iter().zip(&reached).map(|(shown, reached)| shown.distance(*reached)).fold(0.0, f64::max);
        assert!(apart < 1e-7, "{apart} m");
        let reopened = reopen(&file).unwrap();
        let history = reopened.face.edits.unwrap().history.unwrap();
        assert_eq!(project::from_json(&history).unwrap().len(), 3);
    }
}
