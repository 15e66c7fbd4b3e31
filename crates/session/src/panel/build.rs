//! Constructors of widgets.

use std::borrow::Cow;

use super::Phrase;
use super::widget::{Control, GroupLook, Tone, Widget};
use crate::{Intent, Range, Value};

pub(super) fn group(id: impl Into<Cow<'static, str>>, look: GroupLook, widgets: Vec<Widget>) -> Widget {
    Widget::new(id, Control::Group { look, tab: None, is_open: false, widgets })
}

pub(super) fn slider(
    id: impl Into<Cow<'static, str>>,
    range: Range,
    unit: &'static str,
    value: f64,
    act: impl Fn(f64) -> Intent + 'static,
) -> Widget {
    Widget::new(id, Control::Slider { range, value, unit, axis: None }).acting(move |value| match value {
        Value::Number(number) => Some(act(number)),
        _ => None,
    })
}

pub(super) fn check(id: impl Into<Cow<'static, str>>, on: bool, act: impl Fn(bool) -> Intent + 'static) -> Widget {
    Widget::new(id, Control::Check { on, notes: Vec::new() }).acting(move |value| match value {
        Value::Flag(on) => Some(act(on)),
        _ => None,
    })
}

pub(super) fn choice(id: &'static str, control: Control, act: impl Fn(String) -> Option<Intent> + 'static) -> Widget {
    Widget::new(id, control).acting(move |value| match value {
        Value::Text(id) => act(id),
        _ => None,
    })
}

pub(super) fn colour(id: &'static str, rgb: [u8; 3], act: impl Fn([u8; 3]) -> Intent + 'static) -> Widget {
    Widget::new(id, Control::Colour { rgb }).acting(move |value| match value {
        Value::Colour(rgb) => Some(act(rgb)),
        _ => None,
    })
}

pub(super) fn button(id: &'static str, intent: Intent) -> Widget {
    Widget::new(id, Control::Button { is_of_page: false }).acting(move |_| Some(intent.clone()))
}

/// A button whose action belongs to the page, such as a download.
pub(super) fn page_button(id: impl Into<Cow<'static, str>>, label: impl Into<Phrase>) -> Widget {
    Widget::new(id, Control::Button { is_of_page: true }).labelled(label.into())
}

pub(super) fn text(id: &'static str, phrase: Option<Phrase>, tone: Tone) -> Widget {
    Widget::new(id, Control::Text { phrase, tone })
}

/// An explanation that does not change; its id is its word.
pub(super) fn help(id: &'static str) -> Widget {
    text(id, Some(Phrase::word(id)), Tone::Help)
}

pub(super) fn slot(id: &'static str) -> Widget {
    Widget::new(id, Control::Slot)
}
