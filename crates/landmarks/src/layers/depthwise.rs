use super::activation::activated;
use super::window::{Span, Window};

/// Sums over the taps of a window, for each channel by itself: `out = activated(bias + Σ weight · in)`.
pub(crate) struct Depthwise {
    window: Window,
    /// By tap, then by channel.
    weights: Vec<f32>,
    biases: Vec<f32>,
    slopes: Vec<f32>,
}

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
        let [tap_rows, tap_columns] = self.window.kernel;
        let rows = self.window.taps(0, y, height);
        let at = |row: usize, x: usize, column: usize| {
            let pixel = self.window.pixel(0, y, row) * width + self.window.pixel(1, x, column);
            &picture[pixel * channels..][..channels]
        };
        for Span { places, taps: columns } in spans {
            let usual = [rows.len(), columns.len(), tap_rows, tap_columns] == [3; 4];
            for x in places.clone() {
                let output = &mut output[x * channels..][..channels];
                if usual {
                    self.pixel_of_all(std::array::from_fn(|tap| at(tap / 3, x, tap % 3)), output);
                } else {
                    let taps = rows.clone().flat_map(|row| columns.clone().map(move |column| (row, column)));
                    self.pixel(taps.map(|(row, column)| (row * tap_columns + column, at(row, x, column))), output);
                }
            }
        }
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

    /// The same, with the nine taps of the usual kernel and no sum in between written.
    #[inline(always)]
    fn pixel_of_all(&self, taps: [&[f32]; USUAL], output: &mut [f32]) {
        let channels = output.len();
        let taps = taps.map(|numbers| &numbers[..channels]);
        let weights: [&[f32]; USUAL] = std::array::from_fn(|tap| &self.weights[tap * channels..][..channels]);
        let (biases, slopes) = (&self.biases[..channels], &self.slopes[..channels]);
        for channel in 0..channels {
            let mut sum = biases[channel];
            for tap in 0..USUAL {
                sum += taps[tap][channel] * weights[tap][channel];
            }
            output[channel] = activated(sum, slopes[channel]);
        }
    }
}
