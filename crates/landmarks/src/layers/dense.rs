use std::ops::Range;

use super::activation::activated;
use super::widest;

/// Output channels that are computed together: one vector of eight numbers, or two of four.
const LANES: usize = 8;
/// Pixels that are computed together: eight vectors of sums, which leaves half of a machine's sixteen for what is read.
/// A sum is the same however many there are.
const PIXELS: usize = if cfg!(target_arch = "x86_64") { 8 } else { 4 };

/// Sums over all input channels: `out = activated(bias + skip + weights · in)`, for each pixel.
pub(crate) struct Dense {
    channels: usize,
    /// How many numbers a sum has.
    depth: usize,
    /// By block of output channels, then by input; zeros beyond the last channel.
    weights: Vec<[f32; LANES]>,
    biases: Vec<[f32; LANES]>,
    slopes: Vec<[f32; LANES]>,
}

/// A part of what is summed: the same weights over neighbouring numbers of each pixel.
pub(crate) struct Part<'a> {
    /// From the first number of the first pixel on.
    pub(crate) numbers: &'a [f32],
    /// Which of the weights.
    pub(crate) weights: Range<usize>,
}

/// What is added to the sums: a picture with as many channels or fewer, and none of the others.
#[derive(Clone, Copy)]
pub(crate) struct Skip<'a> {
    pub(crate) numbers: &'a [f32],
    pub(crate) channels: usize,
}

impl Skip<'_> {
    /// From a pixel on.
    pub(crate) fn from(self, pixel: usize) -> Self {
        Self { numbers: &self.numbers[pixel * self.channels..], channels: self.channels }
    }
}

impl Dense {
    /// From biases and weights that are given by output channel and input: `weight(channel, input)`.
    pub(crate) fn new(biases: &[f32], depth: usize, weight: impl Fn(usize, usize) -> f32) -> Self {
        let blocks = biases.len().div_ceil(LANES);
        let channels = biases.len();
        let lane = |block: usize, input: usize| {
            std::array::from_fn(|lane| {
                let channel = block * LANES + lane;
                if channel < channels { weight(channel, input) } else { 0.0 }
            })
        };
        let weights = (0..blocks).flat_map(|block| (0..depth).map(move |input| (block, input)));
        let weights = weights.map(|(block, input)| lane(block, input)).collect();
        Self { channels, depth, weights, biases: in_lanes(biases), slopes: vec![[1.0; LANES]; blocks] }
    }

    /// Output channels.
    pub(crate) fn channels(&self) -> usize {
        self.channels
    }

    /// With what follows the sums: a slope for each channel, see [`activated`].
    pub(crate) fn with_slopes(mut self, slopes: &[f32]) -> Self {
        self.slopes = in_lanes(slopes);
        self
    }

    /// All pixels of `output`. Pixel `p` sums the numbers of each part from `p · step` on.
    pub(crate) fn run(&self, parts: &[Part<'_>], step: usize, skip: Skip<'_>, output: &mut [f32]) {
        widest(
            #[inline(always)]
            || {
                let pixels = output.len() / self.channels;
                let mut done = 0;
                while done + PIXELS <= pixels {
                    self.tile::<PIXELS>(parts, step, skip, done, output);
                    done += PIXELS;
                }
                for pixel in done..pixels {
                    self.tile::<1>(parts, step, skip, pixel, output);
                }
            },
        );
    }

    #[inline(always)]
    fn tile<const P: usize>(&self, parts: &[Part<'_>], step: usize, skip: Skip<'_>, first: usize, output: &mut [f32]) {
        let output = &mut output[first * self.channels..][..P * self.channels];
        let skip_pixels = &skip.numbers[first * skip.channels..][..P * skip.channels];
        let blocks = self.weights.chunks_exact(self.depth).zip(&self.biases).zip(&self.slopes);
        for (block, ((weights, bias), slopes)) in blocks.enumerate() {
            let mut sums = [*bias; P];
            for part in parts {
                add_products(&mut sums, &part.numbers[first * step..], step, &weights[part.weights.clone()]);
            }
            for (pixel, sums) in sums.iter().enumerate() {
                let skip = &skip_pixels[pixel * skip.channels..][..skip.channels];
                let output = &mut output[pixel * self.channels..][..self.channels];
                finish(sums, slopes, skip.get(block * LANES..).unwrap_or_default(), &mut output[block * LANES..]);
            }
        }
    }
}

/// `sums[p] += Σ_k weights[k] · numbers[p · step + k]`
#[inline(always)]
fn add_products<const P: usize>(sums: &mut [[f32; LANES]; P], numbers: &[f32], step: usize, weights: &[[f32; LANES]]) {
    let pixels: [&[f32]; P] = std::array::from_fn(|p| &numbers[p * step..][..weights.len()]);
    let mut local = *sums;
    for (k, weights) in weights.iter().enumerate() {
        for (sums, pixel) in local.iter_mut().zip(&pixels) {
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum += pixel[k] * weight;
            }
        }
    }
    *sums = local;
}

/// Writes the sums of one pixel's block of channels.
#[inline(always)]
fn finish(sums: &[f32; LANES], slopes: &[f32; LANES], skip: &[f32], output: &mut [f32]) {
    let skip = match skip.first_chunk::<LANES>() {
        Some(skip) => *skip,
        None => std::array::from_fn(|lane| skip.get(lane).copied().unwrap_or_default()),
    };
    let finished: [f32; LANES] = std::array::from_fn(|lane| activated(sums[lane] + skip[lane], slopes[lane]));
    match output.first_chunk_mut::<LANES>() {
        Some(output) => *output = finished,
        None => output.iter_mut().zip(finished).for_each(|(output, finished)| *output = finished),
    }
}

fn in_lanes(numbers: &[f32]) -> Vec<[f32; LANES]> {
    let lane = |block: &[f32]| std::array::from_fn(|lane| block.get(lane).copied().unwrap_or_default());
    numbers.chunks(LANES).map(lane).collect()
}
