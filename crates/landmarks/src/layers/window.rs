use std::ops::Range;

use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, ensure};

/// How a kernel slides over a picture; each pair is vertical, horizontal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Window {
    /// Taps.
    pub(crate) kernel: [usize; 2],
    /// Pixels from one place of the kernel to the next.
    pub(crate) strides: [usize; 2],
    /// Pixels from one tap to the next.
    pub(crate) dilations: [usize; 2],
    /// Pixels outside the picture, above and left of it.
    pub(crate) before: [usize; 2],
    /// Pixels outside the picture, below and right of it.
    pub(crate) after: [usize; 2],
}

/// Neighbouring places of the kernel along one axis at which the same taps are inside the picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Span {
    /// Pixels of the output.
    pub(crate) places: Range<usize>,
    /// Those of the kernel that are inside.
    pub(crate) taps: Range<usize>,
}

/// No attribute of a face network comes near.
const LARGEST: usize = 1 << 12;

impl Window {
    /// One pixel.
    pub(crate) const POINT: Self =
        Self { kernel: [1; 2], strides: [1; 2], dilations: [1; 2], before: [0; 2], after: [0; 2] };

    /// Fails if there is no such window.
    pub(crate) fn checked(self) -> TractResult<Self> {
        let steps = [self.kernel, self.strides, self.dilations].concat();
        let pads = [self.before, self.after].concat();
        ensure!(
            steps.iter().all(|number| (1..=LARGEST).contains(number)) && pads.iter().all(|pad| *pad <= LARGEST),
            "a window that cannot be: {self:?}"
        );
        Ok(self)
    }

    /// Height and width of what comes out.
    pub(crate) fn output(&self, extents: [usize; 2]) -> TractResult<[usize; 2]> {
        let along = |axis: usize| -> TractResult<usize> {
            let reach = (self.kernel[axis] - 1) * self.dilations[axis] + 1;
            let room = (extents[axis] + self.before[axis] + self.after[axis]).checked_sub(reach);
            let room = room.with_context(|| format!("{self:?} is larger than a picture of {extents:?} pixels"))?;
            Ok(room / self.strides[axis] + 1)
        };
        Ok([along(0)?, along(1)?])
    }

    /// The taps that are inside a picture with so many pixels along an axis, at one place of the output.
    pub(crate) fn taps(&self, axis: usize, place: usize, extent: usize) -> Range<usize> {
        let (start, dilation) = (place * self.strides[axis], self.dilations[axis]);
        let end = (extent + self.before[axis]).saturating_sub(start).div_ceil(dilation).min(self.kernel[axis]);
        self.before[axis].saturating_sub(start).div_ceil(dilation).min(end)..end
    }

    /// The pixel under a tap that is inside.
    pub(crate) fn pixel(&self, axis: usize, place: usize, tap: usize) -> usize {
        place * self.strides[axis] + tap * self.dilations[axis] - self.before[axis]
    }

    /// All places along an axis, together where the same taps are inside.
    pub(crate) fn spans(&self, axis: usize, places: usize, extent: usize) -> Vec<Span> {
        let mut spans: Vec<Span> = Vec::new();
        for place in 0..places {
            let taps = self.taps(axis, place, extent);
            match spans.last_mut() {
                Some(span) if span.taps == taps => span.places.end = place + 1,
                _ => spans.push(Span { places: place..place + 1, taps }),
            }
        }
        spans
    }
}
