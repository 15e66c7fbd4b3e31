//! Progress of the scans of each coefficient.

use super::header::{Frame, Scan};

/// Number of low bits still missing from each coefficient of each component; `None` before its first scan.
pub(crate) struct Progress {
    missing_bits: Vec<[Option<u8>; 64]>,
}

impl Progress {
    pub(crate) fn new(frame: &Frame) -> Self {
        Self { missing_bits: vec![[None; 64]; frame.components.len()] }
    }

    /// Records a scan; `None` if it repeats bits, or refines a coefficient that has no earlier scan.
    pub(crate) fn record(&mut self, scan: &Scan) -> Option<()> {
        let expected = (scan.high > 0).then_some(scan.high);
        for selected in &scan.components {
            for missing in &mut self.missing_bits[selected.index][scan.first..=scan.last] {
                if *missing != expected {
                    return None;
                }
                *missing = Some(scan.low);
            }
        }
        Some(())
    }

    /// Whether no coefficient lacks more than its last bit.
    pub(crate) fn is_nearly_complete(&self) -> bool {
        self.missing_bits.as_flattened().iter().all(|missing| missing.is_some_and(|bits| bits <= 1))
    }
}
