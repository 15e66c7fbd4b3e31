use rosto_studio::Switch;

use super::build::{check, group, slot};
use super::selection::anchors;
use super::widget::{ChoiceLook, GroupLook, Widget};
use crate::message::value::switched;
use crate::{Choice, Intent, Session};

/// Settings of the solver, and the paper's experiment.
pub(super) fn section(session: &Session) -> Widget {
    group(
        "section.advanced",
        GroupLook::Section,
        vec![
            session.setting("operator", Choice::Operator, ChoiceLook::List),
            session.setting("constraint", Choice::Constraint, ChoiceLook::List),
            session.setting("details", Choice::Details, ChoiceLook::List),
            session.setting("anchors", Choice::Anchors, ChoiceLook::List),
            anchors(session),
            check("anchors.shown", session.view().anchors == Switch::On, |on| Intent::MarkAnchors(switched(on))),
            group("section.paper", GroupLook::Fold, vec![slot("paper")]),
        ],
    )
    .on("shape")
    .expert()
}
