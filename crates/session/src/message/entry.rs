use rosto_studio::EntryStatus;
use serde::Serialize;
use tsify::Tsify;

use super::Target;
use crate::rows::Row;
use crate::{OpenFace, Session};

/// Maximum number of entries in a [`State`](crate::State); the latest ones are listed.
pub const MAX_LISTED: usize = 100;

/// An entry of the history.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Entry {
    /// Index in the history, from 0.
    pub index: usize,
    /// The object that it edits.
    pub target: Target,
    /// Length of its offset, or its share or weight, in `unit`.
    pub amount: f64,
    /// Unit of `amount`: "mm" or "%".
    pub unit: &'static str,
    /// Whether it is switched on.
    pub is_enabled: bool,
    /// Density that it waits for, if that is higher than the displayed one.
    pub waits_for_density: Option<u32>,
    /// Whether it has no solution on the displayed mesh and is skipped.
    pub is_impossible: bool,
}

impl Session {
    /// The latest entries of the history, oldest first.
    pub(super) fn latest_entries(&self) -> Vec<Entry> {
        let rows = self.face().map_or(&[][..], OpenFace::rows);
        rows[rows.len().saturating_sub(MAX_LISTED)..].iter().map(|row| self.entry(row)).collect()
    }

    fn entry(&self, row: &Row) -> Entry {
        Entry {
            index: row.index,
            target: self.target(row.target),
            amount: row.amount,
            unit: row.unit,
            is_enabled: row.status != EntryStatus::Off,
            waits_for_density: match row.status {
                EntryStatus::Waits { level } => Some(level),
                _ => None,
            },
            is_impossible: matches!(row.status, EntryStatus::Impossible(_)),
        }
    }
}
