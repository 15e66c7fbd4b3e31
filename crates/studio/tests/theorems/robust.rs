//! Histories from files, long histories, and histories that another triangulation cannot apply.

use glam::DVec3;
use rosto_face::{MAX_DENSITY, Triangulation};
use rosto_studio::*;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;

fn entry(command: Command) -> Entry {
    Entry { label: "step".to_owned(), command, switch: Switch::On }
}

fn point(level: u32, handles: Vec<u32>, settings: Settings) -> Command {
    let offsets = vec![DVec3::Z * 0.002; handles.len()];
    Command::Move { spec: EditSpec { level, handles, settings }, offsets }
}

/// More shapes than the cache retains; those in between are recomputed.
#[test]
fn long_histories_replay_and_undo_bit_by_bit() {
    let rest = canonical(Triangulation::Canonical);
    let step = |index: u32| entry(single_move(index % 468, DVec3::new(0.0, 1e-6, 2e-6) * f64::from(index % 7)));
    let mut document = Document::replay(rest.clone(), (0..6_000).map(step).collect()).unwrap();
    assert_eq!(document.history().entries().len(), 6_000);
    let last = bits(document.positions());
    for _ in 0..300 {
        document.undo().unwrap();
    }
    let shorter = Document::replay(rest, (0..5_700).map(step).collect()).unwrap();
    assert_eq!(bits(document.positions()), bits(shorter.positions()));
    while document.redo().is_some() {}
    assert_eq!(bits(document.positions()), last);
}

#[test]
fn handles_that_map_to_one_vertex_are_merged() {
    let mut filled = Document::new(canonical(Triangulation::Canonical)).unwrap();
    filled.set_density(2).unwrap();
    let settings = Settings { constraint: ConstraintKind::Hard, ..Settings::default() };
    let crowded: Vec<u32> = (3_000..3_200).collect();
    filled.apply("crowd", point(2, crowded, settings)).unwrap();
    let mut open = filled.over(canonical(Triangulation::Tessellation)).unwrap();
    open.set_density(2).unwrap();
    assert_eq!(open.status(0), Some(&EntryStatus::InForce));
    let Command::Move { spec, offsets } = &open.history().entries()[0].command else { panic!("a move") };
    let mut once = spec.handles.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!((once.len(), offsets.len()), (spec.handles.len(), spec.handles.len()));
    assert_ne!(bits(open.positions()), bits(open.rest()));
}

#[test]
fn impossible_entries_are_skipped_and_return_with_their_triangulation() {
    let mut filled = Document::new(canonical(Triangulation::Canonical)).unwrap();
    filled.set_density(1).unwrap();
    let settings = Settings { mirror: Mirror::On, anchors: Anchors::random(3), ..Settings::default() };
    filled.apply("symmetric", point(1, vec![1_500], settings)).unwrap();
    let edited = bits(filled.positions());
    let history = filled.history().clone();
    // Denser tessellations are not symmetric.
    let mut open = Document::resume(canonical(Triangulation::Tessellation), history.clone()).unwrap();
    open.set_density(1).unwrap();
    assert_eq!(open.status(0), Some(&EntryStatus::Impossible(StudioError::NoMirror)));
    assert_eq!(bits(open.positions()), bits(open.rest()));
    assert!(open.switch(0, Switch::Off).is_ok() && open.undo().is_some());
    let mut back = Document::resume(canonical(Triangulation::Canonical), open.history().clone()).unwrap();
    back.set_density(1).unwrap();
    assert_eq!(bits(back.positions()), edited);
}

#[test]
fn invalid_entries_are_refused_on_or_off() {
    let far = |level| point(level, vec![9_999], Settings::default());
    let pinned = point(0, vec![4], Settings { anchors: Anchors::explicit(vec![468]), ..Settings::default() });
    let many = point(3, (0..20_000).collect(), Settings::default());
    let twice = |mirror| point(0, vec![61, 61, 291], Settings { mirror, ..Settings::default() });
    let cases = [
        (far(0), true),
        (far(1), true),
        (far(2), true),
        (far(3), false),
        (far(5), true),
        (pinned, true),
        (many, true),
        (twice(Mirror::Off), true),
        (twice(Mirror::On), true),
    ];
    for (command, refused) in cases {
        for switch in [Switch::On, Switch::Off] {
            let entry = Entry { label: String::new(), command: command.clone(), switch };
            let outcome = Document::replay(canonical(Triangulation::Canonical), vec![entry]);
            assert_eq!(outcome.is_err(), refused, "{command:?}");
        }
    }
    let dense = Document::open(canonical(Triangulation::Canonical), Vec::new(), MAX_DENSITY + 1);
    assert!(matches!(dense, Err(StudioError::TooDense { level: 5, max: 4 })));
}

#[test]
fn a_failed_prepare_retains_the_prepared_edit() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.prepare(mirrored_spec(61)).unwrap();
    document.preview(&[DVec3::Z * 0.01]).unwrap();
    let shown = bits(document.positions());
    let unanchored = Settings { anchors: Anchors::explicit(Vec::new()), ..Settings::default() };
    for handles in [vec![4], vec![468], vec![], vec![4, 4]] {
        let spec = EditSpec { level: 0, handles, settings: unanchored.clone() };
        assert!(document.prepare(spec).is_err());
        assert_eq!((document.spec(), bits(document.positions())), (Some(&mirrored_spec(61)), shown.clone()));
    }
}

fn off(label: &str) -> Entry {
    Entry { label: label.to_owned(), command: Command::Symmetrise { share: 0.5 }, switch: Switch::Off }
}

#[test]
fn the_number_of_entries_is_limited() {
    let rest = canonical(Triangulation::Canonical);
    let refused = |count| Document::replay(rest.clone(), vec![off("step"); count]).err();
    let found = MAX_ENTRIES + 1;
    assert_eq!(refused(found), Some(StudioError::TooManyEntries { found, max: MAX_ENTRIES }));
    let mut full = Document::replay(rest.clone(), vec![off("step"); MAX_ENTRIES]).unwrap();
    let too_many = Err(StudioError::TooManyEntries { found, max: MAX_ENTRIES });
    assert_eq!(full.apply("one more", single_move(4, DVec3::Z)), too_many);
    full.prepare(EditSpec { handles: vec![4], ..EditSpec::default() }).unwrap();
    assert_eq!(full.preview(&[DVec3::Z]), too_many);
    assert_eq!(full.preview_expressions(&[(Expression::JawOpen, 0.5)]), too_many);
    assert!(full.undo().is_some());
    assert_eq!(full.preview(&[DVec3::Z]), Ok(()));
    full.commit("one more");
    assert_eq!(full.history().entries().len(), MAX_ENTRIES);
}

#[test]
fn labels_are_limited() {
    let rest = canonical(Triangulation::Canonical);
    let refused = |label: &str| Document::replay(rest.clone(), vec![off(label)]).err();
    assert_eq!(refused(&"é".repeat(MAX_LABEL_CHARS)), None);
    let reason = Box::new(StudioError::LabelTooLong { found: MAX_LABEL_CHARS + 1, max: MAX_LABEL_CHARS });
    assert_eq!(refused(&"é".repeat(MAX_LABEL_CHARS + 1)), Some(StudioError::Entry { index: 0, reason }));
}

#[test]
fn more_anchors_than_vertices_are_refused() {
    let settings = Settings { anchors: Anchors::explicit(vec![5; 469]), ..Settings::default() };
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    let refused = Err(StudioError::TooManyAnchors { anchors: 469, vertex_count: 468 });
    assert_eq!(document.apply("step", point(0, vec![4], settings)), refused);
}

/// The entries wait for a denser mesh, so that nothing is solved in this test.
#[test]
fn histories_that_take_too_long_are_refused_before_they_are_replayed() {
    let rest = canonical(Triangulation::Canonical);
    let settings = |radius| Settings { influence: RegionOfInfluence::Within { radius }, ..Settings::default() };
    let dense = |index: u32| entry(point(4, (0..100).collect(), settings(0.01 + 0.001 * f64::from(index))));
    assert!(Document::replay(rest.clone(), vec![dense(0); 10]).is_ok(), "equal specs share a solve");
    let refused = Document::replay(rest, (0..10).map(dense).collect()).err();
    assert!(matches!(refused, Some(StudioError::TooMuchWork { work, max }) if work > max), "{refused:?}");
}

/// 20,000 edits of all landmarks stay far below the limit on work.
#[test]
fn a_long_history_of_all_landmarks_opens() {
    let step = |index: u32| entry(single_move(index % 468, DVec3::new(0.0, 1e-6, 2e-6) * f64::from(index % 7)));
    let document = Document::open(canonical(Triangulation::Canonical), (0..20_000).map(step).collect(), 2).unwrap();
    assert_eq!(document.status(19_999), Some(&EntryStatus::InForce));
}
