use std::ops::Range;

use super::activation::activated;
use super::widest;
use super::window::{Span, Window};

/// Sums over the taps of a window, for each channel by itself: `out = activated(bias + Σ weight · in)`.
pub(crate) struct Depthwise {
    window: Window,
    /// By tap, then by channel.
    weights: Vec<f32>,
    biases: Vec<f32>,
    slopes: Vec<f32>,
}

/// Channels that are computed together.
const LANES: usize = 8;
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

    pub(crate) fn window(&self) -> &Window {
        &self.window
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
        for Span { places, taps: columns } in spans {
            if rows.len() == 3 && self.is_usual(columns) {
                let step = self.window.strides[1] * channels;
                let rows = [0, 1, 2].map(|row| at(row, places.start, 0));
                let pixels = output[places.start * channels..].chunks_exact_mut(channels);
                widest(
                    #[inline(always)]
                    || {
                        for (x, output) in pixels.take(places.len()).enumerate() {
                            self.pixel_of_all(rows.map(|row| &row[x * step..]), output);
                        }
                    },
                );
                continue;
            }
            for x in places.clone() {
                let taps = rows.clone().flat_map(|row| columns.clone().map(move |column| (row, column)));
                let taps = taps.map(|(row, column)| (row * self.window.kernel[1] + column, at(row, x, column)));
                self.pixel(taps, &mut output[x * channels..][..channels]);
            }
        }
    }

    /// Whether this is the usual kernel, all of its columns inside.
    fn is_usual(&self, columns: &Range<usize>) -> bool {
        [self.window.kernel[0], self.window.kernel[1], columns.len()] == [3; 3] && self.window.dilations[1] == 1
    }

    /// One pixel from as many taps as there are.
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

    /// The same, with the nine taps of the usual kernel, three neighbours in each row, and no sum in between written.
    #[inline(always)]
    fn pixel_of_all(&self, rows: [&[f32]; 3], output: &mut [f32]) {
        let channels = output.len();
        let taps: [&[f32]; USUAL] = std::array::from_fn(|tap| &rows[tap / 3][tap % 3 * channels..][..channels]);
        let mut done = 0;
        while done + LANES <= channels {
            self.lanes::<LANES>(&taps, done, output);
            done += LANES;
        }
        for channel in done..channels {
            self.lanes::<1>(&taps, channel, output);
        }
    }

    /// So many channels of such a pixel, from the first on.
    #[inline(always)]
    fn lanes<const N: usize>(&self, taps: &[&[f32]; USUAL], first: usize, output: &mut [f32]) {
        let mut sums: [f32; N] = lanes(&self.biases, first);
        for (tap, numbers) in taps.iter().enumerate() {
            let numbers: [f32; N] = lanes(numbers, first);
            let weights: [f32; N] = lanes(&self.weights, tap * output.len() + first);
            for ((sum, number), weight) in sums.iter_mut().zip(numbers).zip(weights) {
                *sum += number * weight;
            }
        }
        let slopes: [f32; N] = lanes(&self.slopes, first);
        let activated: [f32; N] = std::array::from_fn(|lane| activated(sums[lane], slopes[lane]));
        output[first..][..N].copy_from_slice(&activated);
    }
}

/// So many numbers, from the first on.
#[inline(always)]
fn lanes<const N: usize>(numbers: &[f32], first: usize) -> [f32; N] {
    let mut lanes = [0.0; N];
    lanes.copy_from_slice(&numbers[first..][..N]);
    lanes
}
