//! Random visitors: nothing panics, and the invariants of a session hold after each of their intents.

use proptest::collection::vec;
use proptest::prelude::*;
use rosto_session::{Intent, Session};

use crate::faces::session;
use crate::intents;
use crate::invariants::{hold, hold_deeply, seen, shape};

/// Reading, writing, undoing and replaying everything takes long.
const DEEPLY_EVERY: usize = 50;

/// A quarter of the cases that `PROPTEST_CASES` asks for: each is a whole visit.
fn visits() -> ProptestConfig {
    let config = ProptestConfig::default();
    ProptestConfig { cases: config.cases.div_ceil(4), max_shrink_iters: 4_000, ..config }
}

proptest! {
    #![proptest_config(visits())]

    #[test]
    fn a_visitor_who_does_anything_breaks_nothing(intents in vec(intents::anything(), 1..150)) {
        visit(&intents)?;
    }

    #[test]
    fn a_visitor_who_edits_breaks_nothing(intents in vec(intents::editing(), 1..150)) {
        visit(&intents)?;
    }

    #[test]
    fn a_visitor_who_points_and_looks_breaks_nothing(intents in vec(intents::looking(), 1..150)) {
        visit(&intents)?;
    }

    #[test]
    fn a_visitor_who_changes_meshes_breaks_nothing(intents in vec(intents::meshing(), 1..150)) {
        visit(&intents)?;
    }
}

fn visit(intents: &[Intent]) -> Result<(), TestCaseError> {
    let mut session = session();
    for some in intents.chunks(DEEPLY_EVERY) {
        some.iter().try_for_each(|intent| act(&mut session, intent))?;
        there_and_back(&mut session)?;
        hold_deeply(&session).map_err(TestCaseError::fail)?;
    }
    Ok(())
}

fn act(session: &mut Session, intent: &Intent) -> Result<(), TestCaseError> {
    let before = seen(session);
    if let Err(refusal) = session.apply(intent.clone()) {
        prop_assert!(seen(session) == before, "{intent:?} was refused ({refusal}), and yet something changed");
    }
    hold(session).map_err(TestCaseError::fail)
}

/// Undo and redo lead back to where they started.
fn there_and_back(session: &mut Session) -> Result<(), TestCaseError> {
    apply(session, Intent::Commit)?;
    let before = shape(session);
    if session.face().is_some_and(|face| face.document().history().can_undo()) {
        [Intent::Undo, Intent::Redo].into_iter().try_for_each(|intent| apply(session, intent))?;
    }
    prop_assert!(shape(session) == before, "undo and redo lead elsewhere");
    Ok(())
}

fn apply(session: &mut Session, intent: Intent) -> Result<(), TestCaseError> {
    session.apply(intent).map(drop).map_err(|error| TestCaseError::fail(error.to_string()))
}
