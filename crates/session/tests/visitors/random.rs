//! Sequences of random actions: nothing panics, and what holds of a session holds after each.
//!
//! `ROSTO_ACTIONS` and `ROSTO_SEED` ask for a longer run, or another one. A sequence that fails is made as short as it can be
//! before it is shown.

use std::env;
use std::thread;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};
use rosto_session::{Intent, Session};

use crate::faces::session;
use crate::intents;
use crate::invariants::{hold, hold_deeply, seen, shape};

const ACTIONS: u64 = 20_000;
const LONGEST: usize = 400;
/// A long run tells of itself.
const TOLD_EVERY: u64 = 100_000;
/// Every so many actions, everything is read, written, taken back and replayed.
const DEEPLY_EVERY: usize = 50;

#[test]
fn random_visitors_break_nothing() {
    let asked = |name: &str| env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let (actions, seed) = (asked("ROSTO_ACTIONS").unwrap_or(ACTIONS), asked("ROSTO_SEED").unwrap_or(0));
    let visitors = thread::available_parallelism().map_or(1, usize::from) as u64;
    thread::scope(|scope| {
        let walks: Vec<_> = (0..visitors)
            .map(|visitor| scope.spawn(move || walk(actions.div_ceil(visitors), seed * visitors + visitor)))
            .collect();
        let done: u64 = walks.into_iter().map(|walk| walk.join().unwrap()).sum();
        println!("{done} actions");
        assert!(done >= actions);
    });
}

/// Makes so many actions, in many sessions; returns how many it made.
fn walk(actions: u64, seed: u64) -> u64 {
    let config = Config { cases: u32::MAX, failure_persistence: None, max_shrink_iters: 4_000, ..Config::default() };
    let bytes = seed.to_le_bytes().repeat(4);
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &bytes));
    let intents = proptest::collection::vec(intents::intent(), 1..LONGEST);
    let mut done = 0;
    while done < actions {
        let sequence = intents.new_tree(&mut runner).unwrap();
        let before = done;
        done += sequence.current().len() as u64;
        if done / TOLD_EVERY > before / TOLD_EVERY {
            println!("  visitor {seed}: {done} of {actions} actions");
        }
        let outcome = runner.run_one(sequence, |sequence| visit(&sequence).map_err(TestCaseError::fail));
        if let Err(TestError::Fail(reason, shortest)) = outcome {
            panic!("{reason}, after\n{shortest:#?}");
        }
    }
    done
}

fn visit(intents: &[Intent]) -> Result<(), String> {
    let mut session = session();
    for (number, intent) in intents.iter().enumerate() {
        act(&mut session, intent).map_err(|reason| format!("{reason} (action {number})"))?;
        if number % DEEPLY_EVERY == DEEPLY_EVERY - 1 {
            there_and_back(&mut session)?;
            hold_deeply(&session)?;
        }
    }
    Ok(())
}

fn act(session: &mut Session, intent: &Intent) -> Result<(), String> {
    let before = seen(session);
    if let Err(refusal) = session.apply(intent.clone())
        && seen(session) != before
    {
        return Err(format!("{intent:?} was refused ({refusal}), and yet something changed"));
    }
    hold(session)
}

/// Undo and redo lead back to where they started.
fn there_and_back(session: &mut Session) -> Result<(), String> {
    session.apply(Intent::Commit).map_err(|error| error.to_string())?;
    let before = shape(session);
    if session.face().is_none_or(|face| !face.document().history().can_undo()) {
        return Ok(());
    }
    for intent in [Intent::Undo, Intent::Redo] {
        session.apply(intent).map_err(|error| error.to_string())?;
    }
    if shape(session) == before { Ok(()) } else { Err("undo and redo lead elsewhere".to_owned()) }
}
