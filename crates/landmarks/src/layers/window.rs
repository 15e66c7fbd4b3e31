use std::ops::Range;

use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, ensure};

/// A sliding window. Pairs are (vertical, horizontal).
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Window {
    /// Number of taps.
    pub(crate) kernel: [usize; 2],
    /// Distance between adjacent positions of the kernel, px.
    pub(crate) strides: [usize; 2],
    /// Distance between adjacent taps, px.
    pub(crate) dilations: [usize; 2],
    /// Padding above and to the left, px.
    pub(crate) before: [usize; 2],
    /// Padding below and to the right, px.
    pub(crate) after: [usize; 2],
}

/// Adjacent output positions along an axis for which the same taps are inside the picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Span {
    /// Range of output pixels.
    pub(crate) positions: Range<usize>,
    /// Range of taps inside the picture.
    pub(crate) taps: Range<usize>,
}

/// Limit on attributes, far above the face networks'.
const MAX_ATTRIBUTE: usize = 1 << 12;

impl Window {
    /// A 1 × 1 kernel.
    pub(crate) const POINT: Self =
        Self { kernel: [1; 2], strides: [1; 2], dilations: [1; 2], before: [0; 2], after: [0; 2] };

    /// Returns the window if its attributes are valid.
    pub(crate) fn checked(self) -> TractResult<Self> {
        let steps = [self.kernel, self.strides, self.dilations].concat();
        let pads = [self.before, self.after].concat();
        ensure!(
            steps.iter().all(|number| (1..=MAX_ATTRIBUTE).contains(number))
                && pads.iter().all(|pad| *pad <= MAX_ATTRIBUTE),
            "invalid window: {self:?}"
        );
        Ok(self)
    }

    /// Height and width of the output.
    pub(crate) fn output(&self, extents: [usize; 2]) -> TractResult<[usize; 2]> {
        let along = |axis: usize| -> TractResult<usize> {
            let extent = (self.kernel[axis] - 1) * self.dilations[axis] + 1;
            let free = (extents[axis] + self.before[axis] + self.after[axis]).checked_sub(extent);
            let free = free.with_context(|| format!("{self:?} is larger than a picture of {extents:?} pixels"))?;
            Ok(free / self.strides[axis] + 1)
        };
        Ok([along(0)?, along(1)?])
    }

    /// The taps inside a picture with this extent along an axis, for an output position.
    pub(crate) fn taps(&self, axis: usize, position: usize, extent: usize) -> Range<usize> {
        let (start, dilation) = (position * self.strides[axis], self.dilations[axis]);
        let end = (extent + self.before[axis]).saturating_sub(start).div_ceil(dilation).min(self.kernel[axis]);
        self.before[axis].saturating_sub(start).div_ceil(dilation).min(end)..end
    }

    /// The input pixel of a tap inside the picture.
    pub(crate) fn pixel(&self, axis: usize, position: usize, tap: usize) -> usize {
        position * self.strides[axis] + tap * self.dilations[axis] - self.before[axis]
    }

    /// Groups the positions along an axis by the taps that are inside.
    pub(crate) fn spans(&self, axis: usize, positions: usize, extent: usize) -> Vec<Span> {
        let mut spans: Vec<Span> = Vec::new();
        for position in 0..positions {
            let taps = self.taps(axis, position, extent);
            match spans.last_mut() {
                Some(span) if span.taps == taps => span.positions.end = position + 1,
                _ => spans.push(Span { positions: position..position + 1, taps }),
            }
        }
        spans
    }
}
