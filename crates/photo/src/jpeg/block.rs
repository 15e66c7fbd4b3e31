//! The coefficients of one block (ITU-T T.81, F.2.2 and G.2). Data that no encoder writes is `None`.

use super::bits::Bits;
use super::header::ZIGZAG;
use super::huffman::{Huffman, signed};
use super::idct::Block;

/// What runs from block to block within a scan.
#[derive(Default)]
pub(crate) struct Run {
    /// The last first coefficient of each component of the scan.
    pub(crate) predictions: [i32; 4],
    /// Number of blocks to come whose band has ended.
    pub(crate) ended: u32,
}

/// Samples of 8 bits reach from -1024 to 1016, and what an encoder rounds to goes a little beyond.
const LARGEST_FIRST: u32 = 1280;

/// A first coefficient by its difference, checked against what 8-bit samples can have.
pub(crate) fn first(bits: &mut Bits<'_>, dc: &Huffman, prediction: &mut i32, scale: i32) -> Option<i32> {
    const MOST_BITS: u8 = 11;
    let size = dc.decode(bits).filter(|&size| size <= MOST_BITS)?;
    *prediction = prediction.wrapping_add(signed(bits, size.into()));
    let within = (prediction.unsigned_abs().saturating_sub(1)).saturating_mul(scale.unsigned_abs()) <= LARGEST_FIRST;
    within.then_some(*prediction)
}

/// A block of a sequential picture, dequantised; whether it has more than its first coefficient.
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
            let place = *ZIGZAG.get(k)?;
            block[usize::from(place)] = value * quantisation[k];
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
                let place = *ZIGZAG.get(k)?;
                block[usize::from(place)] = signed(bits, size) * quantisation[k];
                k += 1;
            }
        }
    }
    (k == 64).then_some(true)
}

/// The others of a band, in zigzag order.
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

/// One more bit of a band (T.81, G.1.2.3).
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

/// Refines the coefficients that are not zero up to the next one after so many that are; where that one is.
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
