//! Panels as data: what they show, and what their widgets do.
//!
//! [`Session::panel`] describes the panels; a page or another front end renders them. A widget is a line in one of the
//! sections: its id, its value, and the intent of another value. [`Session::panel_diff`] returns the widgets that
//! differ from those of an earlier time.

mod build;
mod choices;
mod export;
mod expressions;
mod face;
mod formats;
mod history;
mod in_photo;
mod keys;
mod method;
mod name;
mod phrase;
mod print;
mod save;
mod selection;
mod size;
mod speech;
mod view;
mod widget;

use serde::Serialize;
use tsify::Tsify;

use crate::{Changed, Intent, Range, Session, SessionError, Value};
pub(crate) use expressions::shown;
pub(crate) use face::slid;
pub use history::MAX_LISTED;
pub(crate) use keys::KEYS;
pub use keys::{Held, Key, Place};
pub use phrase::{Part, Phrase};
pub(crate) use selection::moved;
pub use widget::{ChoiceLook, Control, GroupLook, Level, Tone, Widget};

const PER_CENT: f64 = 100.0;
const CM_PER_M: f64 = 100.0;

/// Range of distances between camera and face, in cm. Selfies are not taken from closer; farther, no change is visible.
const DISTANCE_CM: Range = Range { min: 20.0, max: 300.0, step: 1.0, neutral: 50.0 };

/// A section, and whether the ticks of an edit change it.
type Section = (fn(&Session) -> Widget, bool);

/// The sections, in display order.
const SECTIONS: [Section; 12] = [
    (view::scene, false),
    (save::buttons, false),
    (save::menu, false),
    (face::section, true),
    (selection::section, true),
    (expressions::section, true),
    (in_photo::section, true),
    (history::section, false),
    (method::section, false),
    (view::section, false),
    (size::section, false),
    (export::section, false),
];

/// Widgets that have changed. A group takes the place of its earlier widgets.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
pub struct PanelDiff {
    /// The widgets.
    pub widgets: Vec<Widget>,
}

impl Session {
    /// The sections of the panels.
    pub fn panel(&self) -> Vec<Widget> {
        SECTIONS.map(|(section, _)| section(self)).into()
    }

    /// The widgets that a change of this extent has changed since `before`, which is updated.
    pub fn panel_diff(&self, before: &mut Vec<Widget>, changed: Changed) -> PanelDiff {
        let mut widgets = Vec::new();
        for (place, (section, follows_ticks)) in SECTIONS.into_iter().enumerate() {
            if changed == Changed::Tick && !follows_ticks && place < before.len() {
                continue;
            }
            let now = section(self);
            compare(before.get(place), &now, &mut widgets);
            match before.get_mut(place) {
                Some(old) => *old = now,
                None => before.push(now),
            }
        }
        PanelDiff { widgets }
    }

    /// The intent that a message for a widget means.
    pub(crate) fn resolved(&self, intent: Intent) -> Result<Intent, SessionError> {
        match intent {
            Intent::Set(id, value) => self.widget_intent(id, value),
            Intent::Push(id) => match Key::intent(&id, self) {
                Some(intent) => Ok(intent),
                None => self.widget_intent(id, Value::Flag(true)),
            },
            other => Ok(other),
        }
    }

    fn widget_intent(&self, id: String, value: Value) -> Result<Intent, SessionError> {
        let widget = SECTIONS.into_iter().find_map(|(section, _)| find(&section(self), &id).cloned());
        widget.and_then(|widget| widget.intent(value)).ok_or(SessionError::NoSuchWidget { id })
    }
}

fn find<'a>(widget: &'a Widget, id: &str) -> Option<&'a Widget> {
    if widget.id == id { Some(widget) } else { widget.children().iter().find_map(|child| find(child, id)) }
}

fn compare(before: Option<&Widget>, now: &Widget, changes: &mut Vec<Widget>) {
    match before {
        Some(old) if old == now => {}
        Some(old) if has_same_children(old, now) => {
            for (old, now) in old.children().iter().zip(now.children()) {
                compare(Some(old), now, changes);
            }
        }
        _ => changes.push(now.clone()),
    }
}

/// Whether two groups differ in their widgets' values only.
fn has_same_children(one: &Widget, other: &Widget) -> bool {
    let ids = |widget: &Widget| widget.children().iter().map(|child| child.id.clone()).collect::<Vec<_>>();
    let frame = |widget: &Widget| (widget.is_hidden, widget.is_enabled, widget.label.clone());
    !one.children().is_empty() && frame(one) == frame(other) && ids(one) == ids(other)
}
