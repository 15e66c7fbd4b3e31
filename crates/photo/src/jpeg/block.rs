//! Decoding of one block's coefficients (ITU-T T.81, F.2.2 and G.2). Returns `None` for data that no encoder writes.

use super::bits::Bits;
use super::header::ZIGZAG;
use super::huffman::{Huffman, signed};
use super::idct::Block;

/// Decoder state carried from block to block within a scan.
#[derive(Default)]
pub(crate) struct Run {
    /// Last DC coefficient of each component of the scan.
    pub(crate) predictions: [i32; 4],
    /// Number of blocks left in the current end-of-band run.
    pub(crate) ended: u32,
}

/// Largest DC magnitude. 8-bit samples give -1024 to 1016; quantisation may round slightly beyond.
const LARGEST_FIRST: u32 = 1280;

/// Decodes a DC coefficient from its difference and checks it against the range of 8-bit samples.
pub(crate) fn first(bits: &mut Bits<'_>, dc: &Huffman, prediction: &mut i32, scale: i32) -> Option<i32> {
    const MOST_BITS: u8 = 11;
    let size = dc.decode(bits).filter(|&size| size <= MOST_BITS)?;
    *prediction = prediction.wrapping_add(signed(bits, size.into()));
    let within = (prediction.unsigned_abs().saturating_sub(1)).saturating_mul(scale.unsigned_abs()) <= LARGEST_FIRST;
    within.then_some(*prediction)
}

/// Decodes and dequantises a block of a sequential picture. Returns whether it has AC coefficients.
pub(crate) fn sequential(
    bits: &mut Bits<'_>,
    [dc, ac]: [&Huffman; 2],
    prediction: &mut i32,
    quantisation: &[i32; 64],
    block: &mut Block,
) -> Option<bool> {
    block[0] = first(bits, dc, prediction, quantisation[0])? * quantisation[0];
    let mut k = 1;
    while k < 64 {
        if let Some((zeros, value)) = ac.short_coefficient(bits) {
            k += zeros;
            let index = *ZIGZAG.get(k)?;
            block[usize::from(index)] = value * quantisation[k];
            k += 1;
            continue;
        }
        let symbol = ac.decode(bits)?;
        let (run, size) = (usize::from(symbol >> 4), u32::from(symbol & 15));
        match (run, size) {
            (15, 0) => k += 16,
            (_, 0) => return Some(k > 1),
            _ => {
                k += run;
                let index = *ZIGZAG.get(k)?;
                block[usize::from(index)] = signed(bits, size) * quantisation[k];
                k += 1;
            }
        }
    }
    (k == 64).then_some(true)
}

/// Decodes the first scan of a band of AC coefficients, in zigzag order.
pub(crate) fn band(
    bits: &mut Bits<'_>,
    ac: &Huffman,
    run: &mut Run,
    [first, last]: [usize; 2],
    low: u8,
    block: &mut [i16; 64],
) -> Option<()> {
    if run.ended > 0 {
        run.ended -= 1;
        return Some(());
    }
    let mut k = first;
    while k <= last {
        let symbol = ac.decode(bits)?;
        let (zeros, size) = (usize::from(symbol >> 4), u32::from(symbol & 15));
        match (zeros, size) {
            (15, 0) => k += 16,
            (zeros, 0) => {
                run.ended = (1 << zeros) - 1 + bits.take(zeros as u32);
                return Some(());
            }
            _ => {
                k += zeros;
                if k > last {
                    return None;
                }
                block[usize::from(ZIGZAG[k])] = (signed(bits, size) << low) as i16;
                k += 1;
            }
        }
    }
    (k == last + 1).then_some(())
}

/// Decodes one more bit of a band (T.81, G.1.2.3).
pub(crate) fn refine_band(
    bits: &mut Bits<'_>,
    ac: &Huffman,
    run: &mut Run,
    [first, last]: [usize; 2],
    low: u8,
    block: &mut [i16; 64],
) -> Option<()> {
    let mut k = first;
    while run.ended == 0 && k <= last {
        let symbol = ac.decode(bits)?;
        let zeros = u32::from(symbol >> 4);
        let new = match symbol & 15 {
            1 => Some(if bits.bit() { 1 } else { -1 } << low),
            0 if zeros == 15 => None,
            0 => {
                run.ended = (1 << zeros) + bits.take(zeros);
                break;
            }
            _ => return None,
        };
        k = refine(bits, zeros as usize, [k, last], low, block);
        if let Some(new) = new {
            *block.get_mut(usize::from(*ZIGZAG.get(k).filter(|_| k <= last)?))? = new;
        }
        k += 1;
    }
    if run.ended > 0 {
        refine(bits, usize::MAX, [k, last], low, block);
        run.ended -= 1;
    }
    Some(())
}

/// Refines non-zero coefficients, skipping `zeros` others. Returns the index of the next zero, or `last + 1`.
fn refine(bits: &mut Bits<'_>, mut zeros: usize, [first, last]: [usize; 2], low: u8, block: &mut [i16; 64]) -> usize {
    for k in first..=last {
        let value = &mut block[usize::from(ZIGZAG[k])];
        if *value == 0 {
            if zeros == 0 {
                return k;
            }
            zeros -= 1;
        } else if bits.bit() && *value & 1 << low == 0 {
            *value = value.wrapping_add(value.signum() << low);
        }
    }
    last + 1
}
