//! Messages of a session to the page, as plain objects, and the form in which values travel.
//!
//! These types implement serde and generate TypeScript types; types of the domain do not. An id travels as text, a
//! vector as an array of numbers, and a setting with two values as a boolean.

mod catalogue;
mod entry;
mod state;
mod target;
mod tick;
pub(crate) mod value;

use serde::Serialize;
use tsify::Tsify;

use crate::{Changed, Session, SessionError};
pub use catalogue::{Catalogue, SliderRange};
pub use entry::{Entry, MAX_LISTED};
pub use state::{PhotoState, Refusal, State};
pub use target::Target;
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
    /// Target of a drag that starts there.
    pub hovered_target: Option<Target>,
    /// Whether the pressed pointer has grabbed something; if not, it orbits the view.
    pub has_grabbed: bool,
}

impl Session {
    /// Applies an intent and returns the answer for the page.
    ///
    /// # Errors
    /// See [`Self::apply`].
    pub fn answer(&mut self, intent: crate::Intent) -> Result<Applied, SessionError> {
        let changed = self.apply(intent)?;
        let hovered = self.hovered().vertex;
        let hovered_target = hovered.map(|vertex| self.target_at(vertex)).transpose()?;
        Ok(Applied { changed, hovered, hovered_target, has_grabbed: self.has_grabbed() })
    }
}
