use std::ops::Range;

use super::activation::activated;
use super::widest;
use super::window::{Span, Window};

/// A depthwise convolution: `out = activated(bias + Σ weight · in)` over the taps of a window, for each channel.
pub(crate) struct Depthwise {
    pub(crate) window: Window,
    /// By tap, then by channel.
    weights: Vec<f32>,
    biases: Vec<f32>,
    slopes: Vec<f32>,
}

/// Channels computed together, one vector each, so that the weights of nine taps fit into sixteen registers.
const LANES: usize = if cfg!(target_arch = "x86_64") { 8 } else { 4 };
/// Number of taps of a 3 × 3 kernel, which has a fast path.
const TAPS_3X3: usize = 9;

impl Depthwise {
    /// Creates the layer from one bias per channel and `weight(channel, tap)`.
    pub(crate) fn new(window: Window, biases: &[f32], weight: impl Fn(usize, usize) -> f32) -> Self {
        let taps = window.kernel.iter().product();
        let weights = (0..taps).flat_map(|tap| (0..biases.len()).map(move |channel| (channel, tap)));
        let weights = weights.map(|(channel, tap)| weight(channel, tap)).collect();
        Self { window, weights, biases: biases.to_vec(), slopes: vec![1.0; biases.len()] }
    }

    pub(crate) fn channels(&self) -> usize {
        self.biases.len()
    }

    /// Sets the activation's slope for each channel, see [`activated`].
    pub(crate) fn with_slopes(mut self, slopes: &[f32]) -> Self {
        self.slopes = slopes.to_vec();
        self
    }

    /// Computes row `y` of the output. `spans` are the window's spans along a row.
    pub(crate) fn row(
        &self,
        picture: &[f32],
        [height, width]: [usize; 2],
        spans: &[Span],
        y: usize,
        output: &mut [f32],
    ) {
        let channels = self.channels();
        let rows = self.window.taps(0, y, height);
        let at = |row: usize, x: usize, column: usize| {
            let pixel = self.window.pixel(0, y, row) * width + self.window.pixel(1, x, column);
            &picture[pixel * channels..]
        };
        widest(
            #[inline(always)]
            || {
                for Span { positions, taps: columns } in spans {
                    let output = &mut output[positions.start * channels..positions.end * channels];
                    if rows.len() == 3 && self.is_3x3(columns) {
                        let rows = [0, 1, 2].map(|row| at(row, positions.start, 0));
                        self.pixels_3x3(rows, self.window.strides[1] * channels, output);
                        continue;
                    }
                    for (x, output) in positions.clone().zip(output.chunks_exact_mut(channels)) {
                        let taps = rows.clone().flat_map(|row| columns.clone().map(move |column| (row, column)));
                        let taps = taps.map(|(row, column)| (row * self.window.kernel[1] + column, at(row, x, column)));
                        self.pixel(taps, output);
                    }
                }
            },
        );
    }

    /// Whether the kernel is 3 × 3 with all columns inside the picture.
    fn is_3x3(&self, columns: &Range<usize>) -> bool {
        [self.window.kernel[0], self.window.kernel[1], columns.len()] == [3; 3] && self.window.dilations[1] == 1
    }

    /// Computes one pixel from any taps.
    #[inline(always)]
    fn pixel<'a>(&self, taps: impl Iterator<Item = (usize, &'a [f32])>, output: &mut [f32]) {
        output.copy_from_slice(&self.biases);
        for (tap, numbers) in taps {
            let weights = &self.weights[tap * output.len()..];
            for ((sum, number), weight) in output.iter_mut().zip(numbers).zip(weights) {
                *sum += number * weight;
            }
        }
        for (sum, slope) in output.iter_mut().zip(&self.slopes) {
            *sum = activated(*sum, *slope);
        }
    }

    /// Computes adjacent pixels of a 3 × 3 kernel. `rows` start at the first tap of each row. Processes some channels
    /// at a time, so that their weights stay in registers; the last channels may be computed twice.
    #[inline(always)]
    fn pixels_3x3(&self, rows: [&[f32]; 3], step: usize, output: &mut [f32]) {
        let Some(last) = self.channels().checked_sub(LANES) else {
            return (0..self.channels()).for_each(|channel| self.lanes_3x3::<1>(rows, step, channel, output));
        };
        for first in (0..last).step_by(LANES) {
            self.lanes_3x3::<LANES>(rows, step, first, output);
        }
        self.lanes_3x3::<LANES>(rows, step, last, output);
    }

    /// Computes channels `first..first + N` of the pixels.
    #[inline(always)]
    fn lanes_3x3<const N: usize>(&self, rows: [&[f32]; 3], step: usize, first: usize, output: &mut [f32]) {
        let channels = self.channels();
        let weights: [[f32; N]; TAPS_3X3] = std::array::from_fn(|tap| lanes(&self.weights, tap * channels + first));
        let (biases, slopes): ([f32; N], [f32; N]) = (lanes(&self.biases, first), lanes(&self.slopes, first));
        for (x, output) in output.chunks_exact_mut(channels).enumerate() {
            let mut sums = biases;
            // A call to `array::map` in this loop would spill the weights from their registers.
            for (row, weights) in rows.iter().zip(weights.chunks_exact(3)) {
                let row = &row[x * step + first..][..2 * channels + N];
                for (column, weights) in weights.iter().enumerate() {
                    let numbers: [f32; N] = lanes(row, column * channels);
                    for ((sum, number), weight) in sums.iter_mut().zip(numbers).zip(weights) {
                        *sum += number * weight;
                    }
                }
            }
            for (sum, slope) in sums.iter_mut().zip(&slopes) {
                *sum = activated(*sum, *slope);
            }
            output[first..][..N].copy_from_slice(&sums);
        }
    }
}

/// Copies `N` numbers from `first` on.
#[inline(always)]
fn lanes<const N: usize>(numbers: &[f32], first: usize) -> [f32; N] {
    let mut lanes = [0.0; N];
    lanes.copy_from_slice(&numbers[first..][..N]);
    lanes
}
