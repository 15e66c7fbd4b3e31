//! Property tests: readers accept or refuse slightly damaged files, within their requirements.

mod damage;

use std::cell::Cell;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestRunner;
use rosto_fuzz::Kind;

/// Reads `times` × `PROPTEST_CASES` damaged files; returns the share that was accepted.
fn accepted(kind: Kind, times: u32) -> f64 {
    let config = ProptestConfig::default();
    let cases = config.cases * times;
    let (seeds, accepted) = (kind.seeds(), Cell::new(0));
    let damage = (any::<Index>(), vec(damage::edit(kind), 1..=4), prop::bool::weighted(0.75));
    let mut runner = TestRunner::new(ProptestConfig { cases, ..config });
    let outcome = runner.run(&damage, |(seed, edits, is_repaired)| {
        let mut bytes = seed.get(&seeds).clone();
        edits.iter().for_each(|edit| edit.apply(kind, &mut bytes));
        let bytes = if is_repaired { kind.repaired(bytes) } else { bytes };
        accepted.set(accepted.get() + u32::from(kind.check(&bytes)));
        Ok(())
    });
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
    f64::from(accepted.get()) / f64::from(cases)
}

/// Asserts that the damage is neither harmless nor caught entirely by the first check.
fn assert_deep(share: f64) {
    assert!((0.05..0.95).contains(&share), "{share} of the files were accepted");
}

#[test]
fn reads_or_refuses_damaged_pictures() {
    assert_deep(accepted(Kind::Picture, 32));
}

#[test]
fn decodes_pictures_with_damaged_profiles() {
    assert_eq!(accepted(Kind::Profile, 8), 1.0);
}

#[test]
fn reads_or_refuses_damaged_glbs() {
    assert_deep(accepted(Kind::Glb, 2));
}

#[test]
fn reads_or_refuses_damaged_projects() {
    assert_deep(accepted(Kind::Project, 2));
}

#[test]
fn reads_or_refuses_damaged_edits() {
    assert_deep(accepted(Kind::Edits, 8));
}
