//! Random intents do not panic, and the session's invariants hold after each of them.

use proptest::collection::vec;
use proptest::prelude::*;
use rosto_session::{Intent, Session};

use crate::faces::session;
use crate::intents;
use crate::invariants::{check, check_thoroughly, seen, shape};

/// Interval of the expensive checks, in intents.
const DEEPLY_EVERY: usize = 50;

/// An eighth of the usual cases, because each case is a long sequence.
fn config() -> ProptestConfig {
    let config = ProptestConfig::default();
    ProptestConfig { cases: config.cases.div_ceil(8), max_shrink_iters: 4_000, ..config }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn invariants_hold_under_any_intents(intents in vec(intents::anything(), 1..150)) {
        run(&intents)?;
    }

    #[test]
    fn invariants_hold_under_edits(intents in vec(intents::editing(), 1..150)) {
        run(&intents)?;
    }

    #[test]
    fn invariants_hold_under_pointing_and_viewing(intents in vec(intents::looking(), 1..150)) {
        run(&intents)?;
    }

    #[test]
    fn invariants_hold_under_mesh_changes(intents in vec(intents::meshing(), 1..150)) {
        run(&intents)?;
    }
}

fn run(intents: &[Intent]) -> Result<(), TestCaseError> {
    let mut session = session();
    for some in intents.chunks(DEEPLY_EVERY) {
        some.iter().try_for_each(|intent| act(&mut session, intent))?;
        undo_and_redo(&mut session)?;
        check_thoroughly(&session).map_err(TestCaseError::fail)?;
    }
    Ok(())
}

fn act(session: &mut Session, intent: &Intent) -> Result<(), TestCaseError> {
    let before = seen(session);
    if let Err(refusal) = session.apply(intent.clone()) {
        prop_assert!(seen(session) == before, "{intent:?} was refused ({refusal}) but changed the session");
    }
    check(session).map_err(TestCaseError::fail)
}

/// Checks that undo and redo restore the shape.
fn undo_and_redo(session: &mut Session) -> Result<(), TestCaseError> {
    apply(session, Intent::Commit)?;
    let before = shape(session);
    if session.face().is_some_and(|face| face.document().history().can_undo()) {
        [Intent::Undo, Intent::Redo].into_iter().try_for_each(|intent| apply(session, intent))?;
    }
    prop_assert!(shape(session) == before, "undo and redo give another shape");
    Ok(())
}

fn apply(session: &mut Session, intent: Intent) -> Result<(), TestCaseError> {
    session.apply(intent).map(drop).map_err(|error| TestCaseError::fail(error.to_string()))
}
