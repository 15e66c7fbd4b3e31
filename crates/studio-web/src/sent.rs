use serde::Serialize;
use tsify::{Ts, Tsify};

use crate::error::{FacadeError, Result};

/// Converts a message to a plain object.
pub(crate) fn sent<T: Tsify + Serialize>(message: &T) -> Result<Ts<T>> {
    message.into_ts().map_err(|error| FacadeError::new("internal", error.to_string(), "Reload the page."))
}
