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
