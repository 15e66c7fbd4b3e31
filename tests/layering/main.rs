//! The invariants of ARCHITECTURE.md: each stands there word for word, holds, and would be missed.
//!
//! An invariant is an absence, looked for in what cargo resolves (transitively) or in the sources of crates. That the
//! looking works is shown by planting: with a dependency or a line that breaks it, each must fail.

#![cfg(test)]

mod circles;
mod facts;
mod graph;
mod invariants;
mod sources;

use facts::Facts;
use invariants::INVARIANTS;

#[test]
fn every_invariant_holds() {
    let facts = Facts::of_workspace();
    let breaches: Vec<String> = INVARIANTS
        .iter()
        .flat_map(|invariant| {
            (invariant.breaches)(&facts).into_iter().map(|breach| format!("{}: {breach}", invariant.says))
        })
        .collect();
    assert!(breaches.is_empty(), "\n{}", breaches.join("\n"));
}

#[test]
fn every_invariant_fails_when_it_is_broken() {
    let facts = Facts::of_workspace();
    for invariant in &INVARIANTS {
        let mut broken = facts.clone();
        (invariant.plant)(&mut broken);
        let breaches = (invariant.breaches)(&broken);
        assert!(!breaches.is_empty(), "a planted breach goes unseen: {}", invariant.says);
        println!("planted: {}", breaches.join("; "));
    }
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
