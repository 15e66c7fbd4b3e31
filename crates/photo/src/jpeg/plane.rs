//! Samples of one component.

use super::header::{Component, Frame, ZIGZAG};
use super::idct::{Block, write_flat, write_samples};

pub(crate) struct Plane {
    /// Width and height in samples, without block padding.
    pub(crate) size: [usize; 2],
    /// Number of blocks that cover `size`, horizontal and vertical.
    pub(crate) blocks: [usize; 2],
    /// Blocks per stored row: whole coded units.
    blocks_across: usize,
    samples: Vec<u8>,
    /// Coefficients of a progressive picture, one entry per block; otherwise empty.
    coefficients: Vec<[i16; 64]>,
    /// In zigzag order, fixed when the component's first scan begins.
    pub(crate) quantisation: Option<[i32; 64]>,
}

impl Plane {
    pub(crate) fn new(frame: &Frame, component: &Component) -> Self {
        let size = frame.samples(component);
        let [across, down] = [0, 1].map(|axis| frame.units()[axis] * component.sampling[axis]);
        let count = across * down;
        Self {
            size,
            blocks: size.map(|side| side.div_ceil(8)),
            blocks_across: across,
            samples: vec![0; 64 * count],
            coefficients: vec![[0; 64]; if frame.progressive { count } else { 0 }],
            quantisation: None,
        }
    }

    pub(crate) fn row(&self, y: usize) -> &[u8] {
        &self.samples[8 * self.blocks_across * y..][..self.size[0]]
    }

    pub(crate) fn coefficients(&mut self, [x, y]: [usize; 2]) -> &mut [i16; 64] {
        &mut self.coefficients[y * self.blocks_across + x]
    }

    pub(crate) fn write(&mut self, [x, y]: [usize; 2], block: &Block, flat: bool) {
        let stride = 8 * self.blocks_across;
        let out = &mut self.samples[8 * (y * stride + x)..];
        if flat { write_flat(block[0], out, stride) } else { write_samples(block, out, stride) }
    }

    /// Converts the coefficients of a progressive picture to samples.
    pub(crate) fn transform(&mut self) {
        let quantisation = self.quantisation.unwrap_or([0; 64]);
        for (block_index, coefficients) in std::mem::take(&mut self.coefficients).iter().enumerate() {
            let mut block = [0; 64];
            for (index, factor) in ZIGZAG.into_iter().map(usize::from).zip(quantisation) {
                block[index] = i32::from(coefficients[index]) * factor;
            }
            let flat = coefficients[1..].iter().all(|&coefficient| coefficient == 0);
            self.write([block_index % self.blocks_across, block_index / self.blocks_across], &block, flat);
        }
    }
}
