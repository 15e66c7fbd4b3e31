//! Inverse DCT, bit-exact with libjpeg's accurate integer version.
//!
//! Loeffler, Ligtenberg and Moschytz, "Practical fast 1-D DCT algorithms with 11 multiplications" (ICASSP 1989), with
//! 13-bit factors.

use std::num::Wrapping;

use crate::widest;

/// Dequantised coefficients, row by row. Damaged data may overflow; its samples are undefined.
pub(crate) type Block = [i32; 64];

type Number = Wrapping<i32>;

const FACTOR_BITS: usize = 13;
/// Extra fractional bits after the first pass.
const FIRST_PASS_BITS: usize = 2;

/// Writes the samples of a block to the start of `out`, with `stride` between rows.
pub(crate) fn write_samples(block: &Block, out: &mut [u8], stride: usize) {
    let samples = widest(
        #[inline(always)]
        || samples(block),
    );
    for (row, samples) in out.chunks_mut(stride).zip(samples.as_chunks::<8>().0) {
        row[..8].copy_from_slice(samples);
    }
}

#[inline(always)]
fn samples(block: &Block) -> [u8; 64] {
    let columns = transform::<{ FACTOR_BITS - FIRST_PASS_BITS }>(block);
    let rows = transform::<{ FACTOR_BITS + FIRST_PASS_BITS + 3 }>(&transposed(&columns));
    let mut samples = [0; 64];
    for (sample, value) in samples.iter_mut().zip(rows) {
        *sample = (value + 128).clamp(0, 255) as u8;
    }
    transposed(&samples)
}

/// Writes a block that has only a DC coefficient.
pub(crate) fn write_flat(first: i32, out: &mut [u8], stride: usize) {
    let sample = ((first.wrapping_add(4) >> 3).saturating_add(128)).clamp(0, 255) as u8;
    out.chunks_mut(stride).take(8).for_each(|row| row[..8].fill(sample));
}

#[inline(always)]
fn transposed<T: Copy + Default>(block: &[T; 64]) -> [T; 64] {
    let mut out = [T::default(); 64];
    for (y, row) in block.as_chunks::<8>().0.iter().enumerate() {
        for (x, &value) in row.iter().enumerate() {
            out[8 * x + y] = value;
        }
    }
    out
}

/// Transforms each column.
#[inline(always)]
fn transform<const SHIFT: usize>(block: &Block) -> Block {
    let mut out = [0; 64];
    for lane in 0..8 {
        let transformed = transform_one(std::array::from_fn(|k| Wrapping(block[8 * k + lane])));
        for (k, value) in transformed.into_iter().enumerate() {
            out[8 * k + lane] = ((value + Wrapping(1 << (SHIFT - 1))) >> SHIFT).0;
        }
    }
    out
}

#[inline(always)]
fn transform_one(x: [Number; 8]) -> [Number; 8] {
    let times = |value: Number, factor: i32| value * Wrapping(factor);
    let shared = times(x[2] + x[6], 4433);
    let (low, high) = (shared - times(x[6], 15137), shared + times(x[2], 6270));
    let (sum, difference) = ((x[0] + x[4]) << FACTOR_BITS, (x[0] - x[4]) << FACTOR_BITS);
    let even = [sum + high, difference + low, difference - low, sum - high];
    let (a, b, c, d) = (x[7] + x[1], x[5] + x[3], x[7] + x[3], x[5] + x[1]);
    let shared = times(c + d, 9633);
    let (a, b) = (times(a, -7373), times(b, -20995));
    let (c, d) = (shared - times(c, 16069), shared - times(d, 3196));
    let odd =
        [times(x[1], 12299) + a + d, times(x[3], 25172) + b + c, times(x[5], 16819) + b + d, times(x[7], 2446) + a + c];
    std::array::from_fn(|k| if k < 4 { even[k] + odd[k] } else { even[7 - k] - odd[7 - k] })
}
