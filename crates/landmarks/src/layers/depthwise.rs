use std::ops::Range;

use super::activation::activated;
use super::widest;
use super::window::{Span, Window};

/// Sums over the taps of a window, for each channel by itself: `out = activated(bias + Σ weight · in)`.
pub(crate) struct Depthwise {
    pub(crate) window: Window,
    /// By tap, then by channel.
    weights: Vec<f32>,
    biases: Vec<f32>,
    slopes: Vec<f32>,
}

/// Channels that are computed together, one vector: so the weights of all taps fit into a machine's sixteen.
const LANES: usize = if cfg!(target_arch = "x86_64") { 8 } else { 4 };
/// Taps of the usual kernel, 3 × 3, for which there is a quick way.
const USUAL: usize = 9;

impl Depthwise {
    /// From biases and weights that are given by channel and tap: `weight(channel, tap)`.
    pub(crate) fn new(window: Window, biases: &[f32], weight: impl Fn(usize, usize) -> f32) -> Self {
        let taps = window.kernel.iter().product();
        let weights = (0..taps).flat_map(|tap| (0..biases.len()).map(move |channel| (channel, tap)));
        let weights = weights.map(|(channel, tap)| weight(channel, tap)).collect();
        Self { window, weights, biases: biases.to_vec(), slopes: vec![1.0; biases.len()] }
    }

    pub(crate) fn channels(&self) -> usize {
        self.biases.len()
    }

    /// With what follows the sums: a slope for each channel, see [`activated`].
    pub(crate) fn with_slopes(mut self, slopes: &[f32]) -> Self {
        self.slopes = slopes.to_vec();
        self
    }

    /// Row `y` of the output, from a picture of `height · width` pixels and the window's spans in a row of it.
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
                for Span { places, taps: columns } in spans {
                    let output = &mut output[places.start * channels..places.end * channels];
                    if rows.len() == 3 && self.is_usual(columns) {
                        let rows = [0, 1, 2].map(|row| at(row, places.start, 0));
                        self.usual(rows, self.window.strides[1] * channels, output);
                        continue;
                    }
                    for (x, output) in places.clone().zip(output.chunks_exact_mut(channels)) {
                        let taps = rows.clone().flat_map(|row| columns.clone().map(move |column| (row, column)));
                        let taps = taps.map(|(row, column)| (row * self.window.kernel[1] + column, at(row, x, column)));
                        self.pixel(taps, output);
                    }
                }
            },
        );
    }

    /// Whether this is the usual kernel, all of its columns inside.
    fn is_usual(&self, columns: &Range<usize>) -> bool {
        [self.window.kernel[0], self.window.kernel[1], columns.len()] == [3; 3] && self.window.dilations[1] == 1
    }

    /// One pixel from as many taps as there are.
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

    /// Neighbouring pixels with the nine taps of the usual kernel, from the first tap in each row on; some channels at a time, so
    /// that their weights stay at hand. The last channels may be made twice.
    #[inline(always)]
    fn usual(&self, rows: [&[f32]; 3], step: usize, output: &mut [f32]) {
        let Some(last) = self.channels().checked_sub(LANES) else {
            return (0..self.channels()).for_each(|channel| self.usual_lanes::<1>(rows, step, channel, output));
        };
        for first in (0..last).step_by(LANES) {
            self.usual_lanes::<LANES>(rows, step, first, output);
        }
        self.usual_lanes::<LANES>(rows, step, last, output);
    }

    /// So many channels of these pixels, from the first on.
    #[inline(always)]
    fn usual_lanes<const N: usize>(&self, rows: [&[f32]; 3], step: usize, first: usize, output: &mut [f32]) {
        let channels = self.channels();
        let weights: [[f32; N]; USUAL] = std::array::from_fn(|tap| lanes(&self.weights, tap * channels + first));
        let (biases, slopes): ([f32; N], [f32; N]) = (lanes(&self.biases, first), lanes(&self.slopes, first));
        for (x, output) in output.chunks_exact_mut(channels).enumerate() {
            let mut sums = biases;
            // Walked in place: a call to `array::map` between them would take the weights out of their registers.
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

/// So many numbers, from the first on.
#[inline(always)]
fn lanes<const N: usize>(numbers: &[f32], first: usize) -> [f32; N] {
    let mut lanes = [0.0; N];
    lanes.copy_from_slice(&numbers[first..][..N]);
    lanes
}
