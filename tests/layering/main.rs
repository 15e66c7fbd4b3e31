//! The invariants of ARCHITECTURE.md: each is written there word for word, holds, and fails when it is broken.
//!
//! An invariant is an absence, looked for in what cargo resolves (transitively) or in the sources of crates. Planting a
//! dependency or a line that breaks it shows that the search works.

#![cfg(test)]

mod circles;
mod facts;
mod invariants;

use facts::Facts;
use invariants::INVARIANTS;

#[test]
fn every_invariant_holds_and_fails_when_it_is_broken() {
    let facts = Facts::of_workspace();
    let mut breaches = Vec::new();
    for invariant in &INVARIANTS {
        let found = (invariant.breaches)(&facts);
        breaches.extend(found.into_iter().map(|breach| format!("{}: {breach}", invariant.says)));
        let mut broken = facts.clone();
        (invariant.plant)(&mut broken);
        assert!(!(invariant.breaches)(&broken).is_empty(), "a planted breach goes unseen: {}", invariant.says);
    }
    assert!(breaches.is_empty(), "\n{}", breaches.join("\n"));
}

#[test]
fn the_architecture_says_what_is_checked_and_nothing_more() {
    let written = include_str!("../../ARCHITECTURE.md");
    let section = written.split("\n## Invariants\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let listed: Vec<String> = section
        .split("\n- ")
        .skip(1)
        .map(|item| item.split("\n\n").next().unwrap().split_whitespace().collect::<Vec<_>>().join(" "))
        .collect();
    let checked: Vec<&str> = INVARIANTS.iter().map(|invariant| invariant.says).collect();
    assert_eq!(listed, checked);
}
