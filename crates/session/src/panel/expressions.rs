use rosto_studio::{Expression, Mirror};

use super::build::{button, check, group, slider};
use super::name::word;
use super::widget::{GroupLook, Widget};
use super::{PER_CENT, Phrase};
use crate::message::value::switched;
use crate::{Intent, Look, OpenFace, Range, Session};

/// Difference below which two weights are the same.
const SAME_WEIGHT: f64 = 0.005;

const WEIGHT: Range = Range { min: 0.0, max: PER_CENT, step: 1.0, neutral: 0.0 };

/// Areas of the face: key of the name, and prefixes of the expressions' ids.
const AREAS: [(&str, &[&str]); 5] = [
    ("expressions.eye", &["eye"]),
    ("expressions.brow", &["brow"]),
    ("expressions.jaw", &["jaw"]),
    ("expressions.mouth", &["mouth"]),
    ("expressions.cheek", &["cheek", "nose"]),
];

/// Motions to one side: left and right are opposites, not a symmetric pair.
const SIDEWAYS: [Expression; 4] =
    [Expression::JawLeft, Expression::JawRight, Expression::MouthLeft, Expression::MouthRight];

/// Ready-made looks, and a slider for each expression.
pub(super) fn section(session: &Session) -> Widget {
    let weights = session.face().map(OpenFace::weights).unwrap_or([0.0; Expression::ALL.len()]);
    let looks = Look::ALL.map(|look| chip(look, &weights)).into();
    let widgets =
        vec![group("looks", GroupLook::Chips, looks), group("expressions.all", GroupLook::Fold, all(session))];
    group("section.expressions", GroupLook::Section, widgets).on("shape").open()
}

fn chip(look: Look, weights: &[f64; Expression::ALL.len()]) -> Widget {
    let mut pairs = weights.iter().zip(look.weights());
    let is_on = pairs.all(|(now, of_look)| (now - of_look).abs() < SAME_WEIGHT);
    check(format!("look.{}", look.id()), is_on, move |on| Intent::Look(on.then_some(look)))
}

/// Expression sliders, by area of the face.
fn all(session: &Session) -> Vec<Widget> {
    let mirror = session.edit_options().mirror;
    let both = check("expressions.both", mirror == Mirror::On, |on| Intent::Mirror(switched(on)));
    let areas = AREAS.map(|(id, prefixes)| {
        let is_there = |expression: &Expression| prefixes.iter().any(|prefix| expression.id().starts_with(prefix));
        let sliders = Expression::ALL.into_iter().filter(is_there).map(|one| weight(session, one)).collect();
        group(id, GroupLook::Fold, sliders)
    });
    let rest = button("expressions.rest", Intent::ResetExpressions);
    [both].into_iter().chain(areas).chain([rest]).collect()
}

/// With the mirror, one slider controls each pair.
fn weight(session: &Session, expression: Expression) -> Widget {
    let value = session.face().map_or(0.0, |face| face.weight(expression));
    let is_right = expression.id().ends_with("Right") && !SIDEWAYS.contains(&expression);
    let is_mirrored = session.edit_options().mirror == Mirror::On;
    let set = move |value: f64| Intent::Express(expression, value / PER_CENT);
    slider(format!("expression.{}", expression.id()), WEIGHT, "%", PER_CENT * value, set)
        .labelled(name(expression, is_mirrored))
        .hidden(is_mirrored && is_right)
}

fn name(expression: Expression, is_mirrored: bool) -> Phrase {
    let id = expression.id();
    let is_pair = is_mirrored && !SIDEWAYS.contains(&expression);
    let bare = id.strip_suffix("Left").or_else(|| id.strip_suffix("Right")).filter(|_| is_pair);
    word("expression", bare.unwrap_or(id))
}

/// Speech after a commit of an expression.
pub(crate) fn shown(session: &Session, expression: Expression, weight: f64) -> Phrase {
    let name = name(expression, session.edit_options().mirror == Mirror::On);
    Phrase::word("expression.shown").with("name", name).number("n", PER_CENT * weight, 0)
}
