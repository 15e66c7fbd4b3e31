use rosto::FileOptions;
use rosto_export::{DEPTH_MM, ExportOption, HEIGHT_MM, Print, PrintHeight, SOLID_MM, Solid};
use rosto_stage::NamedView;

use super::build::{button, choice, group, slider, text};
use super::formats::{formats, formats_help};
use super::name::word;
use super::widget::{ChoiceLook, Control, GroupLook, Tone, Widget};
use super::{PER_CENT, Phrase};
use crate::files::{Body, BodyFacts, PRINT_MM, THICKNESS_MM};
use crate::{Intent, Range, Session};

/// Rounding below this is not visible, in mm.
const VISIBLE_MM: f64 = 0.05;

/// Walls thinner than this break easily, in mm.
const FRAGILE_MM: f64 = 1.2;

/// Heights that have a button.
const HEIGHTS: [(&str, PrintHeight); 3] =
    [("40", PrintHeight::Mm(40.0)), ("80", PrintHeight::Mm(80.0)), ("life", PrintHeight::Life)];

/// Formats for 3D printing: the body and its measures.
pub(super) fn fold(session: &Session) -> Widget {
    let (body, solid) = (&session.files.body, session.files.options.print.solid);
    let is_closed = solid != Solid::Surface;
    let [kind, thickness, depth] = shape(session);
    let widgets = [kind, thickness, depth].into_iter().chain(height(session).map(|widget| widget.hidden(!is_closed)));
    let widgets = widgets.chain([
        measures(body),
        text("print.supports", body.facts.as_ref().map(supports), Tone::Help),
        text("print.thin", body.facts.as_ref().and_then(thin), Tone::Warning),
        text("print.error", reason(body), Tone::Error),
        button("print.behind", Intent::GoTo(NamedView::Back)).hidden(body.facts.is_none()),
        formats("print.formats", |format| format.supports(ExportOption::Solid)),
        formats_help("print.help", |format| format.supports(ExportOption::Solid)),
    ]);
    group("print", GroupLook::Fold, widgets.collect())
}

/// The shape, the thickness of a mask and the depth of a relief.
fn shape(session: &Session) -> [Widget; 3] {
    let (files, now) = (&session.files, session.files.options);
    let solid = now.print.solid;
    let set = move |solid| Intent::FileOptions(FileOptions { print: Print { solid, ..now.print }, ..now });
    let kinds = [
        ("thickness", Solid::Thickness { mm: files.thickness_mm }),
        ("flat", Solid::FlatBack { depth_mm: files.depth_mm }),
        ("surface", Solid::Surface),
    ];
    let kind = segments("solid", kinds, solid, set);
    let thickness = slider("solid.thickness.mm", range(SOLID_MM, 0.1, THICKNESS_MM), "mm", files.thickness_mm, {
        move |mm| set(Solid::Thickness { mm })
    });
    let usual_mm = Solid::usual_depth_mm(height_mm(session)).round();
    let depth_mm = files.depth_mm.unwrap_or(usual_mm);
    let depth = slider("solid.flat.mm", range(DEPTH_MM, 0.5, usual_mm), "mm", depth_mm, move |mm| {
        set(Solid::FlatBack { depth_mm: Some(mm) })
    });
    let (is_mask, is_relief) = (matches!(solid, Solid::Thickness { .. }), matches!(solid, Solid::FlatBack { .. }));
    [kind, thickness.hidden(!is_mask), depth.hidden(!is_relief)]
}

/// The usual heights, and any other.
fn height(session: &Session) -> [Widget; 2] {
    let now = session.files.options;
    let set = move |height| Intent::FileOptions(FileOptions { print: Print { height, ..now.print }, ..now });
    let any = slider("print.height.mm", range(HEIGHT_MM, 1.0, PRINT_MM), "mm", height_mm(session), move |mm| {
        set(PrintHeight::Mm(mm))
    });
    [segments("print.height", HEIGHTS, now.print.height, set), any]
}

/// A choice between values in one row; none is chosen for another value.
fn segments<T: PartialEq + Copy + 'static>(
    id: &'static str,
    values: [(&'static str, T); 3],
    now: T,
    set: impl Fn(T) -> Intent + 'static,
) -> Widget {
    let chosen = values.iter().find(|(_, value)| *value == now).map(|(id, _)| (*id).to_owned());
    let options = values.iter().map(|(id, _)| (*id).to_owned()).collect();
    let control = Control::Choice { name: id, options, expert: &[], chosen, look: ChoiceLook::Segments };
    choice(id, control, move |id| Some(set(values.iter().find(|(own, _)| *own == id)?.1)))
}

fn range([min, max]: [f64; 2], step: f64, neutral: f64) -> Range {
    Range { min, max, step, neutral }
}

/// Height of the print in mm, that of the face rounded.
fn height_mm(session: &Session) -> f64 {
    match session.files.options.print.height {
        PrintHeight::Mm(mm) => mm,
        PrintHeight::Life => session.face().map_or(PRINT_MM, |face| {
            PrintHeight::Life.mm(face.document().positions()).round().clamp(HEIGHT_MM[0], HEIGHT_MM[1])
        }),
    }
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

/// How to lay the body on the printer's bed, and whether it needs supports there.
fn supports(body: &BodyFacts) -> Phrase {
    let pose = if body.is_upright { "upright" } else { "lying" };
    match body.overhang_cm2 > 0.0 {
        true => Phrase::word(format!("print.{pose}.supports")).number("n", body.overhang_cm2.max(1.0), 0),
        false => Phrase::word(format!("print.{pose}")),
    }
}

/// Warning about a wall that is thinner than requested.
fn thin(body: &BodyFacts) -> Option<Phrase> {
    let key = if body.thinnest_mm < FRAGILE_MM { "print.thin.fragile" } else { "print.thin" };
    let phrase = Phrase::word(key).number("asked", body.asked_mm, 1).number("thinnest", body.thinnest_mm, 1);
    (body.thin_share > 0.0).then(|| phrase.number("share", (PER_CENT * body.thin_share).max(1.0), 0))
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
