use rosto_studio::EntryStatus;

use super::Phrase;
use super::build::{button, check, group, help, text};
use super::name::word;
use super::widget::{GroupLook, Tone, Widget};
use crate::message::value::switched;
use crate::rows::Row;
use crate::{Intent, OpenFace, Session};

/// Maximum number of listed entries; the latest ones are listed.
pub const MAX_LISTED: usize = 100;

/// The edits, latest first.
pub(super) fn section(session: &Session) -> Widget {
    let rows = session.face().map_or(&[][..], OpenFace::rows);
    let listed = rows.iter().rev().take(MAX_LISTED).map(|row| entry(session, row)).collect();
    let earlier = rows.len().saturating_sub(MAX_LISTED);
    let earlier = (earlier > 0).then(|| Phrase::word("history.earlier").with("n", earlier));
    group(
        "section.history",
        GroupLook::Section,
        vec![
            group("history", GroupLook::Stack, listed),
            text("history.earlier", earlier, Tone::Help),
            help("history.empty").hidden(!rows.is_empty()),
            group("history.changes", GroupLook::Row, buttons(session)),
        ],
    )
    .on("shape")
}

fn buttons(session: &Session) -> Vec<Widget> {
    let face = session.face();
    let history = face.map(|face| face.document().history());
    vec![
        button("undo", Intent::Undo).enabled(history.is_some_and(|history| history.can_undo())),
        button("redo", Intent::Redo).enabled(history.is_some_and(|history| history.can_redo())),
        button("reset.one", Intent::ResetSelected).enabled(face.is_some_and(OpenFace::can_reset_selection)),
        button("reset", Intent::Reset).enabled(history.is_some_and(|history| !history.entries().is_empty())),
    ]
}

/// Name and amount of an edit; switched off, it has no effect.
fn entry(session: &Session, row: &Row) -> Widget {
    let index = row.index;
    let is_on = row.status != EntryStatus::Off;
    let amount = Phrase::word(if row.unit == "%" { "amount.share" } else { "amount.mm" });
    let decimals = if row.unit == "%" { 0 } else { 1 };
    let row_check = check(format!("entry.{index}"), is_on, move |on| Intent::Switch(index, switched(on)));
    let noted = row_check.labelled(session.name_of(row.target)).noted(amount.number("n", row.amount, decimals));
    match &row.status {
        EntryStatus::Waits { level } => {
            let density = word("density", &level.to_string());
            noted.noted(Phrase::word("history.waits").with("density", density))
        }
        EntryStatus::Impossible(_) => noted.noted("history.impossible"),
        _ => noted,
    }
}
