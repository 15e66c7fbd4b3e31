//! Checks the invariants of ARCHITECTURE.md, in what cargo resolves or in the sources of the crates.
//!
//! A dependency or a line that breaks the invariant is planted to show that the check finds it.

#![cfg(test)]

mod cycles;
mod facts;
mod features;
mod invariants;

use facts::Facts;
use invariants::INVARIANTS;
use std::collections::BTreeSet;

#[test]
fn invariants_hold_and_their_checks_find_a_planted_breach() {
    let facts = Facts::of_workspace();
    let mut breaches = Vec::new();
    for invariant in &INVARIANTS {
        let found = (invariant.breaches)(&facts);
        breaches.extend(found.into_iter().map(|breach| format!("{}: {breach}", invariant.text)));
        let mut broken = facts.clone();
        (invariant.plant)(&mut broken);
        assert!(!(invariant.breaches)(&broken).is_empty(), "the check misses a planted breach: {}", invariant.text);
    }
    assert!(breaches.is_empty(), "\n{}", breaches.join("\n"));
}

#[test]
fn the_architecture_document_lists_the_checked_invariants() {
    let paragraphs = include_str!("../../ARCHITECTURE.md").split("\n\n");
    let texts = paragraphs.filter_map(|paragraph| paragraph.strip_prefix("**Architecture Invariant:** "));
    let listed: BTreeSet<String> = texts.map(|text| text.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    let checked = INVARIANTS.iter().map(|invariant| invariant.text.to_owned()).collect();
    assert_eq!(listed, checked);
}
