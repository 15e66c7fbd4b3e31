//! Panels as text, in the words of a language.

use std::collections::BTreeMap;

use rosto_session::{Control, GroupLook, Level, Part, Phrase, Session, Widget};
use serde_json::Value as Json;

pub const LANGUAGES: [&str; 2] = ["en", "pt"];

pub type Words = BTreeMap<String, Json>;

pub fn words(language: &str) -> Words {
    let text = match language {
        "pt" => include_str!("../../../../web/words/pt.json"),
        _ => include_str!("../../../../web/words/en.json"),
    };
    serde_json::from_str(text).unwrap()
}

/// All widgets, groups first.
pub fn all(widgets: &[Widget]) -> Vec<&Widget> {
    widgets.iter().flat_map(|widget| [vec![widget], all(widget.children())].concat()).collect()
}

/// The widget with an id.
pub fn widget(session: &Session, id: &str) -> Widget {
    all(&session.panel()).into_iter().find(|widget| widget.id == id).unwrap_or_else(|| panic!("no widget {id}")).clone()
}

/// A widget as English text, without hidden parts.
pub fn shown(session: &Session, id: &str) -> String {
    rendered(&words("en"), &visible(&[widget(session, id)]), 0)
}

/// The widgets that are not hidden.
fn visible(widgets: &[Widget]) -> Vec<Widget> {
    let without_hidden = |widget: &Widget| {
        let mut widget = widget.clone();
        if let Control::Group { widgets, .. } = &mut widget.control {
            *widgets = visible(widgets);
        }
        widget
    };
    widgets.iter().filter(|widget| !widget.is_hidden).map(without_hidden).collect()
}

/// Ids of the widgets that only experts see.
pub fn technical(session: &Session) -> Vec<String> {
    let panel = session.panel();
    all(&panel).iter().filter(|widget| widget.level == Level::Expert).map(|widget| widget.id.to_string()).collect()
}

pub fn text(words: &Words, phrase: &Phrase) -> String {
    let word = words.get(phrase.key.as_ref()).and_then(Json::as_str);
    let mut text = word.unwrap_or_else(|| panic!("no word {:?}", phrase.key)).to_owned();
    for (name, part) in &phrase.values {
        let value = match part {
            Part::Text(text) => text.clone(),
            Part::Number(number, decimals) => format!("{number:.*}", usize::from(*decimals)),
            Part::Phrase(phrase) => self::text(words, phrase),
        };
        let place = format!("{{{name}}}");
        assert!(text.contains(&place), "{:?} has no place for {name}", phrase.key);
        text = text.replace(&place, &value);
    }
    text
}

/// Widgets as text, also hidden ones.
pub fn rendered(words: &Words, widgets: &[Widget], depth: usize) -> String {
    let line = |widget: &Widget| match &widget.control {
        Control::Group { look, widgets, .. } => {
            let inside = depth + usize::from(*look != GroupLook::Plain);
            format!("{}\n{}", label(words, widget), rendered(words, widgets, inside))
        }
        _ => format!("{}\n", lone(words, widget)),
    };
    widgets.iter().map(|widget| format!("{}{}", "  ".repeat(depth), line(widget))).collect()
}

pub fn label(words: &Words, widget: &Widget) -> String {
    text(words, &widget.label.clone().unwrap_or_else(|| Phrase::word(widget.id.clone())))
}

/// A widget that is not a group.
fn lone(words: &Words, widget: &Widget) -> String {
    let label = || label(words, widget);
    let option = |name: &str, id: &str| text(words, &Phrase::word(format!("{name}.{id}")));
    match &widget.control {
        Control::Slider { value, unit, .. } => format!("{}: {value:.1} {unit}", label()),
        Control::Check { on, notes } => {
            let notes: String = notes.iter().map(|note| format!(" ({})", text(words, note))).collect();
            format!("[{}] {}{notes}", if *on { "x" } else { " " }, label())
        }
        Control::Choice { name, options, chosen, .. } => {
            let names: Vec<String> = options.iter().map(|id| option(name, id)).collect();
            let chosen = chosen.as_ref().map(|id| option(name, id));
            format!("{}: {} of {}", label(), chosen.unwrap_or_default(), names.join(", "))
        }
        Control::Colour { rgb } => format!("{}: {rgb:?}", label()),
        Control::Button { .. } => format!("<{}>", label()),
        Control::Text { phrase, .. } => phrase.as_ref().map(|phrase| text(words, phrase)).unwrap_or_default(),
        Control::Facts { rows } => {
            rows.iter().map(|(name, value)| format!("{} = {}; ", text(words, name), text(words, value))).collect()
        }
        Control::Slot | Control::Group { .. } => format!("({})", widget.id),
    }
}
