//! Undo, redo, switches and replay reproduce positions bit by bit.

use glam::DVec3;
use rosto_face::Triangulation;
use rosto_studio::*;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;
use crate::seeded::Seeded;

const CASES: u64 = 12;

fn any_command(random: &mut Seeded) -> Command {
    if random.below(5) == 0 {
        return Command::Symmetrise { share: random.signed().abs() };
    }
    let settings = Settings {
        operator: Operator::ALL[random.below(Operator::ALL.len())],
        constraint: [ConstraintKind::Hard, ConstraintKind::Soft { weight: 2.5 }][random.below(2)],
        anchors: match random.below(4) {
            0 => Anchors::default(),
            1 => Anchors::random(17),
            2 => Anchors { kind: AnchorKind::Outside { radius: 0.05 }, pins: vec![] },
            _ => Anchors::explicit(vec![467]),
        },
        influence: [RegionOfInfluence::Whole, RegionOfInfluence::Within { radius: 0.06 }][random.below(2)],
        mirror: [Mirror::On, Mirror::Off][random.below(2)],
        details: [Details::AsRigidAsPossible, Details::Kept, Details::Kept, Details::Kept][random.below(4)],
    };
    let spec = EditSpec { level: 0, handles: vec![random.below(200) as u32], settings };
    Command::Move { spec, offsets: vec![random.vector() * 0.02] }
}

fn any_commands(seed: u64) -> Vec<Command> {
    let mut random = Seeded::new(seed);
    (0..2 + random.below(3)).map(|_| any_command(&mut random)).collect()
}

#[test]
fn undo_and_redo_restore_positions_bit_by_bit() {
    for seed in 0..CASES {
        let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
        let mut states = vec![bits(document.positions())];
        for command in any_commands(seed) {
            document.apply("step", command).unwrap();
            states.push(bits(document.positions()));
        }
        for state in states.iter().rev().skip(1) {
            document.undo().unwrap();
            assert_eq!(&bits(document.positions()), state);
        }
        assert!(!document.history().can_undo());
        for state in states.iter().skip(1) {
            document.redo().unwrap();
            assert_eq!(&bits(document.positions()), state);
        }
        assert!(!document.history().can_redo());
    }
}

#[test]
fn a_history_read_back_replays_to_the_same_bytes() {
    for seed in 0..CASES {
        let rest = portrait(Triangulation::Tessellation);
        let mut document = Document::new(rest.clone()).unwrap();
        for (index, command) in any_commands(seed).into_iter().enumerate() {
            document.apply(&format!("\"{index}\" ção\n"), command).unwrap();
        }
        let entries = project::from_json(&project::to_json(document.history().entries())).unwrap();
        assert_eq!(entries, document.history().entries());
        let replayed = Document::replay(rest, entries).unwrap();
        assert_eq!(bits(replayed.positions()), bits(document.positions()));
    }
}

#[test]
fn an_entry_switched_off_has_no_effect() {
    for seed in 0..CASES {
        let rest = portrait(Triangulation::Canonical);
        let commands = any_commands(seed);
        let which = seed as usize % commands.len();
        let mut with = Document::new(rest.clone()).unwrap();
        let mut without = Document::new(rest).unwrap();
        for (index, command) in commands.into_iter().enumerate() {
            with.apply("step", command.clone()).unwrap();
            if index != which {
                without.apply("step", command).unwrap();
            }
        }
        let all = bits(with.positions());
        with.switch(which, Switch::Off).unwrap();
        assert_eq!(bits(with.positions()), bits(without.positions()));
        with.switch(which, Switch::On).unwrap();
        assert_eq!(bits(with.positions()), all);
    }
}

#[test]
fn a_drag_is_one_entry_and_equals_its_command() {
    let rest = portrait(Triangulation::Canonical);
    let mut dragged = Document::new(rest.clone()).unwrap();
    dragged.prepare(mirrored_spec(61)).unwrap();
    for step in 1..=10 {
        dragged.preview(&[DVec3::new(0.0, 0.001, 0.002) * f64::from(step)]).unwrap();
    }
    let shown = bits(dragged.positions());
    dragged.commit("mouth corner");
    assert_eq!(dragged.history().entries().len(), 1);
    assert_eq!(bits(dragged.positions()), shown);
    let mut applied = Document::new(rest).unwrap();
    applied.apply("mouth corner", dragged.history().entries()[0].command.clone()).unwrap();
    assert_eq!(bits(applied.positions()), shown);
}

#[test]
fn cancelling_a_drag_retains_the_prepared_edit() {
    let mut document = Document::new(canonical(Triangulation::Tessellation)).unwrap();
    let rest = bits(document.positions());
    document.prepare(mirrored_spec(61)).unwrap();
    document.preview(&[DVec3::splat(0.01)]).unwrap();
    assert_ne!(bits(document.positions()), rest);
    document.cancel();
    document.commit("nothing");
    assert_eq!(bits(document.positions()), rest);
    assert!(document.history().entries().is_empty());
    assert_eq!(document.spec(), Some(&mirrored_spec(61)));
    document.preview(&[DVec3::splat(0.01)]).unwrap();
    document.release();
    assert_eq!((bits(document.positions()), document.spec()), (rest, None));
}

#[test]
fn the_next_drag_starts_where_the_last_one_ended() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.prepare(mirrored_spec(4)).unwrap();
    for _ in 0..2 {
        document.preview(&[DVec3::new(0.0, 0.0, 0.005)]).unwrap();
        document.commit("nose tip");
    }
    let reached = document.positions()[4] - document.rest()[4];
    assert!((reached - DVec3::new(0.0, 0.0, 0.01)).length() < 1e-12);
}

#[test]
fn displacements_add_up_to_the_edit() {
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    document.set_density(1).unwrap();
    document.apply("one", single_move(4, DVec3::Z * 0.01)).unwrap();
    document.apply("two", Command::Symmetrise { share: 0.4 }).unwrap();
    let layers = document.displacements();
    assert_eq!(layers.len(), 2);
    for (vertex, (from, to)) in document.rest().iter().zip(document.committed()).enumerate() {
        assert!((*from + layers[0][vertex] + layers[1][vertex]).distance(*to) < 1e-15);
    }
}

#[test]
fn each_change_of_the_list_is_one_undo_and_one_redo() {
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    let mut states = vec![(bits(document.positions()), document.history().entries().to_vec())];
    let mut note =
        |document: &Document| states.push((bits(document.positions()), document.history().entries().to_vec()));
    for (label, command) in [("one", single_move(4, DVec3::Z * 0.01)), ("two", single_move(152, DVec3::Y * 0.01))] {
        document.apply(label, command).unwrap();
        note(&document);
    }
    document.switch(0, Switch::Off).unwrap();
    note(&document);
    document.reset();
    note(&document);
    document.apply("three", single_move(10, DVec3::Y * 0.01)).unwrap();
    note(&document);
    assert_eq!(states[4].0, bits(document.rest()));
    for (positions, entries) in states.iter().rev().skip(1) {
        document.undo().unwrap();
        assert_eq!((&bits(document.positions()), document.history().entries()), (positions, entries.as_slice()));
    }
    assert!(!document.history().can_undo());
    for (positions, entries) in states.iter().skip(1) {
        document.redo().unwrap();
        assert_eq!((&bits(document.positions()), document.history().entries()), (positions, entries.as_slice()));
    }
    assert!(!document.history().can_redo());
}

#[test]
fn a_new_command_discards_undone_changes() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.apply("one", single_move(4, DVec3::Z * 0.01)).unwrap();
    document.apply("two", single_move(152, DVec3::Y * 0.01)).unwrap();
    document.undo().unwrap();
    document.apply("three", single_move(10, DVec3::X * 0.01)).unwrap();
    assert!(!document.history().can_redo());
    let labels: Vec<&str> = document.history().entries().iter().map(|entry| entry.label.as_str()).collect();
    assert_eq!(labels, ["one", "three"]);
}

#[test]
fn no_ops_add_no_change() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.reset();
    assert_eq!((document.undo(), document.redo()), (None, None));
    assert!(!document.history().can_undo() && !document.history().can_redo());
    document.apply("one", single_move(4, DVec3::Z * 0.01)).unwrap();
    document.switch(0, Switch::On).unwrap();
    assert_eq!(document.switch_off(EditTarget::Landmark(152)), None);
    document.undo().unwrap();
    assert!(document.history().entries().is_empty());
}

#[test]
fn all_edits_of_one_landmark_are_switched_off_together() {
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    let mut others = Document::new(portrait(Triangulation::Canonical)).unwrap();
    for vertex in [4, 152, 4, 10, 4] {
        document.apply("step", single_move(vertex, DVec3::new(0.001, 0.002, 0.003))).unwrap();
        if vertex != 4 {
            others.apply("step", single_move(vertex, DVec3::new(0.001, 0.002, 0.003))).unwrap();
        }
    }
    let all = bits(document.positions());
    document.switch_off(EditTarget::Landmark(4)).unwrap();
    assert_eq!(bits(document.positions()), bits(others.positions()));
    let on: Vec<bool> = document.history().entries().iter().map(|entry| entry.switch == Switch::On).collect();
    assert_eq!(on, [false, true, false, true, false]);
    document.undo().unwrap();
    assert_eq!(bits(document.positions()), all);
}

#[test]
fn a_history_continues_on_another_triangulation() {
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    document.apply("one", single_move(4, DVec3::Z * 0.01)).unwrap();
    document.apply("two", single_move(152, DVec3::Y * 0.01)).unwrap();
    document.reset();
    document.undo().unwrap();
    let history = document.history().clone();
    let mut resumed = Document::resume(portrait(Triangulation::Tessellation), history.clone()).unwrap();
    assert_eq!(resumed.history(), &history);
    let replayed = Document::replay(portrait(Triangulation::Tessellation), history.entries().to_vec()).unwrap();
    assert_eq!(bits(resumed.positions()), bits(replayed.positions()));
    resumed.redo().unwrap();
    assert_eq!(bits(resumed.positions()), bits(resumed.rest()));
}

#[test]
fn invalid_histories_are_refused() {
    let other = format!(r#"{{"rosto":"history","version":{},"entries":[]}}"#, project::VERSION + 1);
    let cases = [
        ("", project::ProjectError::NotAHistory),
        ("{\"version\":1}", project::ProjectError::NotAHistory),
        (&other, project::ProjectError::Version { found: project::VERSION + 1, known: project::VERSION }),
        (
            r#"{"rosto":"history","version":1,"entries":[{"label":"a","switch":"on","symmetrise":{"share":"x"}}]}"#,
            project::ProjectError::Field { entry: 0, field: "share" },
        ),
    ];
    for (text, error) in cases {
        assert_eq!(project::from_json(text), Err(error));
    }
}

#[test]
fn a_refused_command_changes_nothing() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.apply("one", single_move(4, DVec3::Z * 0.01)).unwrap();
    let before = bits(document.positions());
    let pinned = EditSpec {
        level: 0,
        handles: vec![4],
        settings: Settings { anchors: Anchors::explicit(vec![4, 9]), ..Settings::default() },
    };
    let refused = [
        single_move(468, DVec3::Z),
        single_move(4, DVec3::splat(f64::NAN)),
        Command::Move { spec: pinned, offsets: vec![DVec3::Z] },
        Command::Move { spec: mirrored_spec(4), offsets: vec![] },
        Command::Symmetrise { share: 1.5 },
    ];
    for command in refused {
        assert!(document.apply("refused", command).is_err());
        assert_eq!(bits(document.positions()), before);
        assert_eq!(document.history().entries().len(), 1);
    }
    assert_eq!(document.preview(&[DVec3::Z]), Err(StudioError::NothingPrepared));
    assert_eq!(document.switch(1, Switch::Off), Err(StudioError::NoSuchEntry { index: 1, count: 1 }));
}
