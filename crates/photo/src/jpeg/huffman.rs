//! Huffman codes (ITU-T T.81, annex C and F.2.2.3).

use super::bits::Bits;

/// Codes of up to this many bits are decoded by table lookup.
const FAST_BITS: u32 = 10;

pub(crate) struct Huffman {
    /// Length and symbol for the next [`FAST_BITS`] bits; 0 if the code is longer.
    fast: [u16; 1 << FAST_BITS],
    /// Like `fast`, where the coefficient's value fits in the same bits: value, number of zeros before it (four bits)
    /// and total length (four bits).
    coefficients: [i16; 1 << FAST_BITS],
    /// For each length, the first 16-bit prefix too large for its codes.
    limit: [u32; 17],
    /// For each length, the offset from code to symbol index.
    offset: [i32; 17],
    symbols: [u8; 256],
}

impl Huffman {
    /// Builds the tables from the number of codes of each length and the symbols; `None` if the codes overflow.
    pub(crate) fn new(counts: &[u8; 16], listed: &[u8]) -> Option<Box<Self>> {
        let mut table = Box::new(Self {
            fast: [0; 1 << FAST_BITS],
            coefficients: [0; 1 << FAST_BITS],
            limit: [0; 17],
            offset: [0; 17],
            symbols: [0; 256],
        });
        table.symbols.get_mut(..listed.len())?.copy_from_slice(listed);
        let (mut code, mut index) = (0_u32, 0_usize);
        for (length, &count) in (1_u32..).zip(counts) {
            table.offset[length as usize] = index as i32 - code as i32;
            for _ in 0..count {
                table.list(code, length, *listed.get(index)?)?;
                (code, index) = (code + 1, index + 1);
            }
            table.limit[length as usize] = code << (16 - length);
            code <<= 1;
        }
        table.coefficients = std::array::from_fn(|bits| coefficient(bits as u32, table.fast[bits]));
        Some(table)
    }

    fn list(&mut self, code: u32, length: u32, symbol: u8) -> Option<()> {
        if code >> length != 0 {
            return None;
        }
        if length <= FAST_BITS {
            let first = (code << (FAST_BITS - length)) as usize;
            self.fast[first..first + (1 << (FAST_BITS - length))].fill((length as u16) << 8 | u16::from(symbol));
        }
        Some(())
    }

    /// Decodes the number of zeros and the next coefficient, if its code is short. Leaves at least 16 bits buffered.
    #[inline(always)]
    pub(crate) fn short_coefficient(&self, bits: &mut Bits<'_>) -> Option<(usize, i32)> {
        bits.refill();
        let entry = self.coefficients[(bits.peek() >> (16 - FAST_BITS)) as usize];
        if entry == 0 {
            return None;
        }
        bits.skip((entry & 15) as u32);
        Some((usize::from((entry >> 4 & 15) as u16), i32::from(entry >> 8)))
    }

    /// Decodes the next symbol; `None` if the bits are not a code. Leaves at least 16 bits buffered.
    #[inline(always)]
    pub(crate) fn decode(&self, bits: &mut Bits<'_>) -> Option<u8> {
        bits.refill();
        let next = bits.peek();
        let entry = self.fast[(next >> (16 - FAST_BITS)) as usize];
        if entry != 0 {
            bits.skip(u32::from(entry >> 8));
            return Some(entry as u8);
        }
        let length = (FAST_BITS + 1..=16).find(|&length| next < self.limit[length as usize])?;
        bits.skip(length);
        let index = (next >> (16 - length)) as i32 + self.offset[length as usize];
        Some(self.symbols[usize::try_from(index).ok()? & 0xFF])
    }
}

/// Entry of [`Huffman::coefficients`]; 0 if the code or value is too long.
fn coefficient(bits: u32, entry: u16) -> i16 {
    let (length, zeros, size) = (u32::from(entry >> 8), (entry >> 4 & 15) as i16, u32::from(entry & 15));
    if length == 0 || size == 0 || length + size > FAST_BITS {
        return 0;
    }
    let value = extended(bits >> (FAST_BITS - length - size) & ((1 << size) - 1), size);
    i16::try_from(value << 8).map_or(0, |value| value | zeros << 4 | (length + size) as i16)
}

/// Reads a signed number of `size` bits.
#[inline(always)]
pub(crate) fn signed(bits: &mut Bits<'_>, size: u32) -> i32 {
    extended(bits.take(size), size)
}

/// EXTEND of T.81, F.2.2.1.
#[inline(always)]
fn extended(value: u32, size: u32) -> i32 {
    let negative = value >> size.saturating_sub(1) == 0;
    value as i32 - if negative { (1 << size) - 1 } else { 0 }
}
