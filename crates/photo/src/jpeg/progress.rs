//! What the scans so far have told of each coefficient.

use super::header::{Frame, Scan};

/// Bits that are left out of each coefficient of each component; `None` where there was no scan of it.
pub(crate) struct Progress {
    left_out: Vec<[Option<u8>; 64]>,
}

impl Progress {
    pub(crate) fn new(frame: &Frame) -> Self {
        Self { left_out: vec![[None; 64]; frame.components.len()] }
    }

    /// Takes in a scan; `None` if it repeats what was told, or refines what was not.
    pub(crate) fn see(&mut self, scan: &Scan) -> Option<()> {
        let expected = (scan.high > 0).then_some(scan.high);
        for of in &scan.components {
            for left_out in &mut self.left_out[of.index][scan.first..=scan.last] {
                if *left_out != expected {
                    return None;
                }
                *left_out = Some(scan.low);
            }
        }
        Some(())
    }

    /// Whether at most the last bit of any coefficient is left out.
    pub(crate) fn is_nearly_complete(&self) -> bool {
        self.left_out.as_flattened().iter().all(|left_out| left_out.is_some_and(|bits| bits <= 1))
    }
}
