//! Messages of a session to the page, as plain objects, and the form in which values travel.
//!
//! These types implement serde and generate TypeScript types; types of the domain do not. An id travels as text, a
//! vector as an array of numbers, and a setting with two values as a boolean.

mod catalogue;
mod state;
mod tick;
pub(crate) mod value;

use serde::Serialize;
use tsify::Tsify;

use crate::{Changed, Phrase, Session, SessionError};
pub use catalogue::Catalogue;
pub use state::{PhotoState, State};
pub use tick::Tick;
pub use value::LightSettings;

/// Answer to an intent.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Applied {
    /// Extent of the change.
    pub changed: Changed,
    /// The vertex under the pointer or pointed at elsewhere, which is highlighted.
    pub hovered: Option<u32>,
    /// Name of what a drag that starts there moves.
    pub hovered_name: Option<Phrase>,
    /// Whether the pressed pointer has grabbed something; if not, it orbits the view.
    pub has_grabbed: bool,
    /// Announcement for screen readers.
    pub said: Option<Phrase>,
}

impl Session {
    /// Applies an intent and returns the answer for the page.
    ///
    /// # Errors
    /// See [`Self::apply`].
    pub fn answer(&mut self, intent: crate::Intent) -> Result<Applied, SessionError> {
        let intent = self.resolved(intent)?;
        let said = self.said_before(&intent);
        let selects = matches!(intent, crate::Intent::Select(_) | crate::Intent::SelectAt(_));
        let changed = self.apply(intent)?;
        let said = said.or_else(|| self.selected_name().filter(|_| selects));
        let hovered = self.hovered().vertex;
        let hovered_name = hovered.map(|vertex| self.name_at(vertex)).transpose()?;
        Ok(Applied { changed, hovered, hovered_name, has_grabbed: self.has_grabbed(), said })
    }
}
