use rosto::FileOptions;
use rosto_export::{ExportOption, SOLID_MM, Solid};

use super::Phrase;
use super::build::{choice, group, slider, text};
use super::formats::{formats, formats_help};
use super::name::word;
use super::widget::{ChoiceLook, Control, GroupLook, Tone, Widget};
use crate::files::{BACK_MM, Body, BodyFacts, THICKNESS_MM};
use crate::{Intent, Range, Session};

/// Rounding below this is not visible, in mm.
const VISIBLE_MM: f64 = 0.05;

/// Formats for 3D printing: the body and its measures.
pub(super) fn fold(session: &Session) -> Widget {
    let (files, now) = (&session.files, session.files.options);
    let [min, max] = SOLID_MM;
    let range = |neutral| Range { min, max, step: 0.1, neutral };
    let set = move |solid| Intent::FileOptions(FileOptions { solid, ..now });
    let kinds = [
        ("thickness", Solid::Thickness { mm: files.thickness_mm }),
        ("flat", Solid::FlatBack { mm: files.back_mm }),
        ("surface", Solid::Surface),
    ];
    let chosen = kinds.iter().find(|(_, kind)| *kind == now.solid).map(|(id, _)| (*id).to_owned());
    let options = kinds.iter().map(|(id, _)| (*id).to_owned()).collect();
    let control = Control::Choice { name: "solid", options, expert: &[], chosen, look: ChoiceLook::Segments };
    let kind = choice("solid", control, move |id| Some(set(kinds.iter().find(|(kind, _)| *kind == id)?.1)));
    let thickness = slider("solid.thickness.mm", range(THICKNESS_MM), "mm", files.thickness_mm, move |mm| {
        set(Solid::Thickness { mm })
    });
    let back = slider("solid.flat.mm", range(BACK_MM), "mm", files.back_mm, move |mm| set(Solid::FlatBack { mm }));
    let widgets = vec![
        kind,
        thickness.hidden(!matches!(now.solid, Solid::Thickness { .. })),
        back.hidden(!matches!(now.solid, Solid::FlatBack { .. })),
        measures(&files.body),
        text("print.error", reason(&files.body), Tone::Error),
        formats("print.formats", |format| format.supports(ExportOption::Solid)),
        formats_help("print.help", |format| format.supports(ExportOption::Solid)),
    ];
    group("print", GroupLook::Fold, widgets)
}

fn measures(body: &Body) -> Widget {
    let rows = body.facts.as_ref().map_or_else(Vec::new, rows);
    Widget::new("print.facts", Control::Facts { rows }).enabled(!body.is_stale)
}

/// Size, volume, weight and thinnest wall, and the rounding of folds if it is visible.
fn rows(body: &BodyFacts) -> Vec<(Phrase, Phrase)> {
    let amount = |key: &'static str, value, decimals| Phrase::word(key).number("n", value, decimals);
    let [x, y, z] = body.size_mm;
    let mut rows = vec![
        ("size", Phrase::word("amount.size").number("x", x, 0).number("y", y, 0).number("z", z, 0)),
        ("volume", amount("amount.cm3", body.volume_cm3, 1)),
        ("weight", amount("amount.g", body.pla_grams, 0)),
        ("thinnest", amount("amount.mm", body.thinnest_mm, 1)),
    ];
    if body.moved_mm >= VISIBLE_MM {
        rows.push(("rounded", amount("amount.mm", body.moved_mm, 1)));
    }
    rows.into_iter().map(|(name, value)| (word("print", name), value)).collect()
}

/// Reason why the body cannot be made, with an allowed length if there is one.
fn reason(body: &Body) -> Option<Phrase> {
    let error = body.error.as_ref()?;
    // Rounded down so that the suggested length works.
    let works_mm = (10.0 * error.max_mm.unwrap_or_default()).floor() / 10.0;
    if works_mm >= SOLID_MM[0] {
        return Some(Phrase::word("print.at-most").number("most", works_mm, 1));
    }
    let hint = Phrase::word(format!("error.{}.hint", error.code));
    Some(Phrase::word("print.error").with("reason", word("error", &error.code)).with("hint", hint))
}
