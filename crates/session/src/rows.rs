use rosto_studio::{Amount, Document, EditTarget, EntryStatus, FaceSlider, SliderAmounts};

const MM_PER_M: f64 = 1000.0;
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
    /// Amount of each ready-made slider, in mm, that comes closest to the edits by hand up to this entry.
    by_hand_mm: SliderAmounts,
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
                Amount::Distance(distance_m) => (distance_m * MM_PER_M, "mm"),
                Amount::Share(share) | Amount::Weight(share) => (share * PER_CENT, "%"),
            };
            let status = document.status(index).cloned().unwrap_or_default();
            let target = entry.command.target();
            let by_hand_mm = self.by_hand_mm(document, index, target);
            self.rows.push(Row { index, target, amount, unit, status, by_hand_mm });
        }
    }

    /// Amount of each ready-made slider in the edits by hand up to an entry. Sliders have their own entries.
    fn by_hand_mm(&self, document: &Document, index: usize, target: EditTarget) -> SliderAmounts {
        let before_mm = self.rows.last().map(|row| row.by_hand_mm).unwrap_or_default();
        if matches!(target, EditTarget::Slider(_) | EditTarget::Expression(_)) {
            return before_mm;
        }
        let before_m = index.checked_sub(1).map(|before| document.slider_amounts_m(before)).unwrap_or_default();
        let after_m = document.slider_amounts_m(index);
        std::array::from_fn(|slider| before_mm[slider] + MM_PER_M * (after_m[slider] - before_m[slider]))
    }

    /// The entries in force that edit `target`.
    pub fn in_force(&self, target: EditTarget) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.counts() && row.target == target)
    }

    /// Value of a ready-made slider in mm: its entries in force, and its share in the edits by hand.
    pub fn slider_mm(&self, slider: FaceSlider) -> f64 {
        let by_hand_mm = self.rows.last().map_or(0.0, |row| row.by_hand_mm[slider as usize]);
        self.in_force(EditTarget::Slider(slider)).map(|row| row.amount).sum::<f64>() + by_hand_mm
    }
}
