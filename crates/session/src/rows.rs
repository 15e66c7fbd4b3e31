use rosto_studio::{Amount, Document, EditTarget, EntryStatus};

pub(crate) const PER_CENT: f64 = 100.0;

/// An entry of the history, for display.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Index in the history, from 0.
    pub index: usize,
    /// The object that it edits.
    pub target: EditTarget,
    /// Length of its offset in mm, removed asymmetry in per cent, or weight of an expression in per cent.
    pub amount: f64,
    /// Unit of `amount`: "mm" or "%".
    pub unit: &'static str,
    /// How it takes part in the displayed shape.
    pub status: EntryStatus,
}

impl Row {
    /// Whether it counts towards slider values.
    pub(crate) fn counts(&self) -> bool {
        !matches!(self.status, EntryStatus::Off | EntryStatus::Impossible(_))
    }
}

/// The history for display, cached so that a tick does not process each entry.
#[derive(Clone)]
pub(crate) struct Rows {
    rows: Vec<Row>,
}

impl Rows {
    pub fn of(document: &Document) -> Self {
        let mut rows = Self { rows: Vec::new() };
        rows.read(document, 0);
        rows
    }

    pub fn all(&self) -> &[Row] {
        &self.rows
    }

    /// Reads the history again from entry `first` on.
    pub fn read(&mut self, document: &Document, first: usize) {
        self.rows.truncate(first);
        for (index, entry) in document.history().entries().iter().enumerate().skip(self.rows.len()) {
            let (amount, unit) = match entry.command.amount() {
                Amount::Distance(distance_m) => (distance_m * 1000.0, "mm"),
                Amount::Share(share) | Amount::Weight(share) => (share * PER_CENT, "%"),
            };
            let status = document.status(index).cloned().unwrap_or_default();
            self.rows.push(Row { index, target: entry.command.target(), amount, unit, status });
        }
    }

    /// The entries in force that edit `target`.
    pub fn in_force(&self, target: EditTarget) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.counts() && row.target == target)
    }

    /// Sum of their amounts, in mm.
    pub fn in_force_mm(&self, target: EditTarget) -> f64 {
        self.in_force(target).map(|row| row.amount).sum()
    }
}
