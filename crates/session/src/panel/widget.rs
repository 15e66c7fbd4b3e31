use std::borrow::Cow;
use std::fmt;
use std::rc::Rc;

use serde::Serialize;
use tsify::Tsify;

use super::Phrase;
use crate::{Intent, Range, Value};

/// A part of a panel. Its id is also the key of its label.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Widget {
    /// Unique id, such as "slider.nose-width".
    #[tsify(type = "string")]
    pub id: Cow<'static, str>,
    /// Label in place of the word of the id.
    pub label: Option<Phrase>,
    /// Who sees it.
    pub level: Level,
    /// Whether it does not apply now.
    pub is_hidden: bool,
    /// Whether it can be used now.
    pub is_enabled: bool,
    /// Its kind and value.
    pub control: Control,
    #[serde(skip)]
    action: Action,
}

/// Who sees a widget.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum Level {
    /// Everyone.
    Usual,
    /// Visitors who have chosen the expert settings.
    Expert,
}

/// Kind and value of a widget.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(tag = "kind", rename_all = "kebab-case", rename_all_fields = "camelCase")]
pub enum Control {
    /// Further widgets.
    Group {
        /// Arrangement.
        look: GroupLook,
        /// Tab of a section.
        tab: Option<&'static str>,
        /// Whether a fold is open at first.
        is_open: bool,
        /// The widgets, in display order.
        widgets: Vec<Widget>,
    },
    /// A number in a range.
    Slider {
        /// Range and neutral value.
        range: Range,
        /// The value.
        value: f64,
        /// Unit next to the number.
        unit: &'static str,
        /// Axis whose colour it has: "x", "y" or "z".
        axis: Option<&'static str>,
    },
    /// A switch.
    Check {
        /// Whether it is on.
        on: bool,
        /// Texts after the label.
        notes: Vec<Phrase>,
    },
    /// One of several values.
    Choice {
        /// Prefix of the words of the values; `name.value.help` describes the chosen one.
        name: &'static str,
        /// Ids of the values.
        options: Vec<String>,
        /// Ids that only experts see.
        expert: &'static [&'static str],
        /// The chosen id; none if the value is another one.
        chosen: Option<String>,
        /// Arrangement.
        look: ChoiceLook,
    },
    /// An sRGB colour.
    Colour {
        /// The colour.
        rgb: [u8; 3],
    },
    /// A button.
    Button {
        /// Whether the page performs its action, rather than the session.
        is_of_page: bool,
    },
    /// A text; none is empty.
    Text {
        /// The text.
        phrase: Option<Phrase>,
        /// Purpose.
        tone: Tone,
    },
    /// A list of names and values.
    Facts {
        /// Name and value of each row.
        rows: Vec<(Phrase, Phrase)>,
    },
    /// A place that the page fills.
    Slot,
}

/// Arrangement of a group.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum GroupLook {
    /// A section that folds.
    Section,
    /// A section without a visible title.
    Plain,
    /// A part of a section that folds.
    Fold,
    /// Widgets below each other, with a common name for screen readers.
    Stack,
    /// The same, with a visible name.
    Titled,
    /// Sliders with short names, one in each line.
    Lines,
    /// Widgets next to each other.
    Row,
    /// Switches as chips, in lines.
    Chips,
}

/// Arrangement of a choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum ChoiceLook {
    /// Buttons in one row.
    Segments,
    /// Buttons in rows of two.
    ByTwo,
    /// Buttons in rows of three.
    ByThree,
    /// A list that opens.
    List,
    /// Buttons with icons, whose names are `name-value`, in one line that scrolls.
    Icons,
}

/// Purpose of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum Tone {
    /// An explanation.
    Help,
    /// A change that screen readers announce.
    Status,
    /// Work that goes on for some time.
    Busy,
    /// A success.
    Success,
    /// A limit to know of, such as a wall that may break.
    Warning,
    /// An error.
    Error,
}

/// Intent of a value; none if the value has another type.
#[derive(Clone, Default)]
struct Action(Option<Rc<dyn Fn(Value) -> Option<Intent>>>);

impl fmt::Debug for Action {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "Action" } else { "None" })
    }
}

/// Functions cannot be compared. A message for a widget uses the action of the current panel.
impl PartialEq for Action {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Widget {
    pub(super) fn new(id: impl Into<Cow<'static, str>>, control: Control) -> Self {
        let (label, action) = (None, Action::default());
        Self { id: id.into(), label, level: Level::Usual, is_hidden: false, is_enabled: true, control, action }
    }

    pub(super) fn acting(mut self, action: impl Fn(Value) -> Option<Intent> + 'static) -> Self {
        self.action = Action(Some(Rc::new(action)));
        self
    }

    /// The intent of a value; none if the widget has another type of value, or if the page performs its action.
    pub(super) fn intent(&self, value: Value) -> Option<Intent> {
        self.action.0.as_ref()?(value)
    }

    pub(super) fn expert(self) -> Self {
        Self { level: Level::Expert, ..self }
    }

    pub(super) fn hidden(self, is_hidden: bool) -> Self {
        Self { is_hidden, ..self }
    }

    pub(super) fn enabled(self, is_enabled: bool) -> Self {
        Self { is_enabled, ..self }
    }

    pub(super) fn labelled(self, label: Phrase) -> Self {
        Self { label: Some(label), ..self }
    }

    /// Puts a section on a tab.
    pub(super) fn on(mut self, name: &'static str) -> Self {
        if let Control::Group { tab, .. } = &mut self.control {
            *tab = Some(name);
        }
        self
    }

    pub(super) fn along(mut self, name: &'static str) -> Self {
        if let Control::Slider { axis, .. } = &mut self.control {
            *axis = Some(name);
        }
        self
    }

    pub(super) fn open(mut self) -> Self {
        if let Control::Group { is_open, .. } = &mut self.control {
            *is_open = true;
        }
        self
    }

    /// Adds a text after the label of a switch.
    pub(super) fn noted(mut self, note: impl Into<Phrase>) -> Self {
        if let Control::Check { notes, .. } = &mut self.control {
            notes.push(note.into());
        }
        self
    }

    /// The widgets inside a group.
    pub fn children(&self) -> &[Widget] {
        match &self.control {
            Control::Group { widgets, .. } => widgets,
            _ => &[],
        }
    }
}
