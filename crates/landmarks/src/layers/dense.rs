use std::ops::Range;

use super::activation::activated;
use super::widest;

/// Output channels per block: one vector of eight numbers, or two of four.
const LANES: usize = 8;
/// Blocks computed together.
const BLOCKS: usize = if cfg!(target_arch = "x86_64") { 2 } else { 1 };
/// Pixels computed together, with eight or twelve vectors for sums. The number does not affect the results.
const PIXELS: usize = if cfg!(target_arch = "x86_64") { 4 } else { 6 };
/// The same for the last pixels of a picture.
const LAST_PIXELS: usize = 4;
/// Number of inputs that are added without a bounds check in between.
const STEP: usize = 4;

/// A matrix product per pixel: `out = activated(bias + skip + weights · in)`.
pub(crate) struct Dense {
    /// Number of output channels.
    pub(crate) channels: usize,
    /// Number of terms of a sum.
    depth: usize,
    /// By block of output channels, then by input; padded with zeros after the last channel.
    weights: Vec<[f32; LANES]>,
    biases: Vec<[f32; LANES]>,
    slopes: Vec<[f32; LANES]>,
}

/// Some terms of the sums: a range of the weights and contiguous inputs for each pixel.
pub(crate) struct Part<'a> {
    /// Inputs, starting at those of the first pixel.
    pub(crate) numbers: &'a [f32],
    /// Range of the weights.
    pub(crate) weights: Range<usize>,
}

/// A picture to add to the sums. It may have fewer channels, which come first.
#[derive(Clone, Copy)]
pub(crate) struct Skip<'a> {
    pub(crate) numbers: &'a [f32],
    pub(crate) channels: usize,
}

impl Skip<'_> {
    /// The picture from a pixel on.
    pub(crate) fn from(self, pixel: usize) -> Self {
        Self { numbers: &self.numbers[pixel * self.channels..], channels: self.channels }
    }
}

impl Dense {
    /// Creates the layer from one bias per output channel and `weight(channel, input)`.
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

    /// Sets the activation's slope for each channel, see [`activated`].
    pub(crate) fn with_slopes(mut self, slopes: &[f32]) -> Self {
        self.slopes = in_lanes(slopes);
        self
    }

    /// Computes all pixels of `output`. The inputs of pixel `p` start at `p · step` in each part.
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
                while done + LAST_PIXELS <= pixels {
                    self.tile::<LAST_PIXELS>(parts, step, skip, done, output);
                    done += LAST_PIXELS;
                }
                for pixel in done..pixels {
                    self.tile::<1>(parts, step, skip, pixel, output);
                }
            },
        );
    }

    #[inline(always)]
    fn tile<const P: usize>(&self, parts: &[Part<'_>], step: usize, skip: Skip<'_>, first: usize, output: &mut [f32]) {
        let skip = Skip { numbers: &skip.numbers[first * skip.channels..][..P * skip.channels], ..skip };
        let output = &mut output[first * self.channels..][..P * self.channels];
        let mut block = 0;
        while block + BLOCKS <= self.biases.len() {
            self.blocks::<P, BLOCKS>(parts, [first, step], skip, block, output);
            block += BLOCKS;
        }
        for block in block..self.biases.len() {
            self.blocks::<P, 1>(parts, [first, step], skip, block, output);
        }
    }

    /// Computes `B` blocks of channels of a tile.
    #[inline(always)]
    fn blocks<const P: usize, const B: usize>(
        &self,
        parts: &[Part<'_>],
        [first, step]: [usize; 2],
        skip: Skip<'_>,
        block: usize,
        output: &mut [f32],
    ) {
        let mut sums = [[[0.0; LANES]; B]; P];
        for sums in &mut sums {
            for (sums, biases) in sums.iter_mut().zip(&self.biases[block..]) {
                *sums = *biases;
            }
        }
        for part in parts {
            let weights = |b| &self.weights[(block + b) * self.depth..][part.weights.clone()];
            add_products(&mut sums, &part.numbers[first * step..], step, std::array::from_fn(weights));
        }
        for b in 0..B {
            self.finish(block + b, &sums, b, skip, output);
        }
    }

    /// Writes the sums `[p][b]` of a block. Branches once for all pixels.
    #[inline(always)]
    fn finish<const P: usize, const B: usize>(
        &self,
        block: usize,
        sums: &[[[f32; LANES]; B]; P],
        b: usize,
        skip: Skip<'_>,
        output: &mut [f32],
    ) {
        let first = block * LANES;
        let (written, added) = (self.channels - first, skip.channels.saturating_sub(first));
        let (output, stride) = (&mut output[first..], self.channels);
        if written >= LANES && added == 0 {
            for (p, sums) in sums.iter().enumerate() {
                output[p * stride..][..LANES].copy_from_slice(&self.finished(block, &sums[b], &[0.0; LANES]));
            }
        } else if written >= LANES && added >= LANES {
            for (p, sums) in sums.iter().enumerate() {
                let skip = lanes(&skip.numbers[p * skip.channels + first..][..LANES]);
                output[p * stride..][..LANES].copy_from_slice(&self.finished(block, &sums[b], &skip));
            }
        } else {
            for (p, sums) in sums.iter().enumerate() {
                let skip = &skip.numbers[p * skip.channels..][..skip.channels];
                let finished = self.finished(block, &sums[b], &lanes(skip.get(first..).unwrap_or_default()));
                let written = written.min(LANES);
                output[p * stride..][..written].copy_from_slice(&finished[..written]);
            }
        }
    }

    /// Adds the skip connection and applies the activation.
    #[inline(always)]
    fn finished(&self, block: usize, sums: &[f32; LANES], skip: &[f32; LANES]) -> [f32; LANES] {
        let mut finished = *sums;
        for ((sum, skip), slope) in finished.iter_mut().zip(skip).zip(&self.slopes[block]) {
            *sum = activated(*sum + skip, *slope);
        }
        finished
    }
}

/// `sums[p][b] += Σ_k weights[b][k] · numbers[p · step + k]`
#[inline(always)]
fn add_products<const P: usize, const B: usize>(
    sums: &mut [[[f32; LANES]; B]; P],
    numbers: &[f32],
    step: usize,
    weights: [&[[f32; LANES]]; B],
) {
    let depth = weights[0].len();
    let weights: [&[[f32; LANES]]; B] = std::array::from_fn(|b| &weights[b][..depth]);
    let pixels: [&[f32]; P] = std::array::from_fn(|p| &numbers[p * step..][..depth]);
    let mut local = *sums;
    let mut done = 0;
    while done + STEP <= depth {
        add_steps::<P, B, STEP>(&mut local, &pixels, &weights, done);
        done += STEP;
    }
    for k in done..depth {
        add_steps::<P, B, 1>(&mut local, &pixels, &weights, k);
    }
    *sums = local;
}

/// Adds `S` inputs, from `first` on.
#[inline(always)]
fn add_steps<const P: usize, const B: usize, const S: usize>(
    sums: &mut [[[f32; LANES]; B]; P],
    pixels: &[&[f32]; P],
    weights: &[&[[f32; LANES]]; B],
    first: usize,
) {
    let pixels: [&[f32; S]; P] = std::array::from_fn(|p| chunk(&pixels[p][first..]));
    let weights: [&[[f32; LANES]; S]; B] = std::array::from_fn(|b| chunk(&weights[b][first..]));
    for k in 0..S {
        for (sums, pixel) in sums.iter_mut().zip(pixels) {
            for (sums, weights) in sums.iter_mut().zip(weights) {
                for (sum, weight) in sums.iter_mut().zip(&weights[k]) {
                    *sum += pixel[k] * weight;
                }
            }
        }
    }
}

#[inline(always)]
fn chunk<T, const S: usize>(numbers: &[T]) -> &[T; S] {
    numbers.first_chunk().expect("invariant: the steps are within the depth")
}

/// The first eight numbers, padded with zeros.
#[inline(always)]
fn lanes(numbers: &[f32]) -> [f32; LANES] {
    match numbers.first_chunk() {
        Some(lanes) => *lanes,
        None => std::array::from_fn(|lane| numbers.get(lane).copied().unwrap_or_default()),
    }
}

fn in_lanes(numbers: &[f32]) -> Vec<[f32; LANES]> {
    numbers.chunks(LANES).map(lanes).collect()
}
