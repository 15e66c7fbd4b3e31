use std::collections::BTreeMap;

use rosto::ExportOption;
use serde::Deserialize;
use tsify::Tsify;

use crate::error::{self, Result, require};

/// Options of an exported file, by the ids in the catalogue's formats. A missing one has its default; a format uses
/// those that it supports.
#[derive(Debug, Clone, Default, Deserialize, Tsify)]
#[serde(transparent)]
pub struct FileOptions(#[tsify(type = "Record<string, string>")] pub BTreeMap<String, String>);

impl FileOptions {
    /// Reads the ids.
    ///
    /// # Errors
    /// Throws `bad-choice`.
    pub(crate) fn read(&self) -> Result<rosto::FileOptions> {
        let mut options = rosto::FileOptions::default();
        for (option, text) in &self.0 {
            options.set(require(ExportOption::from_id(option))?, text).map_err(error::of_request)?;
        }
        Ok(options)
    }
}
