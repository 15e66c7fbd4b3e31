use rosto_studio::{Amount, Document, EditTarget, EntryStatus};

pub(crate) const PER_CENT: f64 = 100.0;

/// One entry of the history, as people read it.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Place in the history, from 0.
    pub index: usize,
    /// What it works on.
    pub target: EditTarget,
    /// How far it moves what it moves, in mm, or how many per cent of the asymmetry it takes away or of an expression it adds.
    pub amount: f64,
    /// What `amount` counts: "mm" or "%".
    pub unit: &'static str,
    /// How it takes part in the shape.
    pub status: EntryStatus,
}

impl Row {
    /// Whether it takes part in where sliders stand.
    pub(crate) fn counts(&self) -> bool {
        !matches!(self.status, EntryStatus::Off | EntryStatus::Impossible(_))
    }
}

/// The history as people read it, so that nothing is worked out of every entry again at each tick.
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

    /// Reads the history again from an entry on.
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

    /// The entries in force that work on `target`.
    pub fn in_force(&self, target: EditTarget) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.counts() && row.target == target)
    }

    /// What those add up to, in mm.
    pub fn in_force_mm(&self, target: EditTarget) -> f64 {
        self.in_force(target).map(|row| row.amount).sum()
    }
}
